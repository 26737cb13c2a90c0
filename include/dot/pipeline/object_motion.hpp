// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "dot/align/aligner.hpp"
#include "dot/align/minima.hpp"
#include "dot/motion/disparity.hpp"
#include "dot/motion/estimate.hpp"
#include "dot/motion/known_velocity.hpp"
#include "dot/motion/settings.hpp"
#include "dot/pipeline/result.hpp"

DOT_BEGIN_NAMESPACE

/// An object as a past frame saw it, and what has moved since.
struct ObjectReference {
  PointSet points;
  Vector3<double> centroid = Vector3<double>::Zero();  ///< of the points, camera axes of that frame, metres
  Vector3<double> anchor = Vector3<double>::Zero();    ///< centre of its mask at its median depth; zero: no depth
  int area = 0;                                        ///< pixels of its mask with its depth
  double timestamp = 0;                                ///< seconds
  int intervals = 0;                                   ///< frames since
  SE3d T_cur_ref;                                      ///< camera motion since then
  Matrix6<double> camera_covariance = Matrix6<double>::Zero();  ///< of T_cur_ref, left twist
  double gain = 1, offset = 0;                                  ///< of the image since then, the camera's
  SE3d T_obj_cur_ref;  ///< the object's points since then, camera and own motion composed

  /// Makes it one of this time, of which nothing is known but what `points` holds.
  void restart(double new_timestamp) {
    ObjectReference fresh;
    fresh.timestamp = new_timestamp;
    std::swap(fresh.points, points);
    *this = std::move(fresh);
  }

  /// The middle of the points.
  void centre() {
    double x = 0, y = 0, q = 0;
    for (std::size_t i = 0; i < points.u.size(); ++i) x += points.x[i], y += points.y[i], q += points.q[i];
    const double n = points.size();
    centroid = Vector3<double>(x / n, y / n, 1) / (q / n);
  }

  /// Another interval of the camera: its motion, with the covariance of the left twist, and the change of the image.
  void advance(const SE3d& T_c, const Matrix6<double>& covariance, double image_gain, double image_offset) {
    const Matrix6<double> Ad = T_c.adjoint();
    T_cur_ref = T_c * T_cur_ref;
    camera_covariance = Ad * camera_covariance * Ad.transpose() + covariance;
    gain *= image_gain;
    offset = image_gain * offset + image_offset;
    ++intervals;
  }
};

/// What a frame offers to an object's fit.
template <typename Camera>
struct ObjectScene {
  const Pyramid& image;
  const Camera& camera;
  const DepthPyramid& depth;             ///< of the frame
  ImageView<const std::uint8_t> hidden;  ///< non-zero where a nearer object was found already
};

/// One object's motion over one interval, with the reason where there is none.
struct ObjectFit {
  Reason reason = Reason::Diverged;
  SE3d T_o;                                         ///< reference camera's axes
  Matrix6<double> sigma = Matrix6<double>::Zero();  ///< Sigma_x: twist of T_o about the moved centroid, photometric
  double phi = 0;
  int n_points = 0, n_inliers = 0;
  MotionEstimate motion;

  bool ok() const { return reason == Reason::None; }

  /// The same motion forwards, of a fit to an image taken *before* the reference; in the axes of that image's camera.
  /// @param C camera motion from the reference to that image.
  ObjectFit reversed(const SE3d& C) const {
    ObjectFit out = *this;
    out.T_o = C * T_o.inverse() * C.inverse();
    Matrix6<double> turn = Matrix6<double>::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = C.R * T_o.R.transpose();
    out.sigma = turn * sigma * turn.transpose();
    out.motion.velocity = -(C.R * motion.velocity);
    out.motion.covariance = C.R * motion.covariance * C.R.transpose();
    return out;
  }
};

/// Motion T_o of an object with T_c fixed (paper, section 3.3, eq. 4-5), about its centroid, with a weak depth residual
/// beside the photometric one, chosen among several starts, checked, and with an honest covariance of its velocity.
struct ObjectMotionEstimator {
  ObjectSettings settings;
  MotionPriorSettings prior;
  VelocitySettings velocity;

  /// @param starts of T_o, in the reference camera's axes, the most trusted first; none where all lie behind the
  /// camera.
  template <typename Camera, typename Noise, typename Aligner>
  ObjectFit fit(const ObjectReference& reference, const ObjectScene<Camera>& scene, const std::vector<SE3d>& starts,
                const KnownVelocity& known, double dt, const Noise& noise, Aligner& aligner,
                MinimaWorkspace& workspace) const {
    ObjectFit out;
    const AlignProblem<Camera> problem = make_problem(reference, scene, dt, noise);
    if (reference.points.size() < settings.min_points) {
      out.reason = Reason::TooLittleTexture;
      return out;
    }

    // Levels on which the object still has some structure.
    int top = std::min(reference.points.levels, scene.image.size()) - 1;
    while (top > 0 && std::sqrt(1.0 * reference.area) / (1 << top) < 5) --top;
    out = best_minimum(problem, starts, starts.size(), top, reference, scene, known, dt, noise, aligner, workspace);
    // Coarse levels mix an object with what hides it and may lead away from where it is known to be.
    if (!out.ok() && known.seconds > 0 && top > kNearLevel && !starts.empty()) {
      const ObjectFit near =
          best_minimum(problem, starts, 1, kNearLevel, reference, scene, known, dt, noise, aligner, workspace);
      if (near.ok()) out = near;
    }
    return out;
  }

  /// Variance per axis of what the velocity over the last `dt` may differ from that over the whole `span` before: it
  /// may have changed since the middle of it, of traffic mostly by a third of `velocity.acceleration`.
  double variance_of_change(double span, double dt) const {
    const double changed = 0.5 * (0.3 * velocity.acceleration) * (span - dt);
    return changed * changed;
  }

  /// The share of the last frame interval, at constant velocity, of a fit to an older reference, in the axes of the
  /// previous camera.
  /// @param T_prev_ref camera motion from the reference to the previous frame; @param dt seconds since that frame.
  ObjectFit over_last_interval(const ObjectFit& fit, const SE3d& T_prev_ref, double dt) const {
    const double span = fit.motion.interval, share = dt / span;
    if (share > 1 - 1e-6) return fit;
    ObjectFit out = fit;
    out.T_o = T_prev_ref * SE3d::exp(share * fit.T_o.log()) * T_prev_ref.inverse();
    const Matrix3<double>& R = T_prev_ref.R;
    Matrix6<double> turn = Matrix6<double>::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = share * R;
    out.sigma = turn * fit.sigma * turn.transpose();
    out.motion.velocity = R * fit.motion.velocity;
    out.motion.covariance =
        R * fit.motion.covariance * R.transpose() + Matrix3<double>::Identity() * variance_of_change(span, dt);
    return out;
  }

  /// A motion that turns, about a point, no further than its fit is sure of. The fit weighs `motion_prior.rotation`
  /// against residuals that it takes for independent; with the covariance S that they really give and the prior P, the
  /// mean of both turns by P (P + S)^-1 w. Outlines need it: turned to and fro by the noise, the far ones fray.
  /// @param T_o in the axes of the fit. @param centre the point, before it moves. @param dt seconds.
  SE3d turned_surely(const SE3d& T_o, const ObjectFit& fit, const Vector3<double>& centre, double dt) const {
    const Matrix3<double> S = velocity.photometric_scale * fit.sigma.bottomRightCorner<3, 3>();
    const Matrix3<double> P = prior_information(dt).bottomRightCorner<3, 3>().inverse();
    const Matrix3<double> R = so3::exp(P * (P + S).ldlt().solve(so3::log(T_o.R)));
    return {R, T_o * centre - R * centre};
  }

  /// Adds to `starts`, of many velocities, those that fit best on a coarse level; for an object without history.
  template <typename Camera, typename Noise, typename Aligner>
  void search(const ObjectReference& reference, const ObjectScene<Camera>& scene, double dt, const Noise& noise,
              Aligner& aligner, MinimaWorkspace& workspace, std::vector<SE3d>& starts) const {
    if (reference.points.size() < settings.min_points) return;
    const AlignProblem<Camera> problem = make_problem(reference, scene, dt, noise);
    const int levels = std::min(reference.points.levels, scene.image.size());
    const int fine = std::min(2, levels - 1);
    // Traffic mostly goes where the camera does.
    starts.push_back(SE3d::translation(reference.T_cur_ref.inverse() * reference.centroid - reference.centroid));
    search(reference, scene, problem, fine, dt, 8, aligner, workspace, starts);
    // What is large may move by many pixels of that level between two frames: also on one where these are few, if the
    // object still has some structure there.
    const double focal = scene.camera.intrinsics().fx, half_size = 0.5 * std::sqrt(1.0 * reference.area);
    const double pixels = settings.search_speed * dt * focal / std::max(0.1, reference.centroid.z());
    int coarse = fine;
    while (coarse + 1 < levels && half_size > 6 << (coarse + 1) && pixels > 16 << coarse) ++coarse;
    if (coarse > fine) search(reference, scene, problem, coarse, dt, 16, aligner, workspace, starts);
  }

 private:
  static constexpr int kNearLevel = 2;            ///< from which a fit starts where it is not to go far
  static constexpr double kSteadySeconds = 0.25;  ///< for which depth errors change less than they are large

  /// Aligned from the first `count` starts, level `top` first: of the minima found the best that holds.
  template <typename Camera, typename Noise, typename Aligner>
  ObjectFit best_minimum(const AlignProblem<Camera>& problem, const std::vector<SE3d>& starts, std::size_t count,
                         int top, const ObjectReference& reference, const ObjectScene<Camera>& scene,
                         const KnownVelocity& known, double dt, const Noise& noise, Aligner& aligner,
                         MinimaWorkspace& workspace) const {
    ObjectFit out;
    const int fine = std::min(1, top);
    Minima& minima = workspace.minima;
    minima.found.clear();
    for (std::size_t i = 0; i < count; ++i)
      minima.add(problem,
                 aligner.align(problem, {problem.T_outer * starts[i], reference.gain, reference.offset}, top, fine));
    std::vector<Alignment>& candidates = minima.found;
    // Few points may agree by chance, and better than any others.
    const auto sees_few = [&](const Alignment& a) {
      return a.seen < settings.min_inliers || a.seen < 0.3 * settings.min_visible * reference.points.size();
    };
    minima.drop_if(sees_few);
    if (fine > 0)
      for (Alignment& a : candidates) a = aligner.align(problem, a.state, 0);
    // A later start must win by a margin: equal minima should not alternate.
    auto& order = workspace.ranked;
    order.clear();
    if (candidates.size() == 1) {
      order.push_back({0, 0});
    } else {
      double sigma = std::numeric_limits<double>::infinity();
      for (const Alignment& a : candidates) sigma = std::min(sigma, aligner.intensity_sigma(problem, a.state, 0));
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const double cost = aligner.rank(problem, candidates[i].state, 0, sigma) * (order.empty() ? 0.98 : 1);
        if (std::isfinite(cost)) order.push_back({cost, i});
      }
    }
    std::sort(order.begin(), order.end());
    // The best minimum that holds before the checks; the best of all says why there is none.
    out.reason = Reason::LeavesImage;
    for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), 4); ++i) {
      Alignment& a = candidates[order[i].second];
      aligner.finish(problem, a);
      ObjectFit attempt;
      fill(reference, a, problem, scene, dt, noise, attempt);
      attempt.reason = check(reference, a, attempt, known);
      if (i == 0 || attempt.ok()) out = attempt;
      if (attempt.ok()) break;
    }
    return out;
  }

  /// Adds the three best velocities of a grid on one level, up to `steps` to each side.
  template <typename Camera, typename Aligner>
  void search(const ObjectReference& reference, const ObjectScene<Camera>& scene, const AlignProblem<Camera>& problem,
              int level, double dt, int steps, Aligner& aligner, MinimaWorkspace& workspace,
              std::vector<SE3d>& starts) const {
    const AlignState still{problem.T_outer, reference.gain, reference.offset};
    const double sigma = aligner.intensity_sigma(problem, still, level);
    // Steps of two pixels of that level sideways; along the ray as far as makes the same change of scale at the border.
    const double z = std::max(0.1, reference.centroid.z()), reach = settings.search_speed * dt;
    const double focal = scene.camera.intrinsics().fx / (1 << level);
    const double half_size = std::max(2.0, 0.5 * std::sqrt(1.0 * reference.area) / (1 << level));
    const double side = std::max(2 * z / focal, reach / steps), along = std::max(z / half_size, reach / 6);
    auto& found = workspace.tried;
    found.clear();
    const int n = static_cast<int>(reach / side), m = static_cast<int>(reach / along);
    for (int k = -m; k <= m; ++k)
      for (int i = -n; i <= n; ++i) {
        const SE3d T_o = SE3d::translation(Vector3<double>(i * side, 0, k * along));
        const double cost = aligner.rank(problem, {problem.T_outer * T_o, still.gain, still.offset}, level, sigma);
        if (std::isfinite(cost)) found.push_back({cost, {T_o}});
      }
    keep_cheapest(found, 3);
    for (const auto& place : found) starts.push_back(place.second.T);
  }

  template <typename Camera, typename Noise>
  AlignProblem<Camera> make_problem(const ObjectReference& reference, const ObjectScene<Camera>& scene, double dt,
                                    const Noise& noise) const {
    AlignProblem<Camera> problem{reference.points, scene.image, scene.camera};
    problem.T_outer = reference.T_cur_ref;
    problem.centred = true;
    problem.centroid = reference.centroid;
    problem.prior = prior_information(dt);
    problem.photometry = {SE3d{}, reference.gain, reference.offset};
    problem.gain_information = 1 / (prior.gain * prior.gain);
    problem.offset_information = 1 / (prior.offset * prior.offset);
    problem.hidden_cost = 1;  // an inlier costs about 0.45, an outlier 3.7
    const double q = 1 / std::max(0.05, reference.centroid.z());
    const double pixel = noise.pixel(q), change = noise.change(q);
    problem.depth.inverse_depth = scene.depth.levels[0].view();
    problem.depth_pyramid = &scene.depth;
    problem.depth.hidden = scene.hidden;
    problem.depth.sigma = static_cast<float>(std::sqrt(pixel * pixel + change * change));
    // On an object the depth may be worse than on the background that taught its noise.
    problem.depth.agreement = static_cast<float>(3 * std::max(std::sqrt(pixel * pixel + change * change),
                                                              std::hypot(noise.prior_pixel(q), noise.prior_common(q))));
    // Neighbouring depths are not independent, and all share the change of the common error: together they are worth
    // N = 1 / (A_corr / area + change^2 / pixel^2) measurements.
    const double n = 1 / (45.0 / std::max(45, reference.area) + change * change / (pixel * pixel));
    problem.depth.weight = static_cast<float>(n / std::max(1, reference.points.size()));
    return problem;
  }

  Matrix6<double> prior_information(double dt) const {
    Matrix6<double> P = Matrix6<double>::Zero();
    const double t = 1 / std::pow(prior.velocity * dt, 2), r = 1 / std::pow(prior.rotation * dt, 2);
    P.diagonal() << t, t, t, r, r, r;
    if (prior.ground_vehicle) {
      // Up and down, pitch and roll: a tenth of what is free elsewhere.
      const Vector3<double> up = Vector3<double>(prior.up_x, prior.up_y, prior.up_z).normalized();
      const Matrix3<double> vertical = up * up.transpose();
      P.topLeftCorner<3, 3>() += 99 * t * vertical;
      P.bottomRightCorner<3, 3>() += 99 * r * (Matrix3<double>::Identity() - vertical);
    }
    return P;
  }

  template <typename Camera, typename Noise>
  void fill(const ObjectReference& reference, const Alignment& a, const AlignProblem<Camera>& problem,
            const ObjectScene<Camera>& scene, double dt, const Noise& noise, ObjectFit& out) const {
    const SE3d T_c = problem.T_outer;
    out.T_o = T_c.inverse() * a.state.T;
    out.sigma = a.covariance.topLeftCorner<6, 6>();
    out.phi = a.phi;
    out.n_points = a.inside;
    out.n_inliers = a.inliers;
    MotionEstimate& m = out.motion;
    const Vector3<double> moved = out.T_o * reference.centroid;
    m.velocity = (moved - reference.centroid) / dt;
    m.interval = dt;
    m.intervals = std::max(1, reference.intervals);
    m.range = moved.z();
    m.covariance = displacement_covariance(reference, a, moved, dt, noise) / (dt * dt) +
                   Matrix3<double>::Identity() * velocity.floor * velocity.floor;
    m.entropy = entropy(out.sigma);
    const DynamicDisparity d =
        dynamic_disparity(reference.points, scene.camera, T_c, out.T_o, reference.centroid, out.sigma);
    m.disparity_px = d.median_px;
    m.disparity_noise_px = d.noise_px;
  }

  /// V dt^2: photometric + depth errors that the object's points share, propagated through the fit (constant over the
  /// object, linear over it in u and v, and changing between the frames) + the camera's. An object whose measured depth
  /// scatters more about the prediction than the noise says has worse depth than the background that taught it: its
  /// depth errors are scaled by that.
  template <typename Noise>
  Matrix3<double> displacement_covariance(const ObjectReference& reference, const Alignment& a,
                                          const Vector3<double>& moved, double dt, const Noise& noise) const {
    const double q = 1 / std::max(0.05, reference.centroid.z());
    const double excess = std::clamp(a.depth_scatter / (1.2 * noise.pixel(q)), 1.0, 4.0);
    const double common = excess * noise.common(q), pixel = excess * noise.pixel(q);
    const double change = dt > kSteadySeconds ? std::max(common, noise.change(q)) : noise.change(q);
    Matrix3<double> V = velocity.photometric_scale * a.covariance.topLeftCorner<3, 3>();
    const auto add = [&](const Vector8& mode, double variance) {
      const Vector3<double> x = mode.head<3>();
      V += variance * x * x.transpose();
    };
    // What standing objects make most likely of the modes: paint and glass have worse depth than the background.
    add(a.depth_modes[0], 1.6 * common * common + 60 * pixel * pixel / std::max(60, reference.area));
    add(a.depth_modes[1], 0.06 * common * common);
    add(a.depth_modes[2], 0.06 * common * common);
    add(a.depth_modes[3], change * change);
    return V +
           camera_share(reference.camera_covariance, reference.T_cur_ref, Vector3<double>(reference.T_cur_ref * moved));
  }

  Reason check(const ObjectReference& reference, const Alignment& a, const ObjectFit& out,
               const KnownVelocity& known) const {
    if (!a.state.T.t.allFinite() || !out.motion.velocity.allFinite()) return Reason::Diverged;
    if (a.inside < settings.min_points || a.inside < settings.min_visible * reference.points.size())
      return Reason::LeavesImage;
    if (a.seen < settings.min_inliers || a.seen < 0.3 * a.inside) return Reason::Occluded;
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
