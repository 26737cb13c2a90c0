// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "dot/discovery/cell_warp.hpp"
#include "dot/image/buffer.hpp"
#include "dot/image/image.hpp"
#include "dot/image/pyramid.hpp"
#include "dot/lie/se3.hpp"
#include "dot/statistics/median.hpp"

DOT_BEGIN_NAMESPACE

/// A frame as used by the inconsistency test: the pixels ("cells") of one coarse pyramid level.
struct CellFrame {
  Image<std::uint8_t> grey;  ///< grey values
  Image<float> q;            ///< inverse depth, 1/m, 0 = none
  Image<float> nearest;      ///< largest inverse depth of the 3x3 cells around each, 0 = none
  Image<float> farthest;     ///< smallest inverse depth of these, 0 = none

  /// Derivatives of the grey value by column and row. @pre (x, y) is not at the border.
  Vector2<float> gradient(int x, int y) const {
    return {0.5f * static_cast<float>(grey(x + 1, y) - grey(x - 1, y)),
            0.5f * static_cast<float>(grey(x, y + 1) - grey(x, y - 1))};
  }

  /// Takes a level of the image and of the inverse depth, of the same size.
  void build(const Image<std::uint8_t>& grey_level, const Image<float>& depth_level) {
    grey = grey_level;
    q = depth_level;
    const int w = q.width(), h = q.height();
    nearest.resize(w, h);
    farthest.resize(w, h);
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        float largest = 0, smallest = kNone;
        for (int j = std::max(0, y - 1); j <= std::min(h - 1, y + 1); ++j)
          for (int i = std::max(0, x - 1); i <= std::min(w - 1, x + 1); ++i) {
            const float v = q(i, j);
            largest = std::max(largest, v);
            smallest = std::min(smallest, v > 0 ? v : kNone);
          }
        nearest(x, y) = largest;
        farthest(x, y) = smallest < kNone ? smallest : 0;
      }
  }

 private:
  static constexpr float kNone = 1e9f;
};

/// How much each cell of the new frame contradicts a static scene, in sigma. It is the maximum over the references.
struct Inconsistency {
  Image<float> depth;     ///< of the measured depth with the predicted one
  Image<float> photo;     ///< of the grey value with the predicted one
  Image<float> receding;  ///< 1/m per second, signed: speed at which the last frame's surface there recedes

  /// Sets the size, and all cells to 0.
  void clear(int width, int height) {
    for (Image<float>* image : {&depth, &photo, &receding}) {
      image->resize(width, height);
      image->fill(0);
    }
  }
};

/// The change between a reference and the new frame if the scene is static.
struct CellMotion {
  SE3d T_cur_ref;                ///< motion of the camera
  double translation_sigma = 0;  ///< metres, of T_cur_ref
  double gain = 1;               ///< I_cur = gain I_ref + offset
  double offset = 0;             ///< grey values
  double seconds = 0;            ///< between the two
  bool adjacent = false;         ///< the last interval; only the change of the shared depth error counts
};

/// Compares a new frame with a reference under the camera's motion alone.
///
/// Parallax hides and uncovers static surfaces, so a difference of depth alone is no evidence. Two findings cannot come
/// from a static scene, whatever the occlusions are:
///
/// - *entered*: a surface of the new frame lies where the reference shows a farther surface, q - q_ref > 0, with q
///   transformed into the reference;
/// - *left*: the new frame shows a farther surface where the reference had a nearer one, q_ref - q > 0, with q_ref
///   transformed into the new frame. The farther surface may be ground that a passing object uncovered, or the object
///   itself a bit farther away. So only cells within `kLeaving` of the old range are counted. Against an older
///   reference, a cell must also recede in the last interval at half or more of its mean rate since that reference.
///
/// Both differences are to the nearest surface of 3x3 cells. This tolerates fattened edges and half a cell of error.
/// They are divided by the sigma of the difference, s^2 = 2 pixel^2 + common^2 + (q^2 sigma_t)^2. Cells on the
/// reference's surface or nearer are also compared by intensity. The sigma of that consists of the residual's robust
/// scale, the gradient times `kGradientNoise` cells, and the parallax due to the depth noise.
template <typename Camera, typename Noise>
class InconsistencyTest {
 public:
  static constexpr float kLeaving = 0.25f;       ///< of the present range
  static constexpr float kGradientNoise = 0.2f;  ///< cells

  CellWarp<Camera> warp;       ///< between the frames
  float intensity_scale = 10;  ///< grey values: robust scale of the residuals of the last call

  /// Standard deviation of the difference of two inverse depths, 1/m.
  static float sigma(const Noise& noise, float q, const CellMotion& motion) {
    const double pixel = noise.pixel_sigma(q),
                 shared = motion.adjacent ? noise.shared_drift_sigma(q) : noise.shared_sigma(q);
    const double range = static_cast<double>(q) * static_cast<double>(q) * motion.translation_sigma;
    return static_cast<float>(std::sqrt(2 * pixel * pixel + shared * shared + range * range));
  }

  /// @param camera of the cells' level.
  void prepare(const Camera& camera) { warp.prepare(camera); }

  /// Adds the evidence of `reference` about `current`. Call it for the last frame first.
  /// @param standing the reference's inverse depth where no track explains the cell, 0 elsewhere.
  void operator()(const Camera& camera, const Noise& noise, const CellFrame& current, const CellFrame& reference,
                  const Image<float>& standing, const CellMotion& motion, Inconsistency& out) {
    entered(camera, noise, current, reference, motion, out);
    left(camera, noise, current, standing, motion, out, [](int, int) { return true; });
  }

  /// Adds the evidence that discovered objects have left their places. They do not count where they are not expected:
  /// the background that they uncover does not move.
  /// @param discovered the reference's inverse depth on objects that were discovered and shown, 0 elsewhere.
  /// @param followed of the new frame: non-zero where such an object is expected.
  void add_discovered(const Camera& camera, const Noise& noise, const CellFrame& current,
                      const Image<float>& discovered, const Image<std::uint8_t>& followed, const CellMotion& motion,
                      Inconsistency& out) {
    left(camera, noise, current, discovered, motion, out, [&](int u, int v) { return followed(u, v) != 0; });
  }

 private:
  using Moved = typename CellWarp<Camera>::Moved;

  void entered(const Camera& camera, const Noise& noise, const CellFrame& current, const CellFrame& reference,
               const CellMotion& motion, Inconsistency& out) {
    const SE3f T = motion.T_cur_ref.inverse().template cast<float>();
    const float gain = static_cast<float>(motion.gain), offset = static_cast<float>(motion.offset);
    std::size_t count = 0;
    residuals_.resize(static_cast<std::size_t>(current.q.width()) * static_cast<std::size_t>(current.q.height()));
    for (int y = 1; y + 1 < current.q.height(); ++y) {
      warp.move_row(camera, T, y, current.q.row(y));
      for (int x = 1; x + 1 < current.q.width(); ++x) {
        const float q = current.q(x, y);
        Moved m;
        if (!(q > 0) || !warp.is_seen(camera, x, q, m)) continue;
        const int u = static_cast<int>(m.u + 0.5f), v = static_cast<int>(m.v + 0.5f);
        const float near = reference.nearest(u, v);
        if (!(near > 0)) continue;
        const float s = sigma(noise, m.q, motion), d = (m.q - near) / s;
        out.depth(x, y) = std::max(out.depth(x, y), d);
        if (m.q < reference.farthest(u, v) - 2 * s) continue;  // hidden in the reference
        const Vector2<float> gradient = current.gradient(x, y);
        const float dq = 1.4f * static_cast<float>(noise.pixel_sigma(q));
        const float parallax = dq * gradient.dot(warp.by_inverse_depth(camera, T, x, y, q));
        const float r = static_cast<float>(current.grey(x, y)) - gain * bilinear(reference.grey, m.u, m.v) - offset;
        Residual& added = residuals_[count++];
        added.x = x, added.y = y, added.value = r, added.agrees = std::abs(d) < 2;
        added.variance = parallax * parallax + kGradientNoise * kGradientNoise * gradient.squaredNorm();
      }
    }
    residuals_.resize(count);
    intensity_scale = scale_of_residuals();
    const float scale = intensity_scale;
    for (const Residual& r : residuals_)
      out.photo(r.x, r.y) = std::max(out.photo(r.x, r.y), std::abs(r.value) / std::sqrt(scale * scale + r.variance));
  }

  /// @param counts (u, v) -> bool: whether the evidence is about this cell.
  template <typename Counts>
  void left(const Camera& camera, const Noise& noise, const CellFrame& current, const Image<float>& standing,
            const CellMotion& motion, Inconsistency& out, Counts&& counts) {
    const SE3f T = motion.T_cur_ref.template cast<float>();
    for (int y = 0; y < standing.height(); ++y) {
      const float* row = standing.row(y);
      if (std::none_of(row, row + standing.width(), [](float q) { return q > 0; })) continue;
      warp.move_row(camera, T, y, row);
      for (int x = 0; x < standing.width(); ++x) {
        const float q = standing(x, y);
        Moved m;
        if (!(q > 0) || !warp.is_seen(camera, x, q, m)) continue;
        const int u0 = static_cast<int>(m.u), v0 = static_cast<int>(m.v);
        const float d = (m.q - current.nearest(static_cast<int>(m.u + 0.5f), static_cast<int>(m.v + 0.5f))) /
                        sigma(noise, m.q, motion);
        for (int v = v0; v <= v0 + 1; ++v)
          for (int u = u0; u <= u0 + 1; ++u) {
            const float now = current.q(u, v);
            if (!(now > 0) || m.q * (1 - kLeaving) > now || !counts(u, v)) continue;
            const float rate = (m.q - now) / static_cast<float>(motion.seconds);
            if (motion.adjacent)
              out.receding(u, v) = std::max(out.receding(u, v), rate);
            else if (out.receding(u, v) < 0.5f * rate)
              continue;
            out.depth(u, v) = std::max(out.depth(u, v), d);
          }
      }
    }
  }

  /// Robust scale of the residuals of cells whose depth agrees. Grey values, at least one.
  float scale_of_residuals() {
    magnitudes_.clear();
    for (const Residual& r : residuals_)
      if (r.agrees) magnitudes_.push_back(std::abs(r.value));
    if (magnitudes_.size() < 20) return 10;
    return std::max(1.f, static_cast<float>(kSigmaOfMedian) * median(magnitudes_.begin(), magnitudes_.end()));
  }

  struct Residual {
    int x, y;
    float value;     ///< grey values
    float variance;  ///< without that of the intensity itself
    bool agrees;     ///< whether the depth agrees
  };
  Buffer<Residual> residuals_;
  std::vector<float> magnitudes_;
};

DOT_END_NAMESPACE
