// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "dot/camera/depth_noise.hpp"
#include "dot/containers/recycling_list.hpp"
#include "dot/discovery/inconsistency.hpp"
#include "dot/discovery/moving_part.hpp"
#include "dot/discovery/region_grower.hpp"
#include "dot/discovery/region_painter.hpp"
#include "dot/discovery/supporting_planes.hpp"
#include "dot/image/depth_pyramid.hpp"
#include "dot/image/morphology.hpp"
#include "dot/image/pyramid.hpp"
#include "dot/object_motion/reference.hpp"

DOT_BEGIN_NAMESPACE

/// Finds candidates for moving objects in the background. A candidate is a region that contradicts a static scene in
/// two consecutive frames and lies off the supporting planes. Its track must show whether it really moves.
template <typename Camera, typename Noise>
class Discovery {
 public:
  static constexpr int kLevel = 2;  ///< pyramid level whose pixels are the cells

  /// Explanations of a pixel, for `find`. The other values are numbers of moving objects that were found before.
  static constexpr std::uint8_t kNothing = 0;  ///< background
  static constexpr std::uint8_t kStanding =
      254;  ///< an object that was found before and is static, or was not confirmed
  static constexpr std::uint8_t kCovered = 255;  ///< a mask of the network; the largest value

  double reference_seconds = 0.4;  ///< age of the oldest frame that the new one is compared with
  std::vector<Mask> masks;         ///< of the regions of this frame

  /// The depth noise with which `find` compares. Its scales are learnt from the background, and an object without a
  /// mask is part of that background. If the object moves, it makes the learnt noise larger. The bound keeps this
  /// larger noise from hiding the object.
  static Noise bounded(Noise noise) {
    constexpr double kMaxLearntScale = 3;  // of the noise that is shared, over its prior
    if constexpr (std::is_same_v<Noise, DepthNoise>) {
      noise.shared_scale = std::min(noise.shared_scale, kMaxLearntScale);
      noise.shared_drift_scale = std::min(noise.shared_drift_scale, kMaxLearntScale);
    }
    return noise;
  }

  /// Forgets all frames.
  void clear() noexcept {
    history_.clear();
    seen_.resize(0, 0);
    planes_.clear();
  }

  /// Takes the camera's motion over the last interval. Must be called before `find`.
  /// @param covariance of the left twist of T_cur_prev.
  void advance(const SE3d& T_cur_prev, const Matrix6<double>& covariance, double gain, double offset) {
    for (Reference& r : history_) {
      CellMotion& m = r.motion;
      m.T_cur_ref = T_cur_prev * m.T_cur_ref;
      m.translation_sigma =
          std::sqrt(m.translation_sigma * m.translation_sigma + covariance.diagonal().head<3>().sum());
      m.gain *= gain;
      m.offset = gain * m.offset + offset;
    }
  }

  /// Fills `masks`. @param known explanation of each pixel, see above. @param timestamp seconds.
  void find(const Camera& camera, const Noise& noise, const Pyramid& image, const DepthPyramid& depth,
            const Image<std::uint8_t>& known, double timestamp) {
    masks.clear();
    level_ = std::min(kLevel, image.size() - 1);
    const std::size_t level = static_cast<std::size_t>(level_);
    current_.build(image.levels[level], depth.levels[level]);
    const Image<float>& q = current_.q;
    inconsistency_.clear(q.width(), q.height());
    blind_ = !has_depth(q);
    if (blind_ || history_.empty()) return;
    const Camera cells = camera.at_level(level_);
    read(known);
    compare(cells, noise, timestamp);

    const auto sigma = [&](float value) { return noise.pixel_sigma(value); };
    planes_.find(q, cells.intrinsics(), sigma,
                 [&](int x, int y) { return !covered_(x, y) && !inconsistency_.depth(x, y); });
    const auto open = [&](int x, int y) {
      return !covered_(x, y) && !planes_.hold(x, y, q(x, y), static_cast<float>(noise.pixel_sigma(q(x, y))));
    };
    grower_(q, inconsistency_, followed_, sigma, open, [&](int x, int y) { return contradicts(cells, noise, x, y); });
    for (const std::vector<int>& region : grower_.regions) {
      if (!lasts(region)) continue;
      masks.emplace_back();
      painter_(region, q, depth.levels[0], 1 << level_, sigma, masks.back());
      if (masks.back().empty()) masks.pop_back();
    }
    see(q.width(), q.height());
  }

  /// Compares an object's motion with standing, in the frames that are kept both here and as references of the object.
  /// Must be called between `find` and `remember`. @param mask of the object now. @param references of the object, with
  /// their motion to the current frame. @param out what of the mask moves.
  void compare(const Camera& camera, const Noise& noise, const Mask& mask,
               const RecyclingList<ObjectReference>& references, MovingPart& out) const {
    const Camera cells = camera.at_level(level_);
    out.evidence.restart(mask, 1 << level_);
    int compared = 0;
    for (std::size_t i = references.size(); i-- > 0 && compared < kMostCompared;)
      for (const Reference& r : history_) {
        if (r.timestamp != references[i].timestamp) continue;
        // Not every frame was compared. The oldest was, and has the largest residuals.
        const float scale = history_.back().intensity_scale;
        const CellComparison<Camera, Noise> comparison{cells, noise, test_, current_, r.frame, r.motion, scale};
        comparison(references[i].T_obj_now_ref, out.evidence);
        ++compared;
      }
    out.find([&](int x, int y) { return inconsistency_.depth.contains(x, y) && contradicts(cells, noise, x, y); });
  }

  /// Whether the frame of the last `find` has no depth, as every other one of a camera that is faster than its depth.
  /// It says nothing, and is not kept.
  bool is_blind() const { return blind_; }

  /// How sure it is, 0 to 1, that a mask's cells do not stand, by the share of them that contradict a static scene in
  /// this frame. The share that a region needs is enough to be sure.
  double certainty(const Camera& camera, const Noise& noise, const Mask& mask) const {
    const Camera cells = camera.at_level(level_);
    const int cell = 1 << level_, half = cell / 2;
    int count = 0, contradicting = 0;
    for (int y = mask.y / cell; y * cell + half < mask.y + mask.height(); ++y)
      for (int x = mask.x / cell; x * cell + half < mask.x + mask.width(); ++x) {
        if (!mask.at(x * cell + half, y * cell + half) || !inconsistency_.depth.contains(x, y)) continue;
        ++count;
        contradicting += contradicts(cells, noise, x, y);
      }
    return count > 0 ? std::min(1.0, contradicting / (RegionGrower::kMinShare * count)) : 0;
  }

  /// Keeps the frame of the last `find` as a reference. @param ids of the tracks shown, 0 = background.
  /// @param is_discovered (id) -> bool: whether no network has shown this track.
  template <typename IsDiscovered>
  void remember(const Image<std::uint32_t>& ids, IsDiscovered&& is_discovered, double timestamp) {
    while (!history_.empty() && timestamp - history_.back().timestamp > reference_seconds + 1e-6) history_.pop_back();
    if (blind_) return;
    thin_newest(history_, reference_seconds);
    Reference& r = history_.push_front();
    r.motion = {};
    r.timestamp = timestamp;
    r.intensity_scale = 0;
    std::swap(r.frame, current_);
    r.standing = r.frame.q;
    r.discovered.resize(r.standing.width(), r.standing.height());
    r.discovered.fill(0);
    const int cell = 1 << level_;
    for (int y = 0; y < r.standing.height(); ++y)
      for (int x = 0; x < r.standing.width(); ++x) {
        const std::uint32_t first = ids(x * cell, y * cell), last = ids(x * cell + cell - 1, y * cell + cell - 1);
        if (first == 0 && last == 0) continue;
        const float q = std::exchange(r.standing(x, y), 0);
        if (first == last && is_discovered(first)) r.discovered(x, y) = q;
      }
  }

 private:
  static constexpr int kMostCompared = 3;  ///< frames that a motion is compared in; the oldest ones tell most

  struct Reference {
    CellFrame frame;
    Image<float> standing;    ///< inverse depth, 0 where tracks explain the pixel
    Image<float> discovered;  ///< inverse depth where a discovered track explains it, 0 elsewhere
    CellMotion motion;
    double timestamp = 0;
    float intensity_scale = 0;  ///< grey values: of the residuals; 0 if the new frame was not compared with it
  };

  static bool has_depth(const Image<float>& q) {
    const float* cells = q.row(0);
    return std::any_of(cells, cells + static_cast<std::ptrdiff_t>(q.width()) * q.height(),
                       [](float v) { return v > 0; });
  }

  /// Compares with the oldest reference, one in the middle, and the newest.
  void compare(const Camera& cells, const Noise& noise, double timestamp) {
    test_.prepare(cells);
    for (Reference& r : history_) {
      r.motion.adjacent = false, r.motion.seconds = timestamp - r.timestamp;
      r.intensity_scale = 0;
    }
    history_[0].motion.adjacent = true;
    const std::size_t n = history_.size();
    std::size_t last = n;
    for (const std::size_t k : {n - 1, n / 2, std::size_t{0}}) {
      if (k == last) continue;
      last = k;
      Reference& r = history_[k];
      test_(cells, noise, current_, r.frame, r.standing, r.motion, inconsistency_);
      test_.add_discovered(cells, noise, current_, r.discovered, followed_, r.motion, inconsistency_);
      r.intensity_scale = test_.intensity_scale;
    }
  }

  /// Whether a cell contradicts a static scene, by its depth or by its grey value.
  bool contradicts(const Camera& cells, const Noise& noise, int x, int y) const {
    if (inconsistency_.depth(x, y)) return true;
    for (const Reference& r : history_)
      if (r.intensity_scale > 0 &&
          test_.photo(cells, noise, current_, r.frame, r.motion, r.intensity_scale, x, y) > RegionGrower::kPhoto)
        return true;
    return false;
  }

  /// Converts pixels to cells. A cell is covered if any of its pixels is, with a margin of one cell. It is followed if
  /// all its pixels have the same number.
  void read(const Image<std::uint8_t>& known) {
    covered_.resize(current_.q.width(), current_.q.height());
    followed_.resize(current_.q.width(), current_.q.height());
    const int cell = 1 << level_, width = known.width();
    extremes_.resize(width, 2);
    std::uint8_t *low = extremes_.row(0), *high = extremes_.row(1);
    for (int y = 0; y < covered_.height(); ++y) {
      std::copy_n(known.row(y * cell), width, low);
      std::copy_n(known.row(y * cell), width, high);
      for (int v = y * cell + 1; v < (y + 1) * cell; ++v) {
        const std::uint8_t* row = known.row(v);
        for (int u = 0; u < width; ++u) low[u] = std::min(low[u], row[u]), high[u] = std::max(high[u], row[u]);
      }
      for (int x = 0; x < covered_.width(); ++x) {
        std::uint8_t least = kCovered, most = kNothing;
        for (int u = x * cell; u < (x + 1) * cell; ++u) least = std::min(least, low[u]), most = std::max(most, high[u]);
        covered_(x, y) = most == kCovered ? 255 : 0;
        followed_(x, y) = least == most ? most : kNothing;
      }
    }
    dilate<1>(std::as_const(covered_).view(), rows_, covered_.view());
    for (int y = 0; y < covered_.height(); ++y)
      for (int x = 0; x < covered_.width(); ++x) {
        if (followed_(x, y) == kStanding) covered_(x, y) = 255;
        if (covered_(x, y)) followed_(x, y) = kNothing;
      }
  }

  /// Whether a region was there in the frame before.
  bool lasts(const std::vector<int>& region) const {
    if (seen_.empty()) return false;
    int common = 0;
    for (const int i : region) common += seen_.row(0)[i] != 0;
    return 4 * common >= static_cast<int>(region.size());
  }

  void see(int width, int height) {
    seen_.resize(width, height);
    seen_.fill(0);
    for (const std::vector<int>& region : grower_.regions)
      for (const int i : region) seen_.row(0)[i] = 255;
    dilate<2>(std::as_const(seen_).view(), rows_, seen_.view());
  }

  int level_ = 0;
  bool blind_ = false;
  CellFrame current_;
  RecyclingList<Reference> history_;  ///< newest first
  InconsistencyTest<Camera, Noise> test_;
  Inconsistency inconsistency_;
  SupportingPlanes planes_;
  RegionGrower grower_;
  RegionPainter painter_;
  Image<std::uint8_t> rows_, extremes_;            ///< scratch
  Image<std::uint8_t> covered_, followed_, seen_;  ///< cells; `seen_`: regions of the last frame, with a margin
};

DOT_END_NAMESPACE
