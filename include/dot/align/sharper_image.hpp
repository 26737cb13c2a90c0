// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "dot/align/residual_sums.hpp"

DOT_BEGIN_NAMESPACE

/// An image that is sharper than the one its reference was taken from: after a jolt, or as a lens finds its focus.
///
/// The reference has none of the details that only the new image has. They say nothing of the motion. But Gauss-Newton
/// takes their gradients for information. With the gradients g of the new image and g' of the reference along a
/// direction, the curvature of the cost is the sum of w g g', not that of w g^2. The variance of the motion is then
/// rho^2 times what the normal equations say, with
///
///     rho = sum(w g^2) / max(sum(w g g'), sum(w g'^2))
///
/// The second sum is the larger one where both images have the same noise, or the new one has lost details. Images of
/// the same sharpness have less than 1: points are chosen where the reference's gradient is strong. What may be chance
/// does not count. Nor do more light and a motion away from what is seen, which make gradients steeper. A gain under 1
/// is left out: it comes from lost details as well.
struct SharperImage {
  /// rho^2 of the direction in the image in which it is largest, 1 if the image is not sharper.
  /// @param a alignment of the points to the image. @param image level 0.
  template <typename Camera>
  static double variance_factor(const PointSet& points, const Image<std::uint8_t>& image, const Camera& camera,
                                const Alignment& a, const AlignSettings& settings) {
    const auto visit = [&](std::size_t most, auto&& add) {
      visit_fitting(points, std::max<std::size_t>(1, points.u.size() / most), image, camera, a, settings,
                    [&](const FittingPoint& p) {
                      const Vector2<double> before(static_cast<double>(points.gu[0][p.i]),
                                                   static_cast<double>(points.gv[0][p.i]));
                      const double steeper = std::max(1.0, a.state.gain) * std::max(1.0, p.shrinks);
                      add(p.weight, p.gradient, Vector2<double>(steeper * before));
                    });
    };
    // Most images are not sharper, as a few points tell without the error of rho.
    Gradients few;
    visit(kFewPoints, [&](double weight, const Vector2<double>& gradient, const Vector2<double>& before) {
      few.add(weight, gradient, before);
    });
    const Directions& directions = all_directions();
    if (std::none_of(directions.begin(), directions.end(),
                     [&](const Vector2<double>& d) { return few.are_steeper_along(d); }))
      return 1;
    std::array<Along, kDirections> sums;
    std::transform(directions.begin(), directions.end(), sums.begin(),
                   [](const Vector2<double>& d) { return Along{d}; });
    visit(kPoints, [&](double weight, const Vector2<double>& gradient, const Vector2<double>& before) {
      for (Along& along : sums) along.add(weight, gradient, before);
    });
    double rho = 1;
    for (const Along& along : sums) rho = std::max(rho, along.rho_beyond_chance());
    return rho * rho;
  }

 private:
  static constexpr std::size_t kFewPoints = 100, kPoints = 1000;  ///< that are looked at, up to twice as many
  static constexpr std::size_t kDirections = 8;
  static constexpr double kLargest = 10;  ///< rho, where the reference has no gradients
  static constexpr double kSigmas = 3;    ///< of rho, that may be chance

  using Directions = std::array<Vector2<double>, kDirections>;  ///< of length 1, over half a turn

  /// They are computed once, as each object in each frame needs them.
  static const Directions& all_directions() {
    static const Directions all = [] {
      Directions out;
      for (std::size_t k = 0; k < kDirections; ++k) {
        const double angle = 3.14159265358979323846 * static_cast<double>(k) / kDirections;
        out[k] = {std::cos(angle), std::sin(angle)};
      }
      return out;
    }();
    return all;
  }

  /// Sums over the points of w g g^T, of the symmetric part of w g g'^T and of w g' g'^T: their uu, uv and vv.
  struct Gradients {
    Vector3<double> now = Vector3<double>::Zero(), both = Vector3<double>::Zero(), then = Vector3<double>::Zero();

    void add(double weight, const Vector2<double>& gradient, const Vector2<double>& before) {
      now += weight * product(gradient, gradient);
      both += weight * product(gradient, before);
      then += weight * product(before, before);
    }

    /// Whether rho is greater than 1.
    bool are_steeper_along(const Vector2<double>& d) const {
      const Vector3<double> along(d.x() * d.x(), 2 * d.x() * d.y(), d.y() * d.y());
      return along.dot(now) > std::max(along.dot(both), along.dot(then));
    }

   private:
    static Vector3<double> product(const Vector2<double>& a, const Vector2<double>& b) {
      return {a.x() * b.x(), 0.5 * (a.x() * b.y() + a.y() * b.x()), a.y() * b.y()};
    }
  };

  /// Sums over the points along one direction in the image.
  struct Along {
    Vector2<double> direction = Vector2<double>::Zero();
    Vector3<double> sum = Vector3<double>::Zero();       ///< of w g^2, w g g', w g'^2
    Matrix3<double> products = Matrix3<double>::Zero();  ///< of these terms

    void add(double weight, const Vector2<double>& gradient, const Vector2<double>& before) {
      const double now = direction.dot(gradient), then = direction.dot(before);
      const Vector3<double> terms = weight * Vector3<double>(now * now, now * then, then * then);
      sum += terms;
      products += terms * terms.transpose();
    }

    /// The ratio less its error, that of a ratio of two sums.
    double rho_beyond_chance() const {
      if (sum[0] <= 0) return 1;
      const int k = sum[1] > sum[2] ? 1 : 2;
      const double below = std::max(sum[k], sum[0] / kLargest), rho = sum[0] / below;
      const double variance = products(0, 0) - 2 * rho * products(0, k) + rho * rho * products(k, k);
      return rho - kSigmas * std::sqrt(std::max(0.0, variance)) / below;
    }
  };
};

DOT_END_NAMESPACE
