// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "dot/align/reduction.hpp"
#include "dot/camera/pinhole.hpp"
#include "dot/kernel/portable_kernels.hpp"
#if defined(DOT_COMPILED_KERNELS)
#include "dot/kernel/dispatch.hpp"
#endif

DOT_BEGIN_NAMESPACE

/// The reduction by the kernels of kernel/photometric.hpp for a pinhole camera. For any other camera it uses
/// SerialReduction. The two agree up to float rounding.
struct KernelReduction {
  const kernel::Kernels* kernels = &portable_kernels();  ///< never null

  /// Sets `out` to the residuals of all points on a pyramid level.
  template <typename Camera>
  void residuals(const PointSet& points, int level, const Camera& camera, const Image<std::uint8_t>& image,
                 const AlignState& state, const ResidualNoise& noise, const DepthTerm& depth,
                 PointResiduals& out) const {
    if constexpr (std::is_same_v<Camera, Pinhole>) {
      out.resize(static_cast<std::size_t>(points.size()));
      kernel::Depth measured;
      kernels->residuals(input(points, level, camera, image, state, noise, depth, nullptr, measured),
                         {out.r.data(), out.extra.data(), out.value.data(), out.r_depth.data(), out.visibility.data()});
    } else {
      SerialReduction::residuals(points, level, camera, image, state, noise, depth, out);
    }
  }

  /// As of SerialReduction, but quads are read, if they are given and the gradients are the image's.
  template <typename Camera>
  kernel::Costs costs(const PointSet& points, int level, const Camera& camera, const Image<std::uint8_t>& image,
                      const Quads* quads, const AlignState& state, const ResidualNoise& noise, const DepthTerm& depth,
                      PointResiduals& scratch) const {
    if constexpr (std::is_same_v<Camera, Pinhole>) {
      kernel::Depth measured;
      kernel::Input in = input(points, level, camera, image, state, noise, depth, nullptr, measured);
      in.level.quads = data(quads, image);
      kernel::Costs sums;
      kernels->costs(in, sums);
      return sums;
    } else {
      return SerialReduction::costs(points, level, camera, image, quads, state, noise, depth, scratch);
    }
  }

  /// As of SerialReduction, but quads are read, if they are given.
  template <typename Camera>
  kernel::Moments moments(const PointSet& points, int level, const Camera& camera, const Image<std::uint8_t>& image,
                          const Quads* quads, const AlignState& state, PointResiduals& scratch) const {
    if constexpr (std::is_same_v<Camera, Pinhole>) {
      kernel::Depth none;
      kernel::Input in = input(points, level, camera, image, state, {}, {}, nullptr, none);
      in.level.quads = data(quads, image);
      kernel::Moments sums;
      kernels->moments(in, sums);
      return sums;
    } else {
      return SerialReduction::moments(points, level, camera, image, quads, state, scratch);
    }
  }

  /// Sums H and g over the points that are not excluded. @param excluded one flag a point, or null. @param centre about
  /// which rotations are linearised, metres.
  template <typename Camera>
  NormalEquations linearize(const PointSet& points, int level, const Camera& camera, const Image<std::uint8_t>& image,
                            const AlignState& state, const ResidualNoise& noise, const DepthTerm& depth,
                            const std::uint8_t* excluded,
                            const Vector3<double>& centre = Vector3<double>::Zero()) const {
    if constexpr (std::is_same_v<Camera, Pinhole>) {
      kernel::Depth measured;
      kernel::Input in = input(points, level, camera, image, state, noise, depth, excluded, measured);
      for (int k = 0; k < 3; ++k) in.view.centre[k] = static_cast<float>(centre[k]);
      kernel::Sums sums;
      kernels->linearize(in, sums);
      NormalEquations out;
      out.H = Eigen::Map<const Matrix8>(sums.H);
      out.g = Eigen::Map<const Vector8>(sums.g);
      out.cost = sums.seen ? sums.cost / sums.seen : 0;
      out.seen = sums.seen;
      out.occluded = sums.occluded;
      out.inside = sums.seen + sums.occluded;
      for (std::size_t m = 0; m < out.modes.size(); ++m) out.modes[m] = Eigen::Map<const Vector8>(sums.modes[m]);
      return out;
    } else {
      return SerialReduction::linearize(points, level, camera, image, state, noise, depth, excluded, centre);
    }
  }

  /// The arguments of the kernels. The result borrows all arguments, including `measured`.
  static kernel::Input input(const PointSet& points, int level, const Pinhole& camera, const Image<std::uint8_t>& image,
                             const AlignState& state, const ResidualNoise& noise, const DepthTerm& depth,
                             const std::uint8_t* excluded, kernel::Depth& measured) {
    kernel::Input in;
    const auto l = static_cast<std::size_t>(level);
    kernel::Points& p = in.points;
    p.n = points.size();
    p.x = points.x.data(), p.y = points.y.data(), p.q = points.q.data(), p.sigma_q = points.sigma_q.data();
    p.intensity = points.intensity[l].data(), p.gu = points.gu[l].data(), p.gv = points.gv[l].data();
    p.u = points.u.data(), p.v = points.v.data();
    p.excluded = excluded;
    if (noise.gradient != GradientSource::Image && points.gu[l].size() != points.u.size())
      throw std::invalid_argument("points.gu must have a value for each point where its gradients are to be taken");
    in.gradient = noise.gradient;
    in.level = {image.row(0), image.width(), image.height(), image.width(), nullptr};
    const Intrinsics& k = camera.intrinsics();
    in.view.fx = static_cast<float>(k.fx), in.view.fy = static_cast<float>(k.fy);
    in.view.cx = static_cast<float>(k.cx), in.view.cy = static_cast<float>(k.cy);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) in.view.R[3 * r + c] = static_cast<float>(state.T.R(r, c));
      in.view.t[r] = static_cast<float>(state.T.t[r]);
    }
    in.view.gain = static_cast<float>(state.gain), in.view.offset = static_cast<float>(state.offset);
    in.noise = {noise.sigma_intensity * noise.sigma_intensity, noise.gradient_noise * noise.gradient_noise, noise.huber,
                noise.tukey};
    if (depth.inverse_depth.data) {
      measured.data = depth.inverse_depth.data;
      measured.width = depth.inverse_depth.width, measured.height = depth.inverse_depth.height;
      measured.stride = depth.inverse_depth.stride;
      measured.scale = std::ldexp(1.f, level - depth.level);
      measured.occluders = depth.occluders.data;
      measured.occluders_width = depth.occluders.width, measured.occluders_height = depth.occluders.height;
      measured.occluders_stride = depth.occluders.stride;
      measured.occluders_scale = std::ldexp(1.f, level);
      measured.occlusion_relative = depth.occlusion_relative;
      measured.occlusion_absolute = depth.occlusion_sigmas * depth.sigma;
      measured.sigma = depth.sigma, measured.weight = depth.weight;
      in.depth = &measured;
    }
    return in;
  }

 private:
  /// The quads, if they are of an image of that size and their offsets in bytes fit into 32 bits.
  static const unsigned char* data(const Quads* quads, const Image<std::uint8_t>& image) {
    constexpr double kMostPixels = 1 << 29;
    const bool fits = quads && quads->pixels.width() == image.width() && quads->pixels.height() == image.height() &&
                      1.0 * image.width() * image.height() < kMostPixels;
    return fits ? quads->pixels.row(0)->data() : nullptr;
  }
};

#if defined(DOT_COMPILED_KERNELS)
/// KernelReduction with the best kernels for the machine that it runs on. It is a separate type, so that translation
/// units built with and without the compiled library can be linked into one program.
struct DispatchedReduction : KernelReduction {
  DispatchedReduction() : KernelReduction{find_kernels()} {}
};
/// The reduction that an aligner has if none is named.
using DefaultReduction = DispatchedReduction;
#else
/// The reduction that an aligner has if none is named.
using DefaultReduction = KernelReduction;
#endif

DOT_END_NAMESPACE
