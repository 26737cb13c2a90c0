// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "dot/image/image.hpp"
#include "dot/mask/depth_range.hpp"
#include "dot/mask/mask.hpp"

DOT_BEGIN_NAMESPACE

/// Takes other surfaces out of masks that are too wide: boxes of a detector, or masks of a coarse network.
///
/// The object is what the middle of its mask shows. A part of the mask is another surface if its depth is beyond the
/// object's range, it touches the mask's border, and its depth jumps where it meets the object. A long lorry is also
/// beyond the range, but no jump separates its ends from its middle.
///
/// A window or an error of the depth looks like another surface, too. So nothing is taken out unless the masks so far
/// have shown more of them than masks that fit do.
///
/// It works on a grid over the mask's box, so that a large mask costs as little as a small one.
class DepthTrimmer {
 public:
  /// Mean share of other surfaces in the masks so far, 0 to 1; 0 as long as these may fit.
  double wide_share() const { return are_wide() ? shares_ / masks_ : 0; }

  /// Forgets the masks so far.
  void forget() noexcept { shares_ = masks_ = 0; }

  /// Trims a mask, if masks are wide and `may_cut`. @param inverse_depth 1/m, of the frame; 0: not measured. @param
  /// focal pixels.
  /// @return 1/m, the object's depth; 0 if there is too little depth.
  template <typename Noise>
  float trim(const Image<float>& inverse_depth, double focal, const Noise& noise, Mask& mask, bool may_cut = true) {
    sample(mask, inverse_depth);
    const std::optional<Spread<float>> core = core_depth();
    if (!core) return 0;
    const float size = static_cast<float>(std::max(mask.width(), mask.height()) / focal) / core->middle;
    const float slack = kSlack * static_cast<float>(noise.pixel_sigma(core->middle)) + kDepthError * core->middle;
    const DepthRange range = depth_range(*core, std::max(usual_extent(*core), size), slack);
    count(find_parts(range));
    if (may_cut && are_wide()) cut_parts(inverse_depth, range, mask);
    return core->middle;
  }

  /// Gives pixels that are set in two masks to the object whose depth they have. Where that is not clear, both keep
  /// them: two masks of one object stay as they are.
  /// @param q_a, q_b depths of the objects, 1/m.
  template <typename Noise>
  void separate(const Image<float>& inverse_depth, const Noise& noise, float q_a, float q_b, Mask& a, Mask& b) {
    const float nearer = std::max(q_a, q_b);
    const float doubt = kSlack * static_cast<float>(noise.pixel_sigma(nearer)) + kSameDepth * nearer;
    if (!(q_a > 0) || !(q_b > 0) || std::abs(q_a - q_b) <= doubt) return;
    const int left = std::max(a.x, b.x), right = std::min(a.x + a.width(), b.x + b.width());
    const int top = std::max(a.y, b.y), bottom = std::min(a.y + a.height(), b.y + b.height());
    int lost_a = 0, lost_b = 0;
    for (int v = top; v < bottom; ++v)
      for (int u = left; u < right; ++u) {
        std::uint8_t &in_a = a.pixels(u - a.x, v - a.y), &in_b = b.pixels(u - b.x, v - b.y);
        const float q = inverse_depth(u, v);
        if (!in_a || !in_b || !(q > 0)) continue;
        const float to_a = std::abs(q - q_a), to_b = std::abs(q - q_b);
        if (to_b + doubt < to_a) in_a = 0, ++lost_a;
        if (to_a + doubt < to_b) in_b = 0, ++lost_b;
      }
    if (lost_a > 0) tighten(a);
    if (lost_b > 0) tighten(b);
  }

 private:
  static constexpr float kSlack = 4;             // in sigmas of the depth
  static constexpr float kDepthError = 0.03f;    // of a depth that the noise does not tell of, relative
  static constexpr float kSameDepth = 0.05f;     // relative difference of depths that belong to one object
  static constexpr float kJump = 1.1f;           // ratio of two depths that no surface joins within two cells
  static constexpr double kMostCells = 2000;     // of the grid
  static constexpr std::size_t kLeastCells = 9;  // of a part
  static constexpr double kWide = 0.03;          // mean share; of masks that fit .02 at most, of boxes .04 to .07
  static constexpr double kDoubt = 10;           // masks that fit, assumed before the first

  enum class Cell : std::uint8_t { Outside, Unmeasured, Object, Beyond, Kept, Removed };

  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y + kRim) * static_cast<std::size_t>(stride_) + static_cast<std::size_t>(x + kRim);
  }

  /// Reads the grid's cells, with a rim outside the mask.
  void sample(const Mask& mask, const Image<float>& inverse_depth) {
    step_ = std::max(
        1, static_cast<int>(std::ceil(std::sqrt(mask.width() * static_cast<double>(mask.height()) / kMostCells))));
    width_ = (mask.width() + step_ - 1) / step_;
    height_ = (mask.height() + step_ - 1) / step_;
    stride_ = width_ + 2 * kRim;
    const std::size_t size = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height_ + 2 * kRim);
    q_.assign(size, 0);
    cells_.assign(size, Cell::Outside);
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        if (!mask.pixels(x * step_, y * step_)) continue;
        const float q = inverse_depth(mask.x + x * step_, mask.y + y * step_);
        q_[at(x, y)] = q;
        cells_[at(x, y)] = q > 0 ? Cell::Object : Cell::Unmeasured;
      }
  }

  /// Depths of the inner half of the mask: the cells that are farthest from its border.
  std::optional<Spread<float>> core_depth() {
    constexpr std::size_t kEnough = 10;
    distance_.assign(cells_.size(), 0);
    const std::size_t up = static_cast<std::size_t>(stride_);
    const auto farther = [](std::uint8_t d) { return static_cast<std::uint8_t>(d < 255 ? d + 1 : 255); };
    for (int y = 0; y < height_; ++y)
      for (std::size_t i = at(0, y), end = at(width_, y); i < end; ++i)
        if (cells_[i] != Cell::Outside) distance_[i] = farther(std::min(distance_[i - 1], distance_[i - up]));
    std::array<int, 256> count{};
    int all = 0;
    for (int y = height_ - 1; y >= 0; --y)
      for (std::size_t i = at(width_, y); i-- > at(0, y);) {
        if (cells_[i] == Cell::Outside) continue;
        distance_[i] = std::min(distance_[i], farther(std::min(distance_[i + 1], distance_[i + up])));
        ++count[distance_[i]];
        ++all;
      }
    std::uint8_t least = 255;
    for (int more = 0; least > 1 && 2 * (more += count[least]) < all;) --least;
    values_.clear();
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if (distance_[i] >= least && cells_[i] == Cell::Object) values_.push_back(q_[i]);
    if (values_.size() < kEnough) return std::nullopt;
    return spread(values_.begin(), values_.end());
  }

  /// Marks the parts that show another surface. @return their share of the mask.
  double find_parts(const DepthRange& range) {
    std::size_t all = 0, beyond = 0, removed = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      all += cells_[i] != Cell::Outside;
      if (cells_[i] != Cell::Object || range.holds(q_[i])) continue;
      cells_[i] = Cell::Beyond;
      ++beyond;
    }
    if (beyond < kLeastCells) return 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (cells_[i] != Cell::Beyond || !is_other_surface(i)) continue;
      for (const std::size_t j : part_) cells_[j] = Cell::Removed;
      removed += part_.size();
    }
    return static_cast<double>(removed) / static_cast<double>(all);
  }

  /// Counts a mask. Later ones count more.
  void count(double share) {
    constexpr double kMemory = 100;  // masks
    const double kept = std::min(1.0, kMemory / (masks_ + 1));
    shares_ = kept * shares_ + share;
    masks_ = kept * masks_ + 1;
  }

  bool are_wide() const { return shares_ > kWide * (masks_ + kDoubt); }

  /// Collects the part that a cell belongs to.
  bool is_other_surface(std::size_t first) {
    part_.assign(1, first);
    cells_[first] = Cell::Kept;
    bool at_border = false;
    std::size_t touching = 0, jumps = 0;
    for (std::size_t n = 0; n < part_.size(); ++n) {
      const std::size_t i = part_[n];
      for (const std::size_t j :
           {i - 1, i + 1, i - static_cast<std::size_t>(stride_), i + static_cast<std::size_t>(stride_)}) {
        at_border |= cells_[j] == Cell::Outside;
        if (cells_[j] != Cell::Beyond) continue;
        cells_[j] = Cell::Kept;
        part_.push_back(j);
      }
      const std::optional<bool> jump = jumps_at(i);
      touching += jump.has_value();
      jumps += jump.value_or(false);
    }
    return part_.size() >= kLeastCells && at_border && 4 * jumps >= touching;
  }

  /// Whether the depth jumps between a cell and all cells of the object near it; nothing if there are none.
  std::optional<bool> jumps_at(std::size_t i) const {
    const int reach = step_ == 1 ? kRim : 1;  // depth is smeared over a few pixels of an edge
    std::optional<bool> jump;
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const std::size_t j = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + dy * stride_ + dx);
        if (cells_[j] != Cell::Object) continue;
        if (std::max(q_[i], q_[j]) <= kJump * std::min(q_[i], q_[j])) return false;
        jump = true;
      }
    return jump;
  }

  /// Takes the pixels beyond the range that are beside a removed cell out of the mask.
  void cut_parts(const Image<float>& inverse_depth, const DepthRange& range, Mask& mask) {
    fill_mask(
        mask.box(),
        [&](int u, int v) {
          const int x = u - mask.x, y = v - mask.y;
          if (!mask.pixels(x, y)) return false;
          const float q = inverse_depth(u, v);
          if (!(q > 0) || range.holds(q)) return true;
          return !is_beside_removed(at(x / step_, y / step_));
        },
        trimmed_);
    std::swap(mask, trimmed_);
  }

  /// Whether a cell or one beside it was removed. Pixels are compared with the cell above them to the left.
  bool is_beside_removed(std::size_t cell) const {
    if (step_ == 1) return cells_[cell] == Cell::Removed;
    for (int dy = -1; dy <= kRim; ++dy)
      for (int dx = -1; dx <= kRim; ++dx)
        if (cells_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + dy * stride_ + dx)] == Cell::Removed)
          return true;
    return false;
  }

  void tighten(Mask& mask) {
    fill_mask(
        mask.box(), [&mask](int u, int v) { return mask.pixels(u - mask.x, v - mask.y) != 0; }, trimmed_);
    std::swap(mask, trimmed_);
  }

  static constexpr int kRim = 2;  // cells about the grid, so that every cell has neighbours

  int step_ = 1;                        // pixels from cell to cell
  int width_ = 0;                       // cells
  int height_ = 0;                      // cells
  int stride_ = 0;                      // cells, with the rim
  std::vector<float> q_;                // 1/m
  std::vector<Cell> cells_;             // what each is
  std::vector<std::uint8_t> distance_;  // cells to the mask's border, 1 beside it
  std::vector<float> values_;           // 1/m
  std::vector<std::size_t> part_;       // cells of a part
  double shares_ = 0;                   // sum over the masks, the older ones faded
  double masks_ = 0;                    // their number, faded alike
  Mask trimmed_;                        // scratch
};

DOT_END_NAMESPACE
