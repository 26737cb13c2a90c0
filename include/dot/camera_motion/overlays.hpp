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
  /// Looks at the next frame that counted. @param shift by the camera's motion, which is sure, since the one before.
  /// @param ids of the objects, 0 = background, of full size.
  template <typename Camera>
  void look(const StandingEdges& edges, const CellShift<Camera>& shift, const Image<std::uint32_t>& ids) {
    resize(edges);
    if (!edges.is_known()) return;
    on_objects_.clear();
    bool any = false;
    for (int row = 0; row < edges.rows(); ++row)
      for (int column = 0; column < edges.columns(); ++column) {
        const std::size_t i = edges.index(column, row);
        Cell& cell = cells_[i];
        if (!edges.has_any_edges(i)) {
          cell = {};
          continue;
        }
        cell.staying = edges.stays_in_part(i) ? edges.staying_pixels(column, row) : std::uint16_t{0};
        const std::uint32_t id = edges.has_object(i) ? edges.in_middle(ids, column, row) : 0;
        if (count_bits(cell.staying) < kLeastPixels) {
          cell = {};
        } else {
          if (!is_overlaid(cell))
            cell.crossed = StandingEdges::kKeep * cell.crossed + crossing(edges, shift, column, row, cell.staying);
          if (id != cell.id && id != 0) cell.was_first = std::binary_search(ids_.begin(), ids_.end(), id);
        }
        cell.id = id;
        cell.marked = is_overlaid(cell);
        any |= cell.marked;
        if (id != 0) on_objects_.push_back({id, i});
      }
    std::sort(on_objects_.begin(), on_objects_.end(),
              [](const OnObject& a, const OnObject& b) { return std::pair(a.id, a.cell) < std::pair(b.id, b.cell); });
    keep_objects();
    pixels_.set(any ? 1 << edges.level() : 0, edges.width(), edges.height());
    if (any) mark(edges);
  }

  /// The pixels of overlays.
  const OverlaidPixels& pixels() const { return pixels_; }

  /// Forgets everything. Keeps the memory.
  void forget() noexcept {
    std::fill(cells_.begin(), cells_.end(), Cell{});
    ids_.clear();
    pixels_.clear();
  }

 private:
  static constexpr float kCrossed = 2;    ///< pixels of the level that an edge should have moved across itself
  static constexpr int kLeastPixels = 3;  ///< of a cell, that stay

  struct Cell {
    float crossed = 0;          ///< pixels of the level by which its staying edges should have moved across themselves
    std::uint16_t staying = 0;  ///< its pixels whose edges stay
    std::uint32_t id = 0;       ///< of the object there, 0 = background
    bool was_first = false;     ///< whether its edges stayed while that object came there
    bool marked = false;        ///< whether its staying pixels are an overlay's
  };
  struct OnObject {
    std::uint32_t id = 0;
    std::size_t cell = 0;
  };

  static bool is_overlaid(const Cell& cell) { return cell.crossed > kCrossed; }

  void resize(const StandingEdges& edges) {
    const std::size_t cells = edges.index(0, edges.rows());
    if (cells_.size() == cells) return;
    on_objects_.reserve(cells);
    ids_.reserve(cells);
    pixels_.set(1 << edges.level(), edges.width(), edges.height());
    pixels_.clear();
    cells_.assign(cells, {});
  }

  static int count_bits(unsigned bits) {
    int n = 0;
    for (; bits; bits &= bits - 1) ++n;
    return n;
  }

  /// Pixels by which the camera's motion should have moved the edges of some pixels across themselves; 0 if it is not
  /// known, or if it explains how they changed.
  template <typename Camera>
  static float crossing(const StandingEdges& edges, const CellShift<Camera>& cell_shift, int column, int row,
                        std::uint16_t pixels) {
    Vector2<float> shift;
    // Beside a near object the edges may be of what is far behind it, and stay.
    if (!cell_shift(column, row, cell_shift.farthest(column, row), shift)) return 0;
    if (!edges.change(column, row, shift.x(), shift.y(), pixels).is_contradicted()) return 0;
    return edges.crossing(column, row, shift.x(), shift.y(), pixels);
  }

  /// Leaves the edges to each object of which more than half would be an overlay's. Remembers the objects.
  void keep_objects() {
    ids_.clear();
    for (auto first = on_objects_.begin(); first != on_objects_.end();) {
      const auto last = std::find_if(first, on_objects_.end(), [&](const OnObject& o) { return o.id != first->id; });
      const auto marked = std::count_if(first, last, [&](const OnObject& o) { return cells_[o.cell].marked; });
      if (2 * marked > last - first)
        for (auto o = first; o != last; ++o) cells_[o->cell].marked &= cells_[o->cell].was_first;
      ids_.push_back(first->id);
      first = last;
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
  std::vector<OnObject> on_objects_;  ///< cells with edges, by object: scratch
  std::vector<std::uint32_t> ids_;    ///< of the objects in the frame before, sorted
  OverlaidPixels pixels_;
};

DOT_END_NAMESPACE
