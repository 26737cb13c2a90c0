// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "dot/camera_motion/camera_step.hpp"
#include "dot/camera_motion/cell_shift.hpp"
#include "dot/camera_motion/overlays.hpp"
#include "dot/camera_motion/standing_edges.hpp"
#include "dot/threads/threads.hpp"

DOT_BEGIN_NAMESPACE

/// Finds the parts of the image that do not move with the scene: the bonnet of the own car, an arm of the robot, the
/// border of an undistorted image, a caption, dirt on the lens. Their edges agree exactly with a camera that stands.
/// With points on them the camera's motion is zero, or turns about them.
///
/// What is far stays in the image as well, so an edge that stays is suspected only if many edges that are at least as
/// far move. What the camera moves to or turns about stays, too, and edges along their own motion in the image, such as
/// those of a road. The camera's motion tells these: by it they have not moved across themselves. But fixed parts may
/// have spoilt that motion. So suspected edges are excluded on trial if they are many, or if the motion is *refuted*:
/// it explains the change of less than a quarter of the others. A large moving object without a mask refutes a right
/// motion, too. So only edges that the refuted motion leaves where they are can have spoilt it. They are admitted again
/// if the motion that is measured without them explains that they stay. Where edges stay on more than a third of the
/// image, none becomes suspect: then the camera stands, and what moves is an object.
class FixedParts {
 public:
  static constexpr double kLeastShare = 0.04;  ///< of the cells with edges and depth; less does not hold the camera

  /// Takes the next frame into account. @param background zero where objects are, of full size. @param ids of the
  /// objects, 0 = background. @param step led to the frame.
  /// @return whether parts were found that have held the camera, so that its velocity is not known.
  template <typename Camera>
  bool update(const FrameData& frame, const Image<std::uint8_t>& background, const Image<std::uint32_t>& ids,
              const CameraStep& step, const Camera& camera, const kernel::Kernels& kernels, const Threads& threads) {
    T_cur_last_ = step.T_cur_prev * T_cur_last_;
    known_ = known_ && step.known();
    if (!edges_.add(frame, background, kernels, threads)) return false;
    resize(edges_.index(0, edges_.rows()));
    stood_ = step.known() && step.alignment.stands ? kTrial : std::max(0, stood_ - 1);
    scene_stays_ = stood_ > 0 || scene_stays();
    const CellShift<Camera> shift{edges_, T_cur_last_, frame.depth.levels[edges_.level()], camera};
    if (edges_.has_two_frames()) compare(shift, threads);
    if (known_ && !is_refuted() && !scene_stays_) overlays_.update(edges_, shift, ids, threads);
    T_cur_last_ = {};
    known_ = true;
    return edges_.is_known() && decide();
  }

  /// Share of the image that is fixed, after the trial; 0 if it is too small to matter.
  double share() const { return share_; }

  /// The pixels of overlays, also on objects.
  const OverlaidPixels& overlaid() const { return overlays_.pixels(); }

  /// Takes the fixed parts out of a mask of full size.
  void exclude(Image<std::uint8_t>& mask) const {
    overlaid().cut(0, 0, mask.view());
    if (!excludes_) return;
    const int pixel = 1 << edges_.level(), size = StandingEdges::kCell * pixel;
    // A gradient takes in the pixels beside it. The outermost cells reach to the ends of the image.
    const auto begin = [&](int cell) { return cell == 0 ? 0 : cell * size; };
    const auto end = [&](int cell, int cells, int all) {
      return cell + 1 == cells ? all : (cell + 1) * size + 2 * pixel;
    };
    for (int row = 0; row < edges_.rows(); ++row)
      for (int column = 0; column < edges_.columns(); ++column) {
        if (!fixed_[edges_.index(column, row)]) continue;
        const int left = begin(column), right = end(column, edges_.columns(), mask.width());
        for (int v = begin(row); v < end(row, edges_.rows(), mask.height()); ++v)
          std::memset(mask.row(v) + left, 0, static_cast<std::size_t>(right - left));
      }
  }

  /// Forgets everything. Keeps the memory.
  void forget() noexcept {
    edges_.forget();
    overlays_.forget();
    for (Cell& cell : cells_) cell = {};
    T_cur_last_ = {};
    known_ = true, compared_ = false, excludes_ = false, scene_stays_ = false;
    refuted_ = 0;
    stood_ = 0;
    share_ = 0;
  }

 private:
  static constexpr float kHeld = 1;         ///< pixels of the level: a motion that a part holds moves that part by less
  static constexpr float kCrossed = 2.5f;   ///< pixels of the level that an edge should have moved across itself
  static constexpr float kSuspected = 5;    ///< the same, assumed where the motion is refuted: a trial of four frames
  static constexpr int kLeastCompared = 5;  ///< cells
  static constexpr int kTrial = 8;          ///< frames that count, after which a trial is over
  static constexpr double kMoving = 0.4;    ///< share of the cells with edges: some of them stay in any scene
  static constexpr double kMostShare = 1.0 / 3;  ///< of the image: what stays on more of it is the scene
  static constexpr double kManyShare = 0.08;  ///< of the image, that is excluded on trial though the motion seems right
  static constexpr std::size_t kFarther = 2;  ///< bins
  static constexpr std::size_t kBins = 96;    ///< of the inverse depth, four an octave

  struct Cell {
    float q = 0;        ///< 1/m; 0: it has no depth, no edges, or an object
    float crossed = 0;  ///< pixels of the level by which its edges should have moved across themselves
    int tried = 0;      ///< frames that count since it was excluded on trial, 0: it was not
    float shift = 0;    ///< pixels of the level by which the camera's last motion moved it; 0: not known
  };

  static constexpr std::uint8_t kFixed = 1, kBeside = 2;

  void resize(std::size_t cells) {
    if (cells_.size() == cells) return;
    fixed_.assign(cells, 0);
    cells_.assign(cells, {});
  }

  /// Adds what the camera's motion since the last frame that counted should have done to the cells' edges.
  template <typename Camera>
  void compare(const CellShift<Camera>& cell_shift, const Threads& threads) {
    std::atomic<int> changed{0}, explained{0};  // cells
    threads.run_bands(edges_.rows(), [&](int, int begin, int end) {
      Compared all;
      for (int row = begin; row < end; ++row)
        for (int column = 0; column < edges_.columns(); ++column) compare(cell_shift, column, row, all);
      changed += all.changed, explained += all.explained;
    });
    if (!known_ || changed < kLeastCompared) return;
    constexpr float kShareOfNew = 0.3f;
    refuted_ += (compared_ ? kShareOfNew : 1) * ((4 * explained < changed ? 1.f : 0.f) - refuted_);
    compared_ = true;
  }

  struct Compared {
    int changed = 0;    ///< cells with other edges
    int explained = 0;  ///< of these, whose change the camera's motion explains
  };

  /// The same, of a cell.
  template <typename Camera>
  void compare(const CellShift<Camera>& cell_shift, int column, int row, Compared& all) {
    constexpr int kEvery = 3;  // of the cells are enough
    const std::size_t i = edges_.index(column, row);
    Cell& cell = cells_[i];
    cell.q = edges_.has_edges(i) ? cell_shift.nearest(column, row) : 0;
    cell.shift = 0;
    const bool moves = edges_.moves(i);
    if (moves) cell.crossed = 0, cell.tried = 0;
    if (known_ && !is_refuted()) {
      cell.crossed *= StandingEdges::kKeep;
      if (cell.tried > 0) cell.tried = std::min(cell.tried + 1, kTrial);
    }
    const bool tells = edges_.is_other(i) && (row + column) % kEvery == 0;
    const bool is_asked = !moves && (cell.tried > 0 || edges_.stays(i));
    if (!known_ || !(tells || is_asked)) return;
    Vector2<float> shift;
    if (!cell_shift(column, row, cell.q, shift)) return;
    const auto change = edges_.change(column, row, shift.x(), shift.y());
    cell.shift = shift.norm();
    all.changed += tells;
    all.explained += tells && change.is_explained();
    if (is_asked && !scene_stays_ && change.is_contradicted())
      cell.crossed += edges_.crossing(column, row, shift.x(), shift.y());
  }

  /// Whether the camera's motion does not explain how edges move.
  bool is_refuted() const { return refuted_ > 0.5f; }

  /// The exponent and two bits of the fraction, from 2^-15 1/m.
  static std::size_t bin_of(float q) {
    static_assert(sizeof(float) == sizeof(std::uint32_t));
    std::uint32_t bits;
    std::memcpy(&bits, &q, sizeof bits);
    constexpr int kFirst = (127 - 15) * 4;
    return static_cast<std::size_t>(std::clamp(static_cast<int>(bits >> 21) - kFirst, 0, static_cast<int>(kBins) - 1));
  }

  /// Whether edges stay on too much of the image for a part of it: then an object moves before a camera that stands.
  bool scene_stays() const {
    int staying = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) staying += edges_.has_edges(i) && edges_.stays(i);
    return staying > kMostShare * static_cast<double>(cells_.size());
  }

  /// Begins a trial of the cells that stay though many that are at least as far move, if there are many of them or if
  /// the motion is refuted.
  void suspect() {
    if (scene_stays_) return;
    std::array<int, kBins> all{}, moving{};  // cells at least as far
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (!(cells_[i].q > 0)) continue;
      const std::size_t bin = bin_of(cells_[i].q);
      ++all[bin];
      moving[bin] += is_refuted() ? !edges_.stays(i) : edges_.moves(i);
    }
    for (std::size_t i = 1; i < kBins; ++i) all[i] += all[i - 1], moving[i] += moving[i - 1];
    const auto many_move = [&](std::size_t bin) {
      return all[bin] >= StandingEdges::kLeastCells && moving[bin] > kMoving * all[bin];
    };
    const auto is_suspected = [&](std::size_t i) {
      if (!(cells_[i].q > 0) || !edges_.stays(i) || (is_refuted() && cells_[i].shift > kHeld)) return false;
      const std::size_t bin = bin_of(cells_[i].q);
      // A large part outnumbers what is as far as itself.
      return many_move(bin) || (bin >= kFarther && many_move(bin - kFarther));
    };
    int suspected = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) suspected += is_suspected(i);
    if (!is_refuted() && suspected < kManyShare * static_cast<double>(cells_.size())) return;
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if ((is_refuted() || cells_[i].tried == 0) && is_suspected(i))
        cells_[i].crossed = kSuspected, cells_[i].tried = 1;
  }

  /// Decides which cells are fixed. @return whether parts were found that have held the camera.
  bool decide() {
    suspect();
    int count = 0, sure = 0, all = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Cell& cell = cells_[i];
      fixed_[i] = cell.q > 0 && cell.crossed > kCrossed ? kFixed : 0;
      all += cell.q > 0;
      count += fixed_[i];
      sure += fixed_[i] && (cell.tried == 0 || cell.tried >= kTrial);
    }
    const double least = std::max<double>(StandingEdges::kLeastCells, kLeastShare * all);
    const bool before = excludes_;
    excludes_ = count >= least;
    if (excludes_) spread();
    const auto fixed = std::count_if(fixed_.begin(), fixed_.end(), [](std::uint8_t f) { return f != 0; });
    share_ = sure >= least ? static_cast<double>(fixed) / static_cast<double>(cells_.size()) : 0;
    return is_refuted() && excludes_ && !before;
  }

  /// Adds the cells beside fixed ones, unless their edges move: fixed parts have weak edges, too.
  void spread() {
    const int columns = edges_.columns(), rows = edges_.rows();
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        if (fixed_[edges_.index(column, row)] != kFixed) continue;
        for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
          for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c) {
            const std::size_t i = edges_.index(c, r);
            if (!fixed_[i] && !edges_.moves(i)) fixed_[i] = kBeside;
          }
      }
  }

  StandingEdges edges_;
  Overlays overlays_;
  std::vector<Cell> cells_;
  std::vector<std::uint8_t> fixed_;  ///< kFixed, kBeside or 0, of each cell
  SE3d T_cur_last_;                  ///< camera motion from the last frame that counted to the newest one
  bool known_ = true;                ///< whether it was measured
  bool compared_ = false;            ///< whether `refuted_` has a value
  bool scene_stays_ = false;         ///< see `scene_stays`
  int stood_ = 0;                    ///< frames for which it is still known that the camera stood
  bool excludes_ = false;            ///< whether the fixed parts are large enough to matter
  float refuted_ = 0;                ///< mean over the last frames that count, 0 to 1
  double share_ = 0;                 ///< see `share`
};

DOT_END_NAMESPACE
