// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include "dot/abi.hpp"
#include "dot/camera/intrinsics.hpp"
#include "dot/lie/so3.hpp"

/// @file
/// The members that a camera model needs to be used as a policy. For S = float and double, on a const camera:
///
///     // Pixel of X (metres, camera axes, X.z > 0). J, if given, gets its derivative by X, pixels per metre.
///     template <typename S>
///     Vector2<S> project(const Vector3<S>& X, Eigen::Matrix<S, 2, 3>* J = nullptr) const;
///
///     // The ray through a pixel, with z = 1.
///     template <typename S>
///     Vector3<S> unproject(const Vector2<S>& pixel) const;
///
///     // Whether p lies on or inside the outermost pixel centres, `border` pixels further in. False for NaN.
///     template <typename S>
///     bool contains(const Vector2<S>& p, S border) const;
///
///     // The camera of level `level` of a pyramid of 2x2 means, 0 being this one: a pixel u of this camera is at
///     // (u + 0.5) / 2^level - 0.5 there, and the image has `width() >> level` columns.
///     Camera at_level(int level) const;
///
///     int width() const;    // pixels
///     int height() const;   // pixels
///     const Intrinsics& intrinsics() const;
///
/// Pixel centres have integer coordinates. Models: camera/pinhole.hpp, camera/radtan.hpp.

DOT_BEGIN_NAMESPACE

/// A pixel, or another pair.
template <typename S>
using Vector2 = Eigen::Matrix<S, 2, 1>;

namespace camera_concept {

/// Whether Camera maps between rays and pixels in the number type S.
template <typename Camera, typename S, typename = void>
inline constexpr bool maps_pixels_v = false;

template <typename Camera, typename S>
inline constexpr bool maps_pixels_v<
    Camera, S,
    std::void_t<decltype(std::declval<const Camera&>().project(std::declval<const Vector3<S>&>())),
                decltype(std::declval<const Camera&>().project(std::declval<const Vector3<S>&>(),
                                                               std::declval<Eigen::Matrix<S, 2, 3>*>())),
                decltype(std::declval<const Camera&>().unproject(std::declval<const Vector2<S>&>())),
                decltype(std::declval<const Camera&>().contains(std::declval<const Vector2<S>&>(), S(0)))>> =
    std::is_same_v<decltype(std::declval<const Camera&>().project(std::declval<const Vector3<S>&>())), Vector2<S>>&&
        std::is_same_v<decltype(std::declval<const Camera&>().unproject(std::declval<const Vector2<S>&>())),
                       Vector3<S>>&&
            std::is_same_v<decltype(std::declval<const Camera&>().contains(std::declval<const Vector2<S>&>(), S(0))),
                           bool>;

/// Whether Camera has a size, levels and intrinsics.
template <typename Camera, typename = void>
inline constexpr bool has_size_v = false;

template <typename Camera>
inline constexpr bool has_size_v<Camera, std::void_t<decltype(std::declval<const Camera&>().at_level(0)),
                                                     decltype(std::declval<const Camera&>().width()),
                                                     decltype(std::declval<const Camera&>().height()),
                                                     decltype(std::declval<const Camera&>().intrinsics())>> =
    std::is_same_v<decltype(std::declval<const Camera&>().at_level(0)), Camera>&&
        std::is_same_v<decltype(std::declval<const Camera&>().width()), int>&&
            std::is_same_v<decltype(std::declval<const Camera&>().height()), int>&&
                std::is_same_v<decltype(std::declval<const Camera&>().intrinsics()), const Intrinsics&>;

}  // namespace camera_concept

/// Whether `Camera` has all members listed above. Use: `static_assert(is_camera_v<Camera>, DOT_CAMERA_MESSAGE)`.
template <typename Camera>
inline constexpr bool is_camera_v = camera_concept::maps_pixels_v<Camera, float>&&
    camera_concept::maps_pixels_v<Camera, double>&& camera_concept::has_size_v<Camera>;

DOT_END_NAMESPACE

/// The compiler's message for a camera that lacks a member.
#define DOT_CAMERA_MESSAGE "Camera must satisfy dot/camera/concept.hpp"
