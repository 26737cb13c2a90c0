// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dot/discovery/inconsistency.hpp"
#include "dot/image/image.hpp"

DOT_BEGIN_NAMESPACE

/// Finds regions that do not fit a static scene.
///
/// Cells whose depth is inconsistent are seeds. They lie where a moving object contradicts the frames before: on all of
/// it when it comes nearer or recedes, on its leading part when it crosses. Therefore a cluster of seeds grows over
/// cells of continuous depth, by about half its size. A region counts if enough of its cells are inconsistent in depth
/// or in intensity. A shadow changes the intensity alone and gives no seeds.
class RegionGrower {
 public:
  static constexpr float kPhoto = 4;           ///< sigma
  static constexpr int kMinSeeds = 6;          ///< cells of a cluster
  static constexpr int kMinCells = 10;         ///< of a region
  static constexpr double kMinShare = 0.3;     ///< inconsistent cells of a region
  static constexpr float kContinuous = 0.04f;  ///< relative step of inverse depth from cell to cell

  /// Regions of one frame, the largest clusters first: cells as y * width + x.
  std::vector<std::vector<int>> regions;

  /// @param q of the cells, 1/m, 0 = none. @param sigma (q) -> standard deviation of q.
  /// @param open (x, y) -> bool: whether the cell may belong to an unknown object (no mask, not the ground).
  /// @param followed number of the object that was found before and is expected there, 0 = none. These cells are seeds
  /// too. @param contradicts (x, y) -> bool: whether the cell contradicts a static scene by depth or intensity.
  template <typename Sigma, typename Open, typename Contradicts>
  void operator()(const Image<float>& q, const Inconsistency& evidence, const Image<std::uint8_t>& followed,
                  Sigma&& sigma, Open&& open, Contradicts&& contradicts) {
    width_ = q.width();
    height_ = q.height();
    q_ = &q;
    const std::size_t size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    state_.assign(size, kUnknown);
    const auto tolerance = [&](float value) {
      return std::max(kContinuous * value, 2.5f * static_cast<float>(sigma(value)));
    };
    const auto is_open = [&](std::size_t i) {
      return q_at(i) > 0 && open(static_cast<int>(i) % width_, static_cast<int>(i) / width_);
    };
    const std::uint8_t *inconsistent = evidence.depth.row(0), *expected = followed.row(0);
    for (std::size_t i = 0; i < size; ++i)
      if (inconsistent[i] || expected[i]) state_[i] = is_open(i) ? kSeedCell : kClosed;
    clusters_.clear();
    for (std::size_t i = 0; i < size; ++i)
      if (state_[i] == kSeedCell) {
        std::vector<int> cluster;
        state_[i] = kOpen;
        cluster.push_back(static_cast<int>(i));
        spread(cluster, 0, 0, tolerance,
               [&](std::size_t k) { return state_[k] == kSeedCell ? (state_[k] = kOpen, true) : false; });
        if (static_cast<int>(cluster.size()) >= kMinSeeds) clusters_.push_back(std::move(cluster));
      }
    std::sort(clusters_.begin(), clusters_.end(), [](const auto& l, const auto& r) {
      return l.size() != r.size() ? l.size() > r.size() : l.front() < r.front();
    });
    regions.clear();
    for (std::vector<int>& cluster : clusters_) grow(cluster, evidence, followed, is_open, tolerance, contradicts);
    merge(followed, tolerance);
  }

 private:
  enum State : std::uint8_t { kUnknown, kClosed, kOpen, kSeedCell, kTaken };

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  float q_at(std::size_t i) const { return q_->row(0)[i]; }

  /// Breadth-first search over cells of continuous depth that `take` accepts. It starts at the cells from index `begin`
  /// on and goes at most `steps` cells away (0: any number).
  template <typename Tolerance, typename Take>
  void spread(std::vector<int>& cells, std::size_t begin, int steps, Tolerance&& tolerance, Take&& take) {
    for (int step = 0; begin < cells.size() && (steps == 0 || step < steps); ++step) {
      const std::size_t end = cells.size();
      for (; begin < end; ++begin) {
        const int x = cells[begin] % width_, y = cells[begin] / width_;
        const float value = q_at(index(x, y)), most = tolerance(value);
        const auto visit = [&](int u, int v) {
          if (u < 0 || v < 0 || u >= width_ || v >= height_) return;
          const std::size_t to = index(u, v);
          if (std::abs(q_at(to) - value) > most || !take(to)) return;
          cells.push_back(static_cast<int>(to));
        };
        visit(x - 1, y), visit(x + 1, y), visit(x, y - 1), visit(x, y + 1);
      }
    }
  }

  template <typename IsOpen, typename Tolerance, typename Contradicts>
  void grow(std::vector<int>& cells, const Inconsistency& evidence, const Image<std::uint8_t>& followed,
            IsOpen&& is_open, Tolerance&& tolerance, Contradicts&& contradicts) {
    cells.erase(
        std::remove_if(cells.begin(), cells.end(), [&](int i) { return state_[static_cast<std::size_t>(i)] != kOpen; }),
        cells.end());
    if (static_cast<int>(cells.size()) < kMinSeeds) return;
    for (const int i : cells) state_[static_cast<std::size_t>(i)] = kTaken;
    // Growth starts only at cells that are inconsistent now.
    const auto grown = std::partition(cells.begin(), cells.end(), [&](int i) { return !evidence.depth.row(0)[i]; });
    const std::size_t first = static_cast<std::size_t>(grown - cells.begin());
    const double seeds = static_cast<double>(cells.size() - first);
    spread(cells, first, 1 + static_cast<int>(0.5 * std::sqrt(seeds)), tolerance, [&](std::size_t k) {
      if (state_[k] == kUnknown) state_[k] = is_open(k) ? kOpen : kClosed;
      return state_[k] == kOpen ? (state_[k] = kTaken, true) : false;
    });
    const int count = static_cast<int>(cells.size());
    if (count < kMinCells) return;
    int inconsistent = 0;
    for (const int i : cells) inconsistent += followed.row(0)[i] || contradicts(i % width_, i / width_);
    if (inconsistent >= kMinShare * count) regions.push_back(std::move(cells));
  }

  /// Merges regions that touch without a step in depth, and regions of an object that was found before. A post in front
  /// of the object may separate these.
  template <typename Tolerance>
  void merge(const Image<std::uint8_t>& followed, Tolerance&& tolerance) {
    owner_.assign(state_.size(), -1);
    for (std::size_t r = 0; r < regions.size(); ++r)
      for (const int i : regions[r]) owner_[static_cast<std::size_t>(i)] = static_cast<int>(r);
    parent_.resize(regions.size());
    for (std::size_t r = 0; r < parent_.size(); ++r) parent_[r] = static_cast<int>(r);
    const auto root = [&](int r) {
      while (parent_[static_cast<std::size_t>(r)] != r) r = parent_[static_cast<std::size_t>(r)];
      return r;
    };
    const auto join = [&](int r, int s) {
      r = root(r), s = root(s);
      parent_[static_cast<std::size_t>(std::max(r, s))] = std::min(r, s);
    };
    first_.fill(-1);
    for (std::size_t r = 0; r < regions.size(); ++r) {
      count_.fill(0);
      for (const int i : regions[r]) ++count_[followed.row(0)[i]];
      for (std::size_t k = 1; k < count_.size(); ++k) {
        if (2 * count_[k] < static_cast<int>(regions[r].size())) continue;
        if (first_[k] >= 0) join(static_cast<int>(r), first_[k]);
        first_[k] = static_cast<int>(r);
      }
    }
    for (std::size_t r = 0; r < regions.size(); ++r)
      for (const int i : regions[r]) {
        const int x = i % width_, y = i / width_;
        const auto touch = [&, from = q_at(index(x, y))](std::size_t to) {
          if (owner_[to] >= 0 && std::abs(from - q_at(to)) <= tolerance(from)) join(static_cast<int>(r), owner_[to]);
        };
        if (x + 1 < width_) touch(index(x + 1, y));
        if (y + 1 < height_) touch(index(x, y + 1));
      }
    for (std::size_t r = 0; r < regions.size(); ++r) {
      const int into = root(static_cast<int>(r));
      if (into == static_cast<int>(r)) continue;
      std::vector<int>& whole = regions[static_cast<std::size_t>(into)];
      whole.insert(whole.end(), regions[r].begin(), regions[r].end());
      regions[r].clear();
    }
    regions.erase(std::remove_if(regions.begin(), regions.end(), [](const auto& r) { return r.empty(); }),
                  regions.end());
  }

  int width_ = 0, height_ = 0;
  std::vector<int> owner_, parent_;
  std::array<int, 256> count_{}, first_{};  ///< by number of the followed object
  const Image<float>* q_ = nullptr;
  std::vector<std::uint8_t> state_;
  std::vector<std::vector<int>> clusters_;
};

DOT_END_NAMESPACE
