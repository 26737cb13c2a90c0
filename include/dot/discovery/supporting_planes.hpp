// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "dot/abi.hpp"
#include "dot/camera/intrinsics.hpp"
#include "dot/image/image.hpp"

DOT_BEGIN_NAMESPACE

/// The planes that support and bound a scene: road, floor, table, long walls. They are the planes with most
/// measurements on them and almost none behind them. No direction of "up" is assumed. A plane in space is linear in
/// inverse depth over the image, q = a u + b v + c.
class SupportingPlanes {
 public:
  static constexpr int kMaxPlanes = 3;      ///< of a frame
  static constexpr double kShare = 0.1;     ///< least share of the measurements on a plane
  static constexpr double kBehind = 0.25;   ///< largest number behind it, relative to those on it
  static constexpr double kRise = 0.1;      ///< lower points count as on it; relative to the nearest plane's distance
  static constexpr double kMostRise = 0.3;  ///< metres, the same: from the air, cars are lower than kRise

  /// @param q inverse depth, 0 = none. @param camera of this image. @param sigma (q) -> standard deviation of q.
  /// @param use (x, y) -> bool: whether the pixel may support a plane.
  template <typename Sigma, typename Use>
  void find(const Image<float>& q, const Intrinsics& camera, Sigma&& sigma, Use&& use) {
    points_.clear();
    for (int y = 0; y < q.height(); y += 2)
      for (int x = (y / 2) % 2; x < q.width(); x += 2)
        if (q(x, y) > 0 && use(x, y))
          points_.push_back(
              {static_cast<float>(x), static_cast<float>(y), q(x, y), static_cast<float>(sigma(q(x, y))), false});
    const std::vector<Plane> before = planes_;
    planes_.clear();
    if (points_.size() < 50) return;
    std::uint32_t random = 1;
    while (static_cast<int>(planes_.size()) < kMaxPlanes && add_best(before, random)) {
    }
    set_rise(camera);
  }

  /// Number of planes found.
  int count() const { return static_cast<int>(planes_.size()); }
  /// Forgets the planes.
  void clear() { planes_.clear(); }

  /// Whether a measurement lies on a plane, or behind it.
  bool hold(int x, int y, float q, float sigma) const {
    for (const Plane& plane : planes_) {
      const float on = plane(static_cast<float>(x), static_cast<float>(y));
      if (on > 0 && (q - on < 3 * sigma || q * (1 - plane.rise) < on)) return true;
    }
    return false;
  }

 private:
  static constexpr int kTrials = 100;
  static constexpr std::size_t kRated = 500;             ///< points that tell whether a plane supports the scene
  static constexpr float kSigmas = 2.5f, kGate = 0.03f;  ///< half width of a plane: of a point, and relative
  struct Point {
    float x, y, q, sigma;
    bool taken;  ///< by a plane found already
  };
  struct Plane {
    float a = 0, b = 0, c = 0;
    float rise = 0;  ///< kRise, converted to this plane's distance
    float operator()(float x, float y) const { return a * x + b * y + c; }
  };

  /// Some of the points, for `rate`.
  struct Some {
    std::vector<float> x, y, q, width;  ///< `width`: least half width of the gate
    std::vector<int> open;              ///< 1: not taken

    void take_every(std::size_t step, const std::vector<Point>& points) {
      for (std::vector<float>* values : {&x, &y, &q, &width}) values->clear();
      open.clear();
      for (std::size_t i = 0; i < points.size(); i += step) {
        x.push_back(points[i].x), y.push_back(points[i].y), q.push_back(points[i].q);
        width.push_back(kSigmas * points[i].sigma);
        open.push_back(!points[i].taken);
      }
    }
  };

  static float gate(const Point& p, float expected) { return std::max(kSigmas * p.sigma, kGate * expected); }

  bool add_best(const std::vector<Plane>& before, std::uint32_t& random) {
    some_.take_every(std::max<std::size_t>(1, points_.size() / kRated), points_);
    Plane best;
    double most = 0;
    const auto consider = [&](const Plane& plane) {
      if (const double score = rate(plane); score > most) most = score, best = plane;
    };
    for (const Plane& plane : before) consider(plane);
    const auto pick = [&]() -> const Point& {
      random = random * 1664525u + 1013904223u;
      return points_[static_cast<std::size_t>((std::uint64_t{random} * points_.size()) >> 32)];
    };
    for (int i = 0; i < kTrials; ++i) {
      const Point &p = pick(), &r = pick(), &s = pick();
      const float ux = r.x - p.x, uy = r.y - p.y, vx = s.x - p.x, vy = s.y - p.y, det = ux * vy - uy * vx;
      if (p.taken || r.taken || s.taken || std::abs(det) < 100) continue;
      Plane plane;
      plane.a = ((r.q - p.q) * vy - (s.q - p.q) * uy) / det;
      plane.b = ((s.q - p.q) * ux - (r.q - p.q) * vx) / det;
      plane.c = p.q - plane.a * p.x - plane.b * p.y;
      consider(plane);
    }
    if (most <= 0) return false;
    refine(best);
    refine(best);
    for (Point& p : points_) {
      const float expected = best(p.x, p.y);
      p.taken |= expected > 0 && std::abs(p.q - expected) < gate(p, expected);
    }
    planes_.push_back(best);
    return true;
  }

  /// Number of measurements on this plane alone minus those behind it. 0 if it does not support the scene.
  double rate(const Plane& plane) const {
    int on = 0, behind = 0;
    const int count = static_cast<int>(some_.x.size());
    for (std::size_t i = 0; i < some_.x.size(); ++i) {  // without branches, so that it becomes SIMD code
      const float expected = plane(some_.x[i], some_.y[i]), d = some_.q[i] - expected;
      const float width = std::max(some_.width[i], kGate * expected);
      on += static_cast<int>(expected > 0) & some_.open[i] & static_cast<int>(std::abs(d) < width);
      behind += static_cast<int>(expected > 0) & static_cast<int>(d < -2 * width);
    }
    return on >= kShare * count && behind <= kBehind * on ? on - behind : 0;
  }

  /// Least squares over the measurements on the plane.
  void refine(Plane& plane) const {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0, sr = 0, sxr = 0, syr = 0;
    for (const Point& p : points_) {
      const float expected = plane(p.x, p.y);
      if (p.taken || !(expected > 0) || std::abs(p.q - expected) > gate(p, expected)) continue;
      const double x = p.x, y = p.y, r = p.q - expected;
      const double w = 1 / (static_cast<double>(p.sigma) * static_cast<double>(p.sigma));
      n += w, sx += w * x, sy += w * y, sxx += w * x * x, sxy += w * x * y, syy += w * y * y;
      sr += w * r, sxr += w * x * r, syr += w * y * r;
    }
    const double cxx = sxx - sx * sx / n, cxy = sxy - sx * sy / n, cyy = syy - sy * sy / n;
    const double cxr = sxr - sx * sr / n, cyr = syr - sy * sr / n, det = cxx * cyy - cxy * cxy;
    if (!(det > 1e-6 * n * n)) return;
    const double a = (cyy * cxr - cxy * cyr) / det, b = (cxx * cyr - cxy * cxr) / det;
    plane.a += static_cast<float>(a);
    plane.b += static_cast<float>(b);
    plane.c += static_cast<float>((sr - a * sx - b * sy) / n);
  }

  /// For a ray X, q = n X / d with the unit normal n. So the norm of q's coefficients is 1 / d.
  void set_rise(const Intrinsics& camera) {
    const auto inverse_distance = [&](const Plane& p) {
      const double a = p.a, b = p.b, c = p.c;
      return std::hypot(a * camera.fx, b * camera.fy, a * camera.cx + b * camera.cy + c);
    };
    double nearest = 0;
    for (const Plane& p : planes_) nearest = std::max(nearest, inverse_distance(p));
    const double rise = std::min(kRise, kMostRise * nearest);
    for (Plane& p : planes_) p.rise = static_cast<float>(rise * inverse_distance(p) / nearest);
  }

  std::vector<Plane> planes_;
  std::vector<Point> points_;
  Some some_;
};

DOT_END_NAMESPACE
