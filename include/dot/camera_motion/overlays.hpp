// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "dot/camera_motion/cell_shift.hpp"
#include "dot/camera_motion/standing_edges.hpp"
#include "dot/image/image.hpp"
#include "dot/points/overlaid_pixels.hpp"
#include "dot/threads/threads.hpp"

DOT_BEGIN_NAMESPACE

/// Finds what is drawn over the image: a time stamp, a cross hair, the instruments of a drone, a logo. It is often
/// small and on objects. With points on it an object that stands seems to move with the camera.
///
/// Edges of an overlay stay in the image, whatever is behind them, though the camera's motion should have moved what
/// stands there across them. A place where this was found is remembered until its edges move, whatever comes there.
///
/// Edges of an object that moves with the camera, like a car ahead, stay as well. So an object keeps its edges if more
/// than half of them would be an overlay's, but for those that stayed while it came there.
class Overlays {
 public:
  /// Takes the next frame that counted into account. @param shift by the camera's motion, which is sure, since the one
  /// before.
  /// @param ids of the objects, 0 = background, of full size.
  template <typename Camera>
  void update(const StandingEdges& edges, const CellShift<Camera>& shift, const Image<std::uint32_t>& ids,
              const Threads& threads) {
    resize(edges);
    if (!edges.is_known()) return;
    std::swap(objects_, before_);
    objects_.clear();
    threads.run_bands(edges.rows(), [&](int, int begin, int end) {
      for (int row = begin; row < end; ++row)
        for (int column = 0; column < edges.columns(); ++column) update_cell(edges, shift, ids, column, row);
    });
    bool any = false;
    for (const Cell& cell : cells_) {
      any |= cell.marked;
      if (cell.id != 0) count(cell);
    }
    if (any) keep_objects();
    pixels_.set(any ? 1 << edges.level() : 0, edges.width(), edges.height());
    if (any) mark(edges);
  }

  /// The pixels of overlays.
  const OverlaidPixels& pixels() const { return pixels_; }

  /// Forgets everything. Keeps the memory.
  void forget() noexcept {
    std::fill(cells_.begin(), cells_.end(), Cell{});
    objects_.clear();
    pixels_.clear();
  }

 private:
  static constexpr float kCrossed = 2;  ///< pixels of the level that an edge should have moved across itself

  struct Cell {
    float crossed = 0;          ///< pixels of the level by which its staying edges should have moved across themselves
    std::uint16_t staying = 0;  ///< its pixels whose edges stay
    std::uint32_t id = 0;       ///< of the object there, 0 = background
    bool was_first = false;     ///< whether its edges stayed while that object came there
    bool marked = false;        ///< whether its staying pixels are an overlay's
  };
  struct Object {
    std::uint32_t id = 0;
    int cells = 0;   ///< with edges
    int marked = 0;  ///< of these, whose staying pixels would be an overlay's
  };

  template <typename Camera>
  void update_cell(const StandingEdges& edges, const CellShift<Camera>& shift, const Image<std::uint32_t>& ids,
                   int column, int row) {
    const std::size_t i = edges.index(column, row);
    Cell& cell = cells_[i];
    if (!edges.has_any_edges(i)) {
      cell = {};
      return;
    }
    cell.staying = edges.stays_in_part(i) ? edges.staying_pixels(column, row) : std::uint16_t{0};
    const std::uint32_t id = edges.has_object(i) ? edges.in_middle(ids, column, row) : 0;
    if (!has_enough(cell.staying)) {
      cell = {};
    } else {
      if (!is_overlaid(cell)) cell.crossed = StandingEdges::kKeep * cell.crossed + crossing(edges, shift, column, row);
      if (id != cell.id && id != 0) cell.was_first = is_among(before_, id);
    }
    cell.id = id;
    cell.marked = is_overlaid(cell);
  }

  static bool is_overlaid(const Cell& cell) { return cell.crossed > kCrossed; }

  void resize(const StandingEdges& edges) {
    const std::size_t cells = edges.index(0, edges.rows());
    if (cells_.size() == cells) return;
    for (auto* objects : {&objects_, &before_}) objects->reserve(cells);
    pixels_.set(1 << edges.level(), edges.width(), edges.height());
    pixels_.clear();
    cells_.assign(cells, {});
  }

  /// Whether three pixels or more stay.
  static bool has_enough(unsigned staying) {
    const unsigned without_one = staying & (staying - 1);
    return (without_one & (without_one - 1)) != 0;
  }

  static bool is_among(const std::vector<Object>& objects, std::uint32_t id) {
    return std::any_of(objects.begin(), objects.end(), [id](const Object& o) { return o.id == id; });
  }

  Object& object_of(const Cell& cell) {
    const auto is_its = [&](const Object& o) { return o.id == cell.id; };
    if (last_ < objects_.size() && is_its(objects_[last_])) return objects_[last_];  // as the cell beside it
    const auto at = std::find_if(objects_.begin(), objects_.end(), is_its);
    last_ = static_cast<std::size_t>(at - objects_.begin());
    if (at == objects_.end()) objects_.push_back({cell.id});
    return objects_[last_];
  }

  void count(const Cell& cell) {
    Object& object = object_of(cell);
    ++object.cells;
    object.marked += cell.marked;
  }

  /// Pixels by which the camera's motion should have moved the staying edges of a cell across themselves; 0 if it is
  /// not known, or if it explains how they changed.
  template <typename Camera>
  static float crossing(const StandingEdges& edges, const CellShift<Camera>& cell_shift, int column, int row) {
    constexpr auto kStaying = StandingEdges::Pixels::Staying;
    Vector2<float> shift;
    // Beside a near object the edges may be of what is far behind it, and stay.
    if (!cell_shift(column, row, cell_shift.farthest(column, row), shift)) return 0;
    if (!edges.change(column, row, shift.x(), shift.y(), kStaying).is_contradicted()) return 0;
    return edges.crossing(column, row, shift.x(), shift.y(), kStaying);
  }

  /// Leaves the edges to each object of which more than half would be an overlay's.
  void keep_objects() {
    for (Cell& cell : cells_) {
      if (!cell.marked || cell.id == 0) continue;
      const Object& object = object_of(cell);
      if (2 * object.marked > object.cells) cell.marked = cell.was_first;
    }
  }

  /// Marks the pixels that stay in cells with overlays and beside them.
  void mark(const StandingEdges& edges) {
    constexpr int kCell = StandingEdges::kCell;
    const int columns = edges.columns(), rows = edges.rows();
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        if (!cells_[edges.index(column, row)].marked) continue;
        for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
          for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
            for (int bit = 0; bit < kCell * kCell; ++bit)
              if ((cells_[edges.index(c, r)].staying >> bit) & 1)
                pixels_.add(1 + c * kCell + bit % kCell, 1 + r * kCell + bit / kCell);
      }
  }

  std::vector<Cell> cells_;
  std::vector<Object> objects_, before_;  ///< in the newest frame and in the one before
  std::size_t last_ = 0;                  ///< place in `objects_` of the one that was asked for last
  OverlaidPixels pixels_;
};

DOT_END_NAMESPACE
