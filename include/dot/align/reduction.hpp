// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dot/abi.hpp"
#include "dot/align/align_state.hpp"
#include "dot/image/buffer.hpp"
#include "dot/image/pyramid.hpp"
#include "dot/image/quads.hpp"
#include "dot/kernel/photometric.hpp"
#include "dot/points/point_set.hpp"

/// @file
/// The photometric factor and its reduction: residuals of all points at one pose, and their normal equations.
///
/// Residual (paper eq. 3 and 5, made invariant to exposure): r = I_i(p') - a I_j(p) - b, with p' = Pi(T X), X the point
/// of reference j in camera axes and T = T_i_j. In inverse depth, X~ = q T X = R (x, y, 1) + q t.
/// Derivatives are taken for a left twist of T about a point c, T <- Tr(c) exp(xi) Tr(-c) T, with c and
/// xi = [translation; rotation] in the axes of camera i: dX~/dxi = [q I, -[X~ - q c]x]. If c is the middle of a
/// far object, the sums are well conditioned. If c is the camera, its translation and rotation look nearly alike.

DOT_BEGIN_NAMESPACE

/// Twist, gain and offset: [translation; rotation; a; b].
using Vector8 = Eigen::Matrix<double, 8, 1>;
/// Information or covariance of these.
using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// The term of the measured depth of the new frame (objects only).
struct DepthTerm {
  ImageView<const float> inverse_depth;     ///< of the new frame, 0 = none; empty = term not used
  ImageView<const std::uint8_t> occluders;  ///< non-zero: a nearer object covers the pixel; may be empty
  float occlusion_relative = 0.15f;         ///< a measured surface nearer by this share hides the point,
  float occlusion_sigmas = 6;               ///< if the difference also exceeds this many sigma
  int level = 0;                            ///< pyramid level of inverse_depth; `occluders` is of level 0
  float sigma = 0;                          ///< of the difference measured - predicted, 1/m
  float agreement = 0;                      ///< difference within which the two agree, 1/m
  float weight = 0;                         ///< of one point's depth residual
};

/// Noise model of a reduction, and the source of its gradients: s^2 = sigma_I^2 + (dr/dq sigma_q)^2 + (gradient_noise
/// |grad I|)^2.
struct ResidualNoise {
  float sigma_intensity = 5;                        ///< grey values
  float gradient_noise = 0.06f;                     ///< pixels: AlignSettings::gradient_noise
  float huber = 1.345f;                             ///< in sigma: AlignSettings::huber
  float tukey = 4.685f;                             ///< in sigma: AlignSettings::tukey
  GradientSource gradient = GradientSource::Image;  ///< AlignSettings::gradient
};

/// Residuals at a pose: structure of arrays with one value per point, zero if the point is not seen.
struct PointResiduals {
  Buffer<float> r;                  ///< grey values
  Buffer<float> extra;              ///< variance besides sigma_I^2
  Buffer<float> value;              ///< I_i(p')
  Buffer<float> r_depth;            ///< measured minus predicted inverse depth, 1/m
  Buffer<std::uint8_t> visibility;  ///< a sum of kernel::kSeen, kHasDepth, kOccluded

  /// Number of points.
  std::size_t size() const { return r.size(); }
  /// Sets the number of points. The contents are unspecified afterwards.
  void resize(std::size_t n) {
    for (Buffer<float>* a : {&r, &extra, &value, &r_depth}) a->resize(n);
    visibility.resize(n);
  }
  /// Whether the point is inside the image and nothing hides it.
  bool seen(std::size_t i) const { return visibility[i] & kernel::kSeen; }
  /// Whether the point is seen and its depth there was measured.
  bool has_depth(std::size_t i) const { return visibility[i] & kernel::kHasDepth; }
  /// Whether something nearer hides the point.
  bool occluded(std::size_t i) const { return visibility[i] & kernel::kOccluded; }
};

/// Sums over the points.
struct NormalEquations {
  Matrix8 H = Matrix8::Zero();  ///< of [xi; a; b]
  Vector8 g = Vector8::Zero();  ///< gradient, sum of w J r / s^2
  double cost = 0;              ///< Huber, mean over seen points
  int seen = 0;                 ///< points that count in the sums
  int occluded = 0;             ///< points behind something nearer
  int inside = 0;               ///< seen or occluded
  /// Gradient of a depth error of the points that is constant over the region or grows linearly over it
  /// (sum of w J (dr/dq) m / s^2 for the modes m = 1, and u, v over the half extent), and of a change of that error
  /// between the two frames.
  std::array<Vector8, 4> modes{Vector8::Zero(), Vector8::Zero(), Vector8::Zero(), Vector8::Zero()};
};

/// The readable reference implementation: one point after the other, for any camera. A faster one
/// (align/kernel_reduction.hpp) has the same functions.
struct SerialReduction {
  /// Residuals at `state`, without derivatives.
  template <typename Camera>
  static void residuals(const PointSet& points, int level, const Camera& camera, const Image<std::uint8_t>& image,
                        const AlignState& state, const ResidualNoise& noise, const DepthTerm& depth,
                        PointResiduals& out);

  /// Tukey's costs of the points that are seen at `state`. @param quads of the image, or null; a faster reduction may
  /// read them instead. @param scratch contents unspecified afterwards.
  template <typename Camera>
  static kernel::Costs costs(const PointSet& points, int level, const Camera& camera, const Image<std::uint8_t>& image,
                             const Quads* quads, const AlignState& state, const ResidualNoise& noise,
                             const DepthTerm& depth, PointResiduals& scratch);

  /// Moments of the intensities of the points that are seen at `state`, in the reference and in the image. The other
  /// parameters are as above.
  template <typename Camera>
  static kernel::Moments moments(const PointSet& points, int level, const Camera& camera,
                                 const Image<std::uint8_t>& image, const Quads* quads, const AlignState& state,
                                 PointResiduals& scratch);

  /// Normal equations at `state`. A non-zero `excluded[i]` leaves a point out; `excluded` may be null. `centre` is c,
  /// metres.
  template <typename Camera>
  static NormalEquations linearize(const PointSet& points, int level, const Camera& camera,
                                   const Image<std::uint8_t>& image, const AlignState& state,
                                   const ResidualNoise& noise, const DepthTerm& depth, const std::uint8_t* excluded,
                                   const Vector3<double>& centre = Vector3<double>::Zero());
};

DOT_END_NAMESPACE

#include "dot/align/impl/serial_reduction.hpp"
