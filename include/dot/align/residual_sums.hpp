// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <Eigen/Cholesky>

#include "dot/align/aligner.hpp"
#include "dot/align/photometric_factor.hpp"
#include "dot/points/point_set.hpp"

DOT_BEGIN_NAMESPACE

/// A point that fits the alignment of its set to an image: its residual r of eq. 3 there.
struct FittingPoint {
  std::size_t i;             ///< its place in the set
  Vector2<float> pixel;      ///< in the new image
  Vector2<double> gradient;  ///< there, grey values per pixel
  double shrinks;            ///< its depth there over that in the reference
  double r;                  ///< grey values
  Vector8 dr_dstate;         ///< by [x; a; b], the left twist of the pose, gain, offset
  double dr_dq;              ///< by the inverse depth
  double weight;             ///< Tukey's, over the variance of r
};

/// Calls `visit(FittingPoint)` for the points that are inside an image, without a border of one to three pixels, and
/// fit their alignment to it.
/// @param every takes each so-many-th point. @param image level 0.
template <typename Camera, typename Visit>
void visit_fitting(const PointSet& points, std::size_t every, const Image<std::uint8_t>& image, const Camera& camera,
                   const Alignment& a, const AlignSettings& settings, Visit&& visit) {
  const auto sq = [](double x) { return x * x; };
  const Matrix3<float> R = a.state.T.R.template cast<float>();
  const Vector3<float> t = a.state.T.t.template cast<float>();
  const PhotometricModel<double> factor(a.state, settings.gradient_noise);
  const float u_max = static_cast<float>(image.width() - 3), v_max = static_cast<float>(image.height() - 3);
  for (std::size_t i = 0; i < points.u.size(); i += every) {
    const float q = points.q[i];
    const Vector3<float> X = R * Vector3<float>(points.x[i], points.y[i], 1) + q * t;
    if (X.z() < 1e-3f) continue;
    Eigen::Matrix<float, 2, 3> J_pi;
    const Vector2<float> pixel = camera.template project<float>(X, &J_pi);
    if (!(pixel.x() >= 1 && pixel.y() >= 1 && pixel.x() < u_max && pixel.y() < v_max)) continue;
    const Sample s = sample(image, pixel.x(), pixel.y());
    const double intensity = static_cast<double>(points.intensity[0][i]);
    const auto [r, dr_dX, dr_dq, extra] = factor(s, J_pi, intensity, static_cast<double>(points.sigma_q[i]));
    const double s2 = sq(a.sigma_intensity) + extra;
    const double fits = 1 - r * r / (s2 * sq(settings.tukey));
    if (fits <= 0) continue;
    Vector8 dr_dstate;
    dr_dstate << static_cast<double>(q) * dr_dX, X.template cast<double>().cross(dr_dX), -intensity, -1;
    const Vector2<double> gradient{static_cast<double>(s.gx), static_cast<double>(s.gy)};
    visit(FittingPoint{i, pixel, gradient, static_cast<double>(X.z()), r, dr_dstate, dr_dq, sq(fits) / s2});
  }
}

/// Normal equations of pose, gain and offset, and of K more parameters that may explain what these leave.
template <int K>
class ResidualSums {
 public:
  using Terms = Eigen::Matrix<double, K, 1>;         ///< a value for each parameter
  using Information = Eigen::Matrix<double, K, K>;   ///< of the parameters
  using StateByTerms = Eigen::Matrix<double, 8, K>;  ///< of [x; a; b] by the parameters

  /// Adds a point. @param dr_dterms derivative of its residual by the parameters.
  void add(const FittingPoint& p, const Terms& dr_dterms) {
    Row J;
    J << p.dr_dstate, dr_dterms, p.r;
    sums_.noalias() += (p.weight * J) * J.transpose();
  }

  /// What the points say of the parameters, with pose, gain and offset eliminated.
  struct Marginal {
    Information information;        ///< inverse covariance, of independent residuals
    Terms weighted;                 ///< information times the parameters' estimate
    StateByTerms missing_in_state;  ///< error of an estimate of [x; a; b] that lacks the parameters, by these
  };
  /// That of all points that were added.
  Marginal marginal() const {
    const Vector8 g_state = sums_.col(8 + K).template head<8>();
    const Terms g = sums_.col(8 + K).template segment<K>(8);
    Matrix8 state = sums_.template topLeftCorner<8, 8>();
    state.diagonal() += 1e-7 * state.diagonal() + Vector8::Constant(1e-9);
    const StateByTerms mixed = sums_.template block<8, K>(0, 8);
    const StateByTerms G = Eigen::LDLT<Matrix8>(state).solve(mixed);
    return {sums_.template block<K, K>(8, 8) - G.transpose() * mixed, G.transpose() * g_state - g, G};
  }

 private:
  using Row = Eigen::Matrix<double, 8 + K + 1, 1>;
  Eigen::Matrix<double, 8 + K + 1, 8 + K + 1> sums_ =
      Eigen::Matrix<double, 8 + K + 1, 8 + K + 1>::Zero();  ///< of [J r]' [J r]
};

DOT_END_NAMESPACE
