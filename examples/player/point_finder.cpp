// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "point_finder.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "dot/camera/depth_noise.hpp"
#include "dot/camera/pinhole.hpp"
#include "dot/frame/frame_store.hpp"
#include "dot/image/opencv.hpp"
#include "dot/kernel/dispatch.hpp"
#include "dot/points/select_object.hpp"

namespace player {
namespace {

using Select = dot::Selector<dot::Pinhole, dot::DepthNoise>;

std::vector<cv::Point> pixels_of(const dot::PointSet& points) {
  std::vector<cv::Point> pixels;
  for (std::size_t i = 0; i < points.u.size(); ++i)
    pixels.emplace_back(static_cast<int>(points.u[i]), static_cast<int>(points.v[i]));
  return pixels;
}

dot::ImageView<const std::uint8_t> view_of(const cv::Mat& mask) {
  return {mask.ptr<std::uint8_t>(), mask.cols, mask.rows, static_cast<std::ptrdiff_t>(mask.step[0])};
}

}  // namespace

struct PointFinder::Impl {
  dot::Pinhole camera;
  dot::Options options;
  dot::DepthNoise noise;
  const dot::kernel::Kernels& kernels;
  dot::FrameStore frames;
  dot::SelectionWorkspace workspace;
  dot::PointSet points;

  std::vector<cv::Point> of_object(const Select& select, const dot::Result& result, const dot::ObjectResult& object) {
    if (object.area < std::max(1, options.selection.min_object_pixels)) return {};
    const cv::Rect box(object.box[0], object.box[1], object.box[2], object.box[3]);
    const cv::Mat mask = dot::to_mat(result.ids)(box) == static_cast<double>(object.id);
    dot::select_object(select, {box.x, box.y, box.width, box.height}, view_of(mask), object.area, points);
    return pixels_of(points);
  }

  std::vector<cv::Point> of_background(const Select& select, const dot::Result& result) {
    // With a margin for ragged outlines.
    cv::Mat background = dot::to_mat(result.labels) == 0;
    cv::erode(background, background, cv::Mat::ones(9, 9, CV_8UC1));
    const dot::SelectionSettings& s = options.selection;
    dot::SelectionRegion region;
    region.box = {0, 0, background.cols, background.rows};
    region.mask = view_of(background);
    region.surface = select.inverse_depth;
    region.budget = s.background_points;
    region.radius = s.window_radius;
    region.min_gradient = s.min_gradient;
    points.clear();
    select(region, points);
    return pixels_of(points);
  }
};

PointFinder::PointFinder(const dot::Intrinsics& camera, const dot::Options& options)
    : impl_(std::make_unique<Impl>(
          Impl{dot::Pinhole(camera), options, {options.depth_noise, camera}, *dot::find_kernels(), {}, {}, {}})) {}

PointFinder::~PointFinder() = default;

std::map<std::uint32_t, std::vector<cv::Point>> PointFinder::find(const runner::SequenceFrame& frame,
                                                                  const dot::Result& result) {
  const dot::FramePtr data = impl_->frames.add(frame.frame(), dot::DepthBias{}, impl_->noise,
                                               {1, impl_->options.selection.max_depth}, impl_->kernels, dot::Threads{});
  const Select select{
      impl_->camera,    impl_->noise,  data->pyramid, data->inverse_depth().view(), impl_->options.selection,
      impl_->workspace, impl_->kernels};
  std::map<std::uint32_t, std::vector<cv::Point>> points;
  points[0] = impl_->of_background(select, result);
  for (const dot::ObjectResult& object : result.objects) {
    std::vector<cv::Point> found = impl_->of_object(select, result, object);
    if (!found.empty()) points[object.id] = std::move(found);
  }
  return points;
}

}  // namespace player
