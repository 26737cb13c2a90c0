// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "dot/align/aligner.hpp"
#include "dot/camera/depth_noise.hpp"
#include "dot/image/convert.hpp"
#include "dot/points/select.hpp"

namespace dot::bench {

/// The camera's motion from frame to frame with the parts of the library, from the images to the pose: what an odometry
/// of one alignment a frame would do. Each frame is prepared once and serves twice, as the new one and as the
/// reference.
class WholeAlignment {
 public:
  SelectionSettings selection;
  DirectAligner<> aligner;
  bool finish = true;  ///< outliers, last refinement and statistics, as the pipeline has them

  WholeAlignment(const Pinhole& camera, const DepthNoise& noise) : camera_(camera), noise_(noise) {}

  /// Pyramid, inverse depth, points: everything about one frame.
  void prepare(const ImageRef& image, const ImageRef& depth) {
    std::swap(points_, reference_);
    build(image, depth);
    select();
  }
  void build(const ImageRef& image, const ImageRef& depth) {
    const kernel::Kernels& kernels = *aligner.reduction.kernels;
    pyramid_.build(image.width, image.height, GreyRows(image, grey_rows_),
                   pyramid_levels(image.width, image.height, aligner.settings.max_levels), kernels);
    depth_.build(image.width, image.height, InverseDepthRows(depth, selection.max_depth, kernels), 1, kernels);
  }
  void select() {
    const Selector<Pinhole, DepthNoise> selector{
        camera_, noise_, pyramid_, depth_.levels[0].view(), selection, workspace_, *aligner.reduction.kernels};
    points_.clear();
    SelectionRegion whole;
    whole.box = {0, 0, camera_.width(), camera_.height()};
    whole.surface = depth_.levels[0].view();
    whole.budget = selection.background_points, whole.radius = selection.window_radius;
    whole.min_gradient = selection.min_gradient;
    selector(whole, points_);
    selector.sample_intensities(points_);
  }

  /// Of the frame prepared last against the one before.
  Alignment align(const SE3d& start = {}) {
    const AlignProblem<Pinhole> problem{reference_, pyramid_, camera_};
    Alignment a = aligner.align(problem, {start}, std::min(reference_.levels, pyramid_.size()) - 1);
    if (finish) aligner.reject_outliers_and_refit(problem, a);
    return a;
  }

  const PointSet& points() const { return points_; }
  const Pyramid& pyramid() const { return pyramid_; }

 private:
  Pinhole camera_;
  DepthNoise noise_;
  Image<std::uint8_t> grey_rows_;
  Pyramid pyramid_;
  DepthPyramid depth_;
  SelectionWorkspace workspace_;
  PointSet points_, reference_;
};

}  // namespace dot::bench
