// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "dot/abi.hpp"
#include "dot/camera_motion/cell_change.hpp"
#include "dot/frame/frame_data.hpp"
#include "dot/image/image.hpp"
#include "dot/kernel/kernels.hpp"
#include "dot/threads/threads.hpp"

DOT_BEGIN_NAMESPACE

/// Tells which edges of the image stay where they are while others move.
///
/// The gradient g of each pixel is summed over the frames: sum g, and the sum of its lengths |g| = |gx| + |gy|. Where
/// |sum g| is nearly sum |g| an edge has stayed. Only frames count in which many edges are others than in the last one
/// that counted. So a camera that stands changes nothing, for however long, and the frame rate does not matter. The
/// sums are of cells of a coarse level of the pyramid.
class StandingEdges {
 public:
  static constexpr int kCell = 4;             ///< pixels of the level, size of a cell
  static constexpr int kMostPixels = 120000;  ///< of the level: lines drawn into the image are 1/200 of its height
  static constexpr int kFewPixels = 30000;    ///< of an image of which the finest level is taken, though it is noisy
  static constexpr double kMemory = 0.6;      ///< seconds, time constant of the fading
  static constexpr int kEnoughFrames = 3;     ///< that count, from which the sums tell something
  static constexpr float kKeep = 0.8f;  ///< of what its edges should have crossed, from a frame that counts to the next
  static constexpr int kLeastCells = 20;  ///< with edges, to tell whether they move

  /// Which pixels of a cell count.
  enum class Pixels {
    All,     ///< each pixel
    Staying  ///< those whose edges have stayed
  };

  /// Looks at the next frame. @param background zero where objects are, of full size. @return whether it counts.
  bool add(const FrameData& frame, const Image<std::uint8_t>& background, const kernel::Kernels& kernels,
           const Threads& threads) {
    choose_level(frame.pyramid);
    reserve_columns(threads);
    const Image<std::uint8_t>& image = frame.pyramid.levels[level_];
    const double seconds = frame.timestamp - timestamp_;
    if (columns_ < 1 || rows_ < 1 || frame.is_repeated() || (frames_ > 0 && seconds < kShortest)) return false;
    mark_objects(background);
    if (frames_ > 0 && !has_changed(image, kernels, threads)) return false;
    std::swap(newest_, before_);
    newest_ = image;
    if (frames_ == 0) clear_sums();
    const double fade = frames_ > 0 ? 1 - std::exp(-std::min(seconds, kLongest) / kMemory) : 0;
    frames_ = std::min(frames_ + 1, kEnoughFrames);
    timestamp_ = frame.timestamp;
    sum(image, fade, kernels, threads);
    return true;
  }

  /// Whether there is a frame that counted before the newest.
  bool has_two_frames() const { return frames_ > 1; }
  /// Whether enough frames have counted.
  bool is_known() const { return frames_ >= kEnoughFrames; }
  /// Level of the pyramid.
  std::size_t level() const { return level_; }
  /// Columns of pixels of the level.
  int width() const { return width_; }
  /// Rows of pixels of the level.
  int height() const { return height_; }
  /// Columns of cells. A cell begins at the pixel (1 + kCell column, 1 + kCell row) of the level.
  int columns() const { return columns_; }
  /// Rows of cells.
  int rows() const { return rows_; }
  /// Place of a cell in the arrays of cells.
  std::size_t index(int column, int row) const { return at(column, row, columns_); }
  /// Whether a cell has edges, and no object.
  bool has_edges(std::size_t cell) const { return all_[cell] > 0 && !objects_[cell]; }
  /// Whether the middle of a cell is on an object.
  bool has_object(std::size_t cell) const { return objects_[cell] != 0; }
  /// Whether a cell has edges that may be an object's.
  bool has_any_edges(std::size_t cell) const { return all_[cell] > 0; }
  /// Whether edges may have stayed on a part of a cell.
  bool stays_in_part(std::size_t cell) const { return stay_[cell] > kStaysInPart * all_[cell]; }
  /// The pixels of a cell whose edges have stayed, a bit each, by rows.
  std::uint16_t staying_pixels(int column, int row) const {
    static_assert(kCell * kCell <= 16);
    unsigned pixels = 0;
    for (int v = 0; v < kCell; ++v) {
      const std::uint8_t* stays = staying_.row(1 + row * kCell + v) + 1 + column * kCell;
      for (int u = 0; u < kCell; ++u) pixels |= static_cast<unsigned>(stays[u]) << (v * kCell + u);
    }
    return static_cast<std::uint16_t>(pixels);
  }
  /// Whether its edges are others than in the frame that counted before the newest.
  bool is_other(std::size_t cell) const { return change_[cell] == kChangedEdge; }
  /// Whether its edges have stayed.
  bool stays(std::size_t cell) const { return stay_[cell] > kStays * all_[cell]; }
  /// Whether its edges have moved.
  bool moves(std::size_t cell) const { return stay_[cell] < kMoves * all_[cell]; }

  /// The pixel of an image of full size in the middle of a cell.
  template <typename T>
  const T& in_middle(const Image<T>& full, int column, int row) const {
    const int size = kCell << level_, middle = (1 + kCell / 2) << level_;
    return full(column * size + middle, row * size + middle);
  }

  /// Pixels by which a shift by (du, dv), pixels of the level, moves a cell's edges across themselves; at most
  /// kMostShift.
  float crossing(int column, int row, float du, float dv, Pixels pixels = Pixels::All) const {
    const float length = std::sqrt(du * du + dv * dv);
    if (length > kMostShift) du *= kMostShift / length, dv *= kMostShift / length;
    float moved = 0, all = 0;
    for (int v = 1 + row * kCell; v <= (row + 1) * kCell; ++v)
      for (int u = 1 + column * kCell; u <= (column + 1) * kCell; ++u) {
        if (pixels == Pixels::Staying && !staying_(u, v)) continue;
        const std::size_t i = at(u, v, width_);
        const auto x = static_cast<float>(x_[i]), y = static_cast<float>(y_[i]);
        moved += std::abs(x * du + y * dv);
        all += std::sqrt(x * x + y * y);
      }
    return all > 0 ? moved / all : 0;
  }

  /// The change of a cell since the frame that counted before the newest, with a shift to it by (du, dv), pixels of the
  /// level. Zero if the shift leads out of the image.
  CellChange change(int column, int row, float du, float dv, Pixels pixels = Pixels::All) const {
    const int u = 1 + column * kCell, v = 1 + row * kCell;
    const float x = static_cast<float>(u) + du, y = static_cast<float>(v) + dv;
    static_assert(kCell == CellChange::kSize);
    constexpr auto kSize = static_cast<float>(kCell);
    if (!(x >= 0 && y >= 0 && x + kSize < static_cast<float>(width_) && y + kSize < static_cast<float>(height_)))
      return {};
    return CellChange::between(newest_, before_, pixels == Pixels::All ? nullptr : &staying_, u, v, x, y);
  }

  /// Forgets all frames. Keeps the memory.
  void forget() noexcept { frames_ = 0; }

 private:
  static constexpr double kShortest = 0.06;  ///< seconds between frames that count
  static constexpr double kLongest = 0.2;    ///< seconds by which a frame fades the sums at most: a pause is no motion
  static constexpr int kEdge = 4;            ///< grey values over two pixels, |gx| + |gy|
  static constexpr float kStays = 0.95f, kMoves = 0.75f;  ///< |sum g| over sum |g|
  static constexpr float kStaysInPart = 0.5f;  ///< the same, of a cell with other edges beside those that stay
  static constexpr float kMostShift = 1.5f;    ///< pixels of the level: longer shifts tell no more
  static constexpr float kOther = 0.4f;        ///< |g - g'| over |g| + |g'|, from which an edge is another one
  static constexpr double kChanged = 0.25;     ///< share of the cells with other edges, from which a frame counts

  static constexpr std::uint8_t kSameEdge = 1, kChangedEdge = 2;  ///< of `change_`; 0: the cell has no edges

  /// Sums of the columns of a row of cells: scratch.
  struct Columns {
    explicit Columns(std::size_t width) : part(width), all(width) {}
    std::vector<std::uint16_t> part, all;
  };

  static std::size_t at(int column, int row, int columns) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }

  void choose_level(const Pyramid& pyramid) {
    const auto pixels = [&](std::size_t l) { return pyramid.levels[l].width() * pyramid.levels[l].height(); };
    std::size_t level = pyramid.levels.size() > 1 && pixels(0) > kFewPixels ? 1 : 0;
    while (level + 1 < pyramid.levels.size() && pixels(level) > kMostPixels) ++level;
    const int width = pyramid.levels[level].width(), height = pyramid.levels[level].height();
    if (width == width_ && height == height_ && level == level_) return;
    const int columns = std::max(0, width - 2) / kCell, rows = std::max(0, height - 2) / kCell;
    forget();
    for (auto* a : {&x_, &y_, &length_}) a->assign(at(0, height, width), 0);
    for (auto* a : {&stay_, &all_}) a->assign(at(0, rows, columns), 0.f);
    columns_of_.clear();
    staying_.resize(width, height);
    staying_.fill(0);
    for (auto* a : {&objects_, &change_}) a->assign(at(0, rows, columns), 0);
    // Set after the calls that may throw, so that the size is always correct.
    level_ = level, width_ = width, height_ = height, columns_ = columns, rows_ = rows;
  }

  void clear_sums() {
    for (auto* a : {&x_, &y_, &length_}) std::fill(a->begin(), a->end(), std::int16_t{0});
  }

  /// Marks the cells whose middle is on an object.
  void mark_objects(const Image<std::uint8_t>& background) {
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        objects_[index(column, row)] = in_middle(background, column, row) == 0;
  }

  void reserve_columns(const Threads& threads) {
    const auto workers = static_cast<std::size_t>(std::max(1, threads.count));
    if (columns_of_.size() != workers) columns_of_.assign(workers, Columns(static_cast<std::size_t>(width_)));
  }

  /// Calls visit(cell, part, all) with the sums over each cell of what add_row(v, columns) has added to its rows v,
  /// from the second pixel on. The calls are of several threads.
  template <typename AddRow, typename Visit>
  void for_each_cell(int row_step, const Threads& threads, AddRow&& add_row, Visit&& visit) {
    threads.run_bands(rows_, [&](int worker, int begin, int end) {
      Columns& columns = columns_of_[static_cast<std::size_t>(worker)];
      for (int row = begin; row < end; ++row) {
        std::fill(columns.part.begin(), columns.part.end(), std::uint16_t{0});
        std::fill(columns.all.begin(), columns.all.end(), std::uint16_t{0});
        for (int v = 1 + row * kCell; v <= (row + 1) * kCell; v += row_step)
          add_row(v, {columns.part.data(), columns.all.data()});
        for (int column = 0; column < columns_; ++column) {
          int part = 0, all = 0;
          for (std::size_t i = static_cast<std::size_t>(column) * kCell, last = i + kCell; i < last; ++i)
            part += columns.part[i], all += columns.all[i];
          visit(index(column, row), part, all);
        }
      }
    });
  }

  static kernel::ThreeRows rows_about(const Image<std::uint8_t>& image, int v) {
    return {image.row(v - 1) + 1, image.row(v) + 1, image.row(v + 1) + 1};
  }

  /// Whether many edges of the background are others than in the last frame that counted.
  bool has_changed(const Image<std::uint8_t>& image, const kernel::Kernels& kernels, const Threads& threads) {
    constexpr int kStep = 2;  // rows
    for_each_cell(
        kStep, threads,
        [&](int v, const kernel::EdgeColumns& columns) {
          kernels.compare_edges(rows_about(image, v), rows_about(newest_, v), width_ - 2, columns);
        },
        [&](std::size_t cell, int other, int all) {
          const bool is_edge = all > 2 * kEdge * kCell * kCell / kStep && !objects_[cell];
          const bool is_changed = static_cast<float>(other) > kOther * static_cast<float>(all);
          change_[cell] = !is_edge ? 0 : is_changed ? kChangedEdge : kSameEdge;
        });
    int edges = 0, changed = 0;
    for (const std::uint8_t change : change_) edges += change != 0, changed += change == kChangedEdge;
    return edges >= kLeastCells && changed > kChanged * edges;
  }

  /// Adds a frame to the sums. @param fade share of the sums that is dropped.
  void sum(const Image<std::uint8_t>& image, double fade, const kernel::Kernels& kernels, const Threads& threads) {
    weight_ = frames_ > 1 ? weight_ - weight_ * static_cast<float>(fade) + 1 : 1;
    kernel::EdgeSums sums;
    sums.fade = static_cast<short>(65536 * fade);
    sums.edge = static_cast<short>(kEdge * kernel::kEdgeUnit * weight_);
    for_each_cell(
        1, threads,
        [&](int v, const kernel::EdgeColumns& columns) {
          const std::size_t first = at(1, v, width_);
          kernel::EdgeSums row = sums;
          row.x = x_.data() + first, row.y = y_.data() + first, row.length = length_.data() + first;
          kernels.sum_edges(rows_about(image, v), width_ - 2, row, columns, staying_.row(v) + 1);
        },
        [&](std::size_t cell, int stay, int all) {
          stay_[cell] = static_cast<float>(stay), all_[cell] = static_cast<float>(all);
        });
  }

  std::size_t level_ = 0;
  int width_ = 0, height_ = 0, columns_ = 0, rows_ = 0;
  int frames_ = 0;                              ///< that counted, at most kEnoughFrames
  double timestamp_ = 0;                        ///< of the last one that counted, seconds
  float weight_ = 0;                            ///< of all frames in the sums
  Image<std::uint8_t> newest_, before_;         ///< the last two frames that counted
  std::vector<std::int16_t> x_, y_, length_;    ///< of each pixel: the sums of kernel::EdgeSums
  Image<std::uint8_t> staying_;                 ///< 1: an edge that has stayed
  std::vector<float> stay_, all_;               ///< of each cell: |sum g| and sum |g| of its edges
  std::vector<Columns> columns_of_;             ///< of each worker
  std::vector<std::uint8_t> objects_, change_;  ///< of each cell: whether it is on an object; its edges' change
};

DOT_END_NAMESPACE
