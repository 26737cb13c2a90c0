// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "dot/discovery/cell_warp.hpp"
#include "dot/image/image.hpp"
#include "dot/image/morphology.hpp"
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
    nearest.resize(q.width(), q.height());
    farthest.resize(q.width(), q.height());
    dilate<1>(std::as_const(q).view(), rows_, nearest.view());
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(q.width()) * q.height();
    std::transform(q.row(0), q.row(0) + size, farthest.row(0), [](float v) { return v > 0 ? v : kNone; });
    erode<1>(std::as_const(farthest).view(), rows_, farthest.view());
    std::transform(farthest.row(0), farthest.row(0) + size, farthest.row(0), [](float v) { return v < kNone ? v : 0; });
  }

 private:
  static constexpr float kNone = 1e9f;
  Image<float> rows_;  ///< scratch
};

/// The cells of the new frame whose depth contradicts a static scene, by any reference.
struct Inconsistency {
  static constexpr float kSigmas = 3;  ///< least difference of the measured and the predicted depth

  Image<std::uint8_t> depth;  ///< non-zero: it contradicts
  /// 1/m per second: what the last frame's surface must recede at for an older frame to contradict; 0: none may.
  Image<float> least_rate;

  /// Sets the size. No cell contradicts.
  void clear(int width, int height) {
    depth.resize(width, height);
    depth.fill(0);
    least_rate.resize(width, height);
    least_rate.fill(0);
  }

  /// An older frame contradicts the cell, if the surface of the last frame recedes there at this rate, 1/m per second.
  void contradict_if(int x, int y, float rate) {
    float& least = least_rate(x, y);
    least = least > 0 ? std::min(least, rate) : rate;
  }
  /// The surface of the last frame recedes at the cell at this rate, 1/m per second.
  void recede(int x, int y, float rate) {
    if (least_rate(x, y) > 0 && rate >= least_rate(x, y)) depth(x, y) = 255;
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
/// They count from `Inconsistency::kSigmas` of the difference on, s^2 = 2 pixel^2 + common^2 + (q^2 sigma_t)^2.
///
/// Cells on the reference's surface or nearer can also be compared by intensity, see `photo`. That is done where
/// it is asked for alone. Only the scale of all residuals is needed for it, which some of the cells tell.
template <typename Camera, typename Noise>
class InconsistencyTest {
 public:
  static constexpr float kLeaving = 0.25f;       ///< of the present range
  static constexpr float kGradientNoise = 0.2f;  ///< cells
  static constexpr int kSamples = 2000;          ///< cells that tell the scale of the residuals, roughly

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

  /// Adds the evidence of `reference` about `current`. Call it for the last frame last.
  /// @param standing the reference's inverse depth where no track explains the cell, 0 elsewhere.
  void operator()(const Camera& camera, const Noise& noise, const CellFrame& current, const CellFrame& reference,
                  const Image<float>& standing, const CellMotion& motion, Inconsistency& out) {
    entered(camera, noise, current, reference, motion, out);
    if (motion.adjacent) find_awaited(out);
    left(camera, noise, current, standing, motion, out, [](int, int) { return true; });
  }

  /// Adds the evidence that discovered objects have left their places. They do not count where they are not expected:
  /// the background that they uncover does not move.
  /// @param discovered the reference's inverse depth on objects that were discovered and shown, 0 elsewhere.
  /// @param followed of the new frame: non-zero where such an object is expected.
  /// @pre The evidence of the same reference's standing cells was added.
  void add_discovered(const Camera& camera, const Noise& noise, const CellFrame& current,
                      const Image<float>& discovered, const Image<std::uint8_t>& followed, const CellMotion& motion,
                      Inconsistency& out) {
    left(camera, noise, current, discovered, motion, out, [&](int u, int v) { return followed(u, v) != 0; });
  }

  /// How much the grey value of a cell contradicts a static scene, in sigma. The variance consists of the residuals'
  /// robust scale, the gradient times `kGradientNoise` cells, and the parallax due to the depth noise. 0 if nothing can
  /// be said: the cell or the place in the reference has no depth, or the cell is hidden there.
  /// @param scale `intensity_scale` after the comparison with this reference. May run in several threads at once.
  float photo(const Camera& camera, const Noise& noise, const CellFrame& current, const CellFrame& reference,
              const CellMotion& motion, float scale, int x, int y) const {
    const SE3f T = motion.T_cur_ref.inverse().template cast<float>();
    const float q = current.q(x, y);
    Moved m;
    if (x < 1 || y < 1 || x + 1 >= current.q.width() || y + 1 >= current.q.height()) return 0;
    if (!(q > 0) || !warp(camera, T, x, y, q, m) || !is_visible(noise, reference, motion, m)) return 0;
    const Vector2<float> gradient = current.gradient(x, y);
    const float dq = 1.4f * static_cast<float>(noise.pixel_sigma(q));
    const float parallax = dq * gradient.dot(warp.by_inverse_depth(camera, T, x, y, q));
    const float variance =
        scale * scale + parallax * parallax + kGradientNoise * kGradientNoise * gradient.squaredNorm();
    return std::abs(residual(current, reference, motion, x, y, m)) / std::sqrt(variance);
  }

 private:
  using Moved = typename CellWarp<Camera>::Moved;

  /// Whether a difference to an inverse depth q is positive and more than the noise, which is least at q = 0.
  struct Contradicts {
    const Noise& noise;
    const CellMotion& motion;
    const float least = Inconsistency::kSigmas * sigma(noise, 0, motion);  ///< spares most cells the noise at their q

    bool operator()(float difference, float q) const {
      return difference > least && difference > Inconsistency::kSigmas * sigma(noise, q, motion);
    }
  };

  /// Whether the reference shows a surface there that does not hide the cell.
  static bool is_visible(const Noise& noise, const CellFrame& reference, const CellMotion& motion, const Moved& m) {
    const int u = static_cast<int>(m.u + 0.5f), v = static_cast<int>(m.v + 0.5f);
    return reference.nearest(u, v) > 0 && !(m.q < reference.farthest(u, v) - 2 * sigma(noise, m.q, motion));
  }
  static float residual(const CellFrame& current, const CellFrame& reference, const CellMotion& motion, int x, int y,
                        const Moved& m) {
    return static_cast<float>(current.grey(x, y)) -
           static_cast<float>(motion.gain) * bilinear(reference.grey, m.u, m.v) - static_cast<float>(motion.offset);
  }

  void entered(const Camera& camera, const Noise& noise, const CellFrame& current, const CellFrame& reference,
               const CellMotion& motion, Inconsistency& out) {
    const SE3f T = motion.T_cur_ref.inverse().template cast<float>();
    const Contradicts contradicts{noise, motion};
    magnitudes_.clear();
    const int step = std::max(4, current.q.width() * current.q.height() / kSamples);
    for (int y = 1; y + 1 < current.q.height(); ++y) {
      warp.move_row(camera, T, y, current.q.row(y));
      const float* nearest = reference.nearest.row(0);
      std::uint8_t* depth = out.depth.row(y);
      for (int x = 1; x + 1 < current.q.width(); ++x) {
        const int place = warp.nearest(x);
        if (place < 0) continue;
        const float q = warp.moved_q(x), near = nearest[place];
        if (near > 0 && contradicts(q - near, q)) depth[x] = 255;
      }
      for (int x = 1 + y % step; x + 1 < current.q.width(); x += step) {
        const int place = warp.nearest(x);
        if (place < 0 || !(nearest[place] > 0)) continue;
        const float q = warp.moved_q(x), s = sigma(noise, q, motion);
        if (std::abs(q - nearest[place]) < 2 * s && !(q < reference.farthest.row(0)[place] - 2 * s))
          magnitudes_.push_back(std::abs(residual(current, reference, motion, x, y, warp.moved(x))));
      }
    }
    intensity_scale = scale_of_residuals();
  }

  /// Sets awaited_ to the cells beside which the rate of the last frame's surface matters.
  void find_awaited(const Inconsistency& out) {
    const Image<float>& rate = out.least_rate;
    awaited_.resize(rate.width(), rate.height());
    std::transform(rate.row(0), rate.row(0) + static_cast<std::ptrdiff_t>(rate.width()) * rate.height(),
                   awaited_.row(0), [](float least) { return static_cast<std::uint8_t>(least > 0 ? 255 : 0); });
    dilate<1>(std::as_const(awaited_).view(), rows_, awaited_.view());
  }

  /// @param counts (u, v) -> bool: whether the evidence is about this cell.
  template <typename Counts>
  void left(const Camera& camera, const Noise& noise, const CellFrame& current, const Image<float>& standing,
            const CellMotion& motion, Inconsistency& out, Counts&& counts) {
    const SE3f T = motion.T_cur_ref.template cast<float>();
    const Contradicts contradicts{noise, motion};
    for (int y = 0; y < standing.height(); ++y) {
      const float* row = standing.row(y);
      if (std::none_of(row, row + standing.width(), [](float q) { return q > 0; })) continue;
      warp.move_row(camera, T, y, row);
      for (int x = 0; x < standing.width(); ++x) {
        const int place = warp.nearest(x);
        if (place < 0) continue;
        const float before = warp.moved_q(x), behind = before - current.nearest.row(0)[place];
        const bool has_left = contradicts(behind, before);
        if (!has_left && !(motion.adjacent && awaited_.row(0)[place])) continue;
        const Moved m = warp.moved(x);
        const int u0 = static_cast<int>(m.u), v0 = static_cast<int>(m.v);
        for (int v = v0; v <= v0 + 1; ++v)
          for (int u = u0; u <= u0 + 1; ++u) {
            const float now = current.q(u, v);
            if (!(now > 0) || before * (1 - kLeaving) > now || !counts(u, v)) continue;
            const float rate = (before - now) / static_cast<float>(motion.seconds);
            if (!motion.adjacent)
              out.contradict_if(u, v, 0.5f * rate);
            else if (has_left)
              out.depth(u, v) = 255;
            else
              out.recede(u, v, rate);
          }
      }
    }
  }

  /// Robust scale of the residuals of cells whose depth agrees. Grey values, at least one.
  float scale_of_residuals() {
    if (magnitudes_.size() < 8) return 10;
    return std::max(1.f, static_cast<float>(kSigmaOfMedian) * median(magnitudes_.begin(), magnitudes_.end()));
  }

  std::vector<float> magnitudes_;       ///< of sampled residuals, grey values
  Image<std::uint8_t> awaited_, rows_;  ///< cells; the second is scratch
};

DOT_END_NAMESPACE
