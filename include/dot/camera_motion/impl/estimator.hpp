// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// Definitions of camera_motion/estimator.hpp, which includes this file.

DOT_BEGIN_NAMESPACE

/// The steps of `estimate`, in their order, and what they share. The minima that they find are in workspace.minima.
template <typename Camera, typename Aligner>
struct CameraMotionEstimator::Estimation {
  const CameraMotionEstimator& estimator;
  const AlignProblem<Camera>& problem;
  const std::vector<SE3d>& predicted;
  const CameraSearch* search;
  const MotionEvidence& evidence;
  Aligner& aligner;
  MinimaWorkspace& workspace;

  AlignProblem<Camera> few{workspace.few, problem.image, problem.camera};  ///< a part of the points, to rank places
  int top = std::min(problem.points.levels, problem.image.size()) - 1;     ///< coarsest level
  int fine = std::min(1, top);  ///< minima are compared on the second finest; only the remaining are refined further
  double depth = median_depth(problem.points, workspace.depths);
  AlignState first{};               ///< minimum that the most trusted prediction leads to
  bool turns_as_predicted = false;  ///< whether the minimum of any prediction has its rotation

  Minima& minima() const { return workspace.minima; }

  AlignState add(const AlignState& start, int coarsest) {
    const Alignment a = aligner.align(problem, start, coarsest, fine);
    minima().add(problem, a);
    return a.state;
  }

  void add_near(const AlignState& start) { minima().add(problem, aligner.align_near(problem, start, fine)); }

  void add_predicted() {
    for (std::size_t i = 0; i < predicted.size(); ++i) {
      const AlignState found = add({predicted[i]}, top);
      if (i == 0) first = found;
      if (!UnexpectedTurn::is_in(problem.points, problem.camera, found.T, predicted[i])) turns_as_predicted = true;
      add_near({predicted[i], found.gain, found.offset});
    }
  }

  /// A part of the points finds the minimum, all of them measure it.
  void add_standing() {
    if (!(predicted.back().log().norm() > 1e-3)) return;
    const AlignState stands{SE3d{}, first.gain, first.offset};
    add(aligner.align(few, stands, top, fine).state, fine);
  }

  void add_turned() {
    if (turns_as_predicted || !evidence.turns) return;
    const double sigma = aligner.intensity_sigma(few, first, CameraSearch::level_of(top + 1));
    UnexpectedTurn::find(*evidence.turns, few, predicted.back() * evidence.T_points_prev,
                         evidence.T_points_prev.inverse(), sigma, fine, aligner, workspace);
    for (const AlignState& start : workspace.starts) {
      add(aligner.align(few, start, CameraSearch::level_of(top + 1), fine).state, fine);
      add_near(start);
    }
  }

  void add_searched() {
    const double sigma = aligner.intensity_sigma(problem, first, CameraSearch::level_of(top + 1));
    search->find(few, depth, sigma, aligner, workspace);
    search->align_starts(few, fine, sigma, CameraSearch::kThorough, aligner, workspace,
                         [&](const Alignment& a) { minima().add(problem, a, kSameFine); });
  }

  /// Drops minima that see fewer points than `enough`: a few may agree by chance, and then better than others. Without
  /// contrast or far off, all may agree.
  void drop_meaningless(int enough) {
    const auto far_off = [&](const SE3d& T) {
      return std::none_of(predicted.begin(), predicted.end(),
                          [&](const SE3d& other) { return search->reaches(T * other.inverse()); });
    };
    minima().drop_if([&](const Alignment& a) {
      return a.seen < enough || a.state.gain < kMinGain || (search && far_off(a.state.T));
    });
  }

  /// Grey values, of the minimum that fits best.
  double least_sigma() const {
    double sigma = std::numeric_limits<double>::infinity();
    for (const Alignment& a : minima().found) sigma = std::min(sigma, aligner.intensity_sigma(problem, a.state, fine));
    return sigma;
  }

  /// Of the minima that a search found, keeps the best, and adds the motion that explains the rest of the points.
  void keep_best_and_second(double sigma) {
    estimator.keep_best(few, fine, sigma, aligner, workspace);
    const auto second = SecondMotion::find(few, minima().found.front().state, *search, evidence, depth, fine, sigma,
                                           aligner, workspace);
    for (Alignment& a : minima().found) a = aligner.align(problem, a.state, fine, fine);
    if (second) add_near(*second);
  }

  /// With a known velocity, minima that cost much more than the best one have no better ones beside them either.
  void add_shifted(double sigma) {
    const std::size_t unshifted = minima().found.size();
    const auto cost_of = [&](const Alignment& a) { return aligner.tukey_cost(few, a.state, fine, sigma); };
    double lowest = std::numeric_limits<double>::infinity();
    if (!search)
      for (const Alignment& a : minima().found) lowest = std::min(lowest, cost_of(a));
    const AlignProblem<Camera> scanned = search ? CameraSearch::part_of(few, CameraSearch::kScanned, workspace) : few;
    for (std::size_t i = 0; i < unshifted; ++i) {
      if (!search && cost_of(minima().found[i]) > kMostCostRatio * lowest) continue;
      estimator.shifted(scanned, minima().found[i], fine, sigma, depth, aligner, workspace);
      for (const AlignState& start : workspace.starts) add_near(start);
    }
  }

  /// Refines the minima on the finest level, and chooses among them.
  Alignment choose() {
    std::vector<Alignment>& candidates = minima().found;
    if (fine > 0)
      for (Alignment& a : candidates) a = aligner.align_near(problem, a.state, 0);
    if (candidates.size() == 1) {
      aligner.reject_outliers_and_refit(problem, candidates[0], fine > 0);
      return candidates[0];
    }
    const MotionChoice choice(problem, candidates, predicted.back(), evidence, estimator.settings, aligner, workspace);
    Alignment& chosen = candidates[choice.chosen];
    if (choice.rival) return estimator.refined(choice, problem, candidates, aligner, workspace);
    aligner.reject_outliers_and_refit(problem, chosen);
    return chosen;
  }
};

template <typename Camera, typename Aligner>
Alignment CameraMotionEstimator::estimate(const PointSet& points, const Pyramid& image, const Camera& camera,
                                          const std::vector<SE3d>& predicted, const CameraSearch* search,
                                          const MotionEvidence& evidence, Aligner& aligner,
                                          MinimaWorkspace& workspace) const {
  const AlignProblem<Camera> problem{points, image, camera};
  workspace.minima.found.clear();
  Estimation<Camera, Aligner> steps{*this, problem, predicted, search, evidence, aligner, workspace};
  steps.add_predicted();
  workspace.few.take_every(std::max(1, points.size() / (search ? kSearched : kRanked)), points);
  steps.add_standing();
  if (search)
    steps.add_searched();
  else
    steps.add_turned();
  steps.drop_meaningless(search ? std::min(settings.min_points, kEnoughRanked) : settings.min_points);
  const double sigma = steps.least_sigma();
  if (search) steps.keep_best_and_second(sigma);
  steps.add_shifted(sigma);
  steps.drop_meaningless(settings.min_points);
  return steps.choose();
}

DOT_END_NAMESPACE
