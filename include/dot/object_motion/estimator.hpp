// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "dot/align/minima.hpp"
#include "dot/align/sharper_image.hpp"
#include "dot/motion/disparity.hpp"
#include "dot/motion/known_velocity.hpp"
#include "dot/object_motion/displacement_covariance.hpp"
#include "dot/object_motion/first_fit.hpp"
#include "dot/object_motion/fit.hpp"
#include "dot/object_motion/problem.hpp"
#include "dot/object_motion/settings.hpp"
#include "dot/object_motion/velocity_search.hpp"

DOT_BEGIN_NAMESPACE

/// Estimates the motion T_o of an object about its centroid, with T_c fixed (paper, section 3.3, eq. 4-5). A weak depth
/// residual is added to the photometric one. The fit starts from several places, is checked, and gives a consistent
/// covariance of the velocity.
struct ObjectMotionEstimator {
  ObjectSettings settings;    ///< conditions for accepting a motion, and the range of the search
  MotionPriorSettings prior;  ///< how objects move
  VelocitySettings velocity;  ///< scales and floor of the velocity's covariance

  /// @param starts of T_o, in the reference camera's axes, the most trusted first; empty if all lie behind the camera.
  /// @param coarsest level that the alignment may start on.
  template <typename Camera, typename Noise, typename Aligner>
  ObjectFit fit(const ReferencePair& pair, const ObjectScene<Camera>& scene, const std::vector<SE3d>& starts,
                const KnownVelocity& known, const Noise& noise, Aligner& aligner, MinimaWorkspace& workspace,
                int coarsest = PointSet::kMaxLevels) const {
    const ObjectReference& reference = pair.reference;
    ObjectFit out;
    if (reference.points.size() < settings.min_points) {
      out.reason = Reason::TooLittleTexture;
      return out;
    }
    const AlignProblem<Camera> problem = object_problem(pair, scene, prior, noise);

    int top = std::min({reference.points.levels - 1, scene.image.size() - 1, coarsest});
    while (top > 0 && std::sqrt(1.0 * reference.area) / (1 << top) < kLeastSize) --top;
    out = best_minimum(pair, problem, starts, starts.size(), top, known, noise, aligner, workspace);
    // Coarse levels mix an object with its occluder. They may lead the fit away from the known place.
    if (!out.ok() && known.seconds > 0 && top > kNearLevel && !starts.empty()) {
      const ObjectFit near = best_minimum(pair, problem, starts, 1, kNearLevel, known, noise, aligner, workspace);
      if (near.ok()) out = near;
    }
    return out;
  }

  /// Tries many velocities on a coarse level and adds the best to `starts`. For an object without history.
  template <typename Camera, typename Noise, typename Aligner>
  void search(const ReferencePair& pair, const ObjectScene<Camera>& scene, const Noise& noise, Aligner& aligner,
              MinimaWorkspace& workspace, std::vector<SE3d>& starts) const {
    if (pair.reference.points.size() < settings.min_points) return;
    VelocitySearch{settings.search_speed}.find(pair, object_problem(pair, scene, prior, noise), aligner, workspace,
                                               starts);
  }

 private:
  static constexpr int kNearLevel = 2;       ///< first level of a fit that must stay near its start
  static constexpr double kLeastSize = 5;    ///< pixels of a level; a smaller object has no structure there
  static constexpr double kLeastSeen = 0.3;  ///< share of the points inside the image that must be seen
  static constexpr double kFirstsMargin =
      0.98;  ///< factor on the cost of the first start, so that equal minima do not alternate
  static constexpr std::size_t kTried = 4;      ///< number of minima that are checked
  static constexpr std::size_t kFewStarts = 2;  ///< so many starts are all aligned
  /// Cost of a start over the least one on the coarsest level, up to which it is aligned. An inlier costs about .45, an
  /// outlier 3.7. So starts are left out only if most points fit the best one, and hardly any fits them.
  static constexpr double kMostCostRatio = 4;

  /// Aligns from the first `count` starts, level `top` first, and returns the best minimum that passes the checks.
  template <typename Camera, typename Noise, typename Aligner>
  ObjectFit best_minimum(const ReferencePair& pair, const AlignProblem<Camera>& problem,
                         const std::vector<SE3d>& starts, std::size_t count, int top, const KnownVelocity& known,
                         const Noise& noise, Aligner& aligner, MinimaWorkspace& workspace) const {
    const int points = pair.reference.points.size();
    ObjectFit out;
    const int fine = std::min(1, top);
    Minima& minima = workspace.minima;
    minima.found.clear();
    // A few points may agree by chance, and then better than any other minimum.
    const auto sees_few = [&](const Alignment& a) {
      return a.seen < settings.min_inliers || a.seen < kLeastSeen * settings.min_visible * points;
    };
    auto& tried = workspace.tried;
    tried.clear();
    for (std::size_t i = 0; i < count; ++i)
      tried.push_back({0, {problem.T_outer * starts[i], pair.camera.gain, pair.camera.offset}});
    // Without a known velocity there are many starts, and most are wrong.
    double highest = 0;
    if (count > kFewStarts && !(known.seconds > 0)) {
      const double sigma = aligner.intensity_sigma(problem, tried.front().second, top);
      double least = std::numeric_limits<double>::infinity();
      for (auto& [cost, start] : tried) least = std::min(least, cost = aligner.tukey_cost(problem, start, top, sigma));
      highest = std::max(kNegligibleCost, kMostCostRatio * least);
    }
    for (const auto& [cost, start] : tried) {
      if (cost > highest) continue;
      // Less than a pixel of the coarsest level away from a minimum, a start nearly always leads to that minimum.
      const auto leads_to = [&, &from = start.T](const Alignment& found) {
        return found.converged && !sees_few(found) &&
               is_near(problem.points, problem.camera, from, found.state.T, 1 << top);
      };
      if (std::none_of(minima.found.begin(), minima.found.end(), leads_to))
        minima.add(problem, aligner.align(problem, start, top, fine));
    }
    std::vector<Alignment>& candidates = minima.found;
    minima.drop_if(sees_few);
    if (fine > 0)
      for (Alignment& a : candidates) a = aligner.align(problem, a.state, 0);
    rank(problem, candidates, aligner, workspace);
    // Takes the best minimum that passes the checks. If none does, the best of all gives the reason.
    out.reason = Reason::LeavesImage;
    const auto& order = workspace.ranked;
    for (std::size_t i = 0; i < std::min(order.size(), kTried); ++i) {
      Alignment& a = candidates[order[i].second];
      aligner.reject_outliers_and_refit(problem, a, fine > 0 && candidates.size() == 1);
      ObjectFit attempt = fit_of(pair, problem, a, noise, aligner.settings);
      attempt.motion.is_doubtful = !(known.seconds > 0) && FirstFit::is_doubtful(attempt, i == 0, prior);
      attempt.reason = check(points, a, attempt, known);
      if (i == 0 || attempt.ok()) out = attempt;
      if (attempt.ok()) break;
    }
    return out;
  }

  /// Sets workspace.ranked, the best first. A later start must be better than the first by a margin.
  template <typename Camera, typename Aligner>
  void rank(const AlignProblem<Camera>& problem, const std::vector<Alignment>& candidates, Aligner& aligner,
            MinimaWorkspace& workspace) const {
    auto& order = workspace.ranked;
    order.clear();
    if (candidates.size() == 1) {
      order.push_back({0, 0});
      return;
    }
    double sigma = std::numeric_limits<double>::infinity();
    for (const Alignment& a : candidates) sigma = std::min(sigma, aligner.intensity_sigma(problem, a.state, 0));
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double cost =
          aligner.tukey_cost(problem, candidates[i].state, 0, sigma) * (order.empty() ? kFirstsMargin : 1);
      if (std::isfinite(cost)) order.push_back({cost, i});
    }
    std::sort(order.begin(), order.end());
  }

  template <typename Camera, typename Noise>
  ObjectFit fit_of(const ReferencePair& pair, const AlignProblem<Camera>& problem, const Alignment& a,
                   const Noise& noise, const AlignSettings& align) const {
    const ObjectReference& reference = pair.reference;
    const double dt = pair.seconds;
    const SE3d T_c = problem.T_outer;
    ObjectFit out;
    out.T_o = T_c.inverse() * a.state.T;
    out.sigma = a.covariance.topLeftCorner<6, 6>();
    out.phi = a.phi;
    out.n_points = a.inside;
    out.n_inliers = a.inliers;
    MotionEstimate& m = out.motion;
    const Vector3<double> moved = out.T_o * reference.centroid;
    m.velocity = (moved - reference.centroid) / dt;
    m.span_seconds = dt;
    m.span_frames = std::max(1, pair.camera.intervals);
    m.range = moved.z();
    const double sharper =
        SharperImage::variance_factor(problem.points, problem.image.levels[0], problem.camera, a, align);
    const DisplacementCovariance displacement = displacement_covariance(pair, a, moved, velocity, noise, sharper);
    const Matrix6<double> V = displacement.all / (dt * dt);
    const double floor = velocity.floor_at(m.range);
    m.covariance = V.topLeftCorner<3, 3>() + Matrix3<double>::Identity() * floor * floor;
    m.depth_covariance = displacement.of_depth.topLeftCorner<3, 3>() / (dt * dt);
    const Matrix3<double> K = without_prior(out.sigma.bottomRightCorner<3, 3>(), prior, dt);
    m.angular_velocity = K * so3::log(out.T_o.R) / dt;
    m.angular_covariance = velocity.rotation_scale * K * V.bottomRightCorner<3, 3>() * K.transpose();
    m.inertia = reference.inertia;
    m.entropy = entropy(out.sigma);
    const DynamicDisparity d =
        dynamic_disparity(reference.points, problem.camera, T_c, out.T_o, reference.centroid, out.sigma);
    m.disparity_px = d.median_px;
    m.disparity_noise_px = d.noise_px;
    return out;
  }

  Reason check(int points, const Alignment& a, const ObjectFit& out, const KnownVelocity& known) const {
    if (!a.state.T.t.allFinite() || !out.motion.velocity.allFinite()) return Reason::Diverged;
    if (a.inside < settings.min_points || a.inside < settings.min_visible * points) return Reason::LeavesImage;
    if (a.seen < settings.min_inliers || a.seen < kLeastSeen * a.inside) return Reason::Occluded;
    if (!has_covariance(a) || !out.motion.covariance.allFinite()) return Reason::Diverged;
    const bool expected = known.seconds > 0 && !known.contradicts(out.motion, settings.max_acceleration);
    if (a.phi < (expected ? settings.min_phi_expected : settings.min_phi)) return Reason::LowCorrelation;
    if (a.inliers < settings.min_inliers || a.inliers < settings.min_inlier_share * a.seen)
      return Reason::TooFewInliers;
    if (a.with_depth >= settings.min_inliers && a.depth_agrees < settings.min_depth_agreement * a.with_depth)
      return Reason::DepthDisagrees;
    if (out.motion.velocity.norm() > settings.max_speed || known.contradicts(out.motion, settings.max_acceleration))
      return Reason::Implausible;
    return Reason::None;
  }
};

DOT_END_NAMESPACE
