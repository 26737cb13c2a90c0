// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "dot/image/opencv.hpp"
#include "dot/points/select.hpp"

#include <opencv2/imgproc.hpp>

DOT_BEGIN_NAMESPACE

/// What became of the selection of an object's points.
struct ObjectPoints {
  int pixels_with_depth = 0;  ///< of the mask, on the object's surface
  float median_q = 0;         ///< 1/m
};

/// Points of one object: inside its eroded mask, within the object's own range of depth, away from what occludes it.
///
/// Masks are ragged and leak: of the mask's depths only those count that lie between its 20th and 80th percentile,
/// widened by what an object of this range and relief may extend. An object so far that its relief drowns in the depth
/// noise shares one plane, and so does one that has depth in less than a quarter of its pixels; the plane then serves
/// where nothing was measured too.
/// @param box of the mask in the frame; @param mask of the box's size, non-zero = object; @param area its pixels.
template <typename Camera, typename Noise>
ObjectPoints select_object(const Selector<Camera, Noise>& select, const Box& box, ImageView<const std::uint8_t> mask,
                           int area, PointSet& points) {
  points.clear();
  ObjectPoints out;
  const ImageView<const float> depth = select.inverse_depth;
  const int w = box.width, h = box.height;
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(area) / 4 + 1);
  const int step = area > 4000 ? 2 : 1;
  for (int y = 0; y < h; y += step)
    for (int x = 0; x < w; x += step)
      if (mask(x, y) && depth(box.x + x, box.y + y) > 0) values.push_back(depth(box.x + x, box.y + y));
  if (values.size() < 10) return out;
  const auto percentile = [&](double p) {
    const auto k = static_cast<std::ptrdiff_t>(p * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return values[static_cast<std::size_t>(k)];
  };
  const float far = percentile(0.2), near = percentile(0.8);
  out.median_q = percentile(0.5);
  const float z = 1 / out.median_q;
  const float widen = std::min(3.5f, 0.25f * z + (1 / far - 1 / near));
  const float slack = 4 * static_cast<float>(select.noise.pixel(out.median_q));
  const float q_min = 1 / (1 / far + widen) - slack;
  const float z_near = 1 / near - widen;
  const float q_max = (z_near > 0 ? 1 / z_near : 1e6f) + slack;
  for (const float q : values) out.pixels_with_depth += q >= q_min && q <= q_max;
  out.pixels_with_depth *= step * step;

  // Border of the mask, and surroundings of nearer things outside it.
  const int erosion = 1 + (area > 2500);
  cv::Mat inner;
  cv::Mat padded;
  cv::copyMakeBorder(mat(mask), padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::erode(padded, inner, cv::Mat::ones(2 * erosion + 1, 2 * erosion + 1, CV_8U), cv::Point(-1, -1), 1,
            cv::BORDER_CONSTANT, cv::Scalar(255));
  inner = inner(cv::Rect(1, 1, w, h));
  const int reach = 4;
  cv::Mat outside(h + 2 * reach, w + 2 * reach, CV_32F, cv::Scalar(0));
  for (int y = -reach; y < h + reach; ++y) {
    const int fy = box.y + y;
    if (fy < 0 || fy >= depth.height) continue;
    float* row = outside.ptr<float>(y + reach);
    for (int x = -reach; x < w + reach; ++x) {
      const int fx = box.x + x;
      if (fx < 0 || fx >= depth.width) continue;
      const bool in = x >= 0 && y >= 0 && x < w && y < h && mask(x, y);
      if (!in) row[x + reach] = depth(fx, fy);
    }
  }
  cv::Mat nearer;
  cv::dilate(outside, nearer, cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U));

  const DepthSupport on_surface{mask, box.x, box.y, q_min, q_max};
  bool flat = false;
  const auto accept = [&](int x, int y) {
    const int mx = x - box.x, my = y - box.y;
    if (!inner.at<std::uint8_t>(my, mx)) return false;
    const bool measured = depth(x, y) > 0;
    if (!measured && !flat) return false;
    const float q = measured ? depth(x, y) : out.median_q;
    if (q < q_min || q > q_max) return false;
    return nearer.at<float>(my + reach, mx + reach) <= 1.15f * q + slack;
  };

  const float sigma = static_cast<float>(select.noise.pixel(out.median_q));
  const double focal = 0.5 * (select.camera.intrinsics().fx + select.camera.intrinsics().fy);
  const double size = std::sqrt(static_cast<double>(area)) / focal * z;  // metres
  const double relief = 0.5 * size * out.median_q * out.median_q;        // in inverse depth
  PlaneFit plane;
  const int cu = box.x + w / 2, cv_ = box.y + h / 2;
  flat = relief < 1.2 * sigma && fit_plane(depth, cu, cv_, std::max(w, h) / 2 + 1, out.median_q, 5 * sigma,
                                           out.pixels_with_depth / 3, on_surface, plane);
  if (4 * out.pixels_with_depth < area) {  // too few depths for planes of its own: all that is known is where it is
    flat = true;
    plane.rms = static_cast<float>(relief);
    plane.inliers = 1;
  }
  if (flat) {
    // A tilt that the noise does not support would turn into spurious radial motion: keep the level.
    plane.du = plane.dv = 0;
    plane.q = out.median_q;
  }
  const int radius = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(area)) / 8), 3, 6);
  // Strong gradients carry the information; weak ones only where there are few of them.
  for (const double share : {1.0, 0.5}) {
    points.clear();
    select(box, select.settings.object_points, radius, share * select.settings.object_gradient, accept, on_surface,
           flat ? &plane : nullptr, cu, cv_, points);
    if (points.size() >= 60) break;
  }
  select.sample_intensities(points);
  return out;
}

DOT_END_NAMESPACE
