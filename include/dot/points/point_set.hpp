// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "dot/abi.hpp"
#include "dot/camera/depth_bias.hpp"

DOT_BEGIN_NAMESPACE

/// Points of one region of one frame: structure of arrays, all of length size(). They contain their reference
/// intensities, so that a frame can be aligned to a past one whose images are not kept.
struct PointSet {
  static constexpr int kMaxLevels = 6;       ///< of the pyramid whose intensities are kept
  static constexpr float kFarthest = 1e-4f;  ///< 1/m

  std::vector<float> u;                                  ///< column, pixels of level 0
  std::vector<float> v;                                  ///< row, pixels of level 0
  std::vector<float> x;                                  ///< ray (x, y, 1), camera axes
  std::vector<float> y;                                  ///< ray (x, y, 1), camera axes
  std::vector<float> q;                                  ///< inverse depth, 1/m
  std::vector<float> sigma_q;                            ///< 1/m
  std::array<std::vector<float>, kMaxLevels> intensity;  ///< grey value at each pyramid level
  std::array<std::vector<float>, kMaxLevels> gu;  ///< gradient there to the right, grey values per pixel of the level
  std::array<std::vector<float>, kMaxLevels> gv;  ///< gradient there downwards, grey values per pixel of the level
  int levels = 0;                                 ///< that have intensities
  DepthBias bias;                                 ///< that was subtracted from q

  /// Number of points.
  int size() const { return static_cast<int>(u.size()); }

  /// Removes all points. Keeps the memory.
  void clear() {
    for (std::vector<float>* a : {&u, &v, &x, &y, &q, &sigma_q}) a->clear();
    for (auto* levels_of : {&intensity, &gu, &gv})
      for (auto& a : *levels_of) a.clear();
    bias = {};
  }
  /// Adds a point, without its intensities.
  void push(float u_, float v_, float x_, float y_, float q_, float sigma_q_) {
    u.push_back(u_);
    v.push_back(v_);
    x.push_back(x_);
    y.push_back(y_);
    q.push_back(q_);
    sigma_q.push_back(sigma_q_);
  }

  /// Subtracts from q the part of the bias that was learnt since. @param width, height of the image. @return whether q
  /// changed.
  bool subtract_bias(const DepthBias& known, int width, int height) {
    const DepthBias learnt{known.coefficients - bias.coefficients};
    if (learnt.is_zero()) return false;
    const double to_s = 2.0 / width, to_t = 2.0 / height;
    for (std::size_t i = 0; i < q.size(); ++i) {
      const double s = to_s * static_cast<double>(u[i]) - 1, t = to_t * static_cast<double>(v[i]) - 1;
      q[i] = std::max(q[i] - static_cast<float>(learnt(s, t)), kFarthest);
    }
    bias = known;
    return true;
  }

  /// Replaces the points by every `step`-th of the given ones.
  void take_every(int step, const PointSet& all) {
    fill(all, [step](const std::vector<float>& from, std::vector<float>& to) {
      const auto each = static_cast<std::size_t>(step);
      to.resize((from.size() + each - 1) / each);
      for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i * each];
    });
  }

  /// Adds every `step`-th of others of the same frame, with the levels that both have.
  void append_every(int step, const PointSet& others) {
    const int shared = size() > 0 ? std::min(levels, others.levels) : others.levels;
    const DepthBias own = size() > 0 ? bias : others.bias;
    fill(others, [step](const std::vector<float>& from, std::vector<float>& to) {
      for (std::size_t i = 0; i < from.size(); i += static_cast<std::size_t>(step)) to.push_back(from[i]);
    });
    levels = shared, bias = own;
  }

  /// Replaces them by those of others for which condition(index) holds.
  template <typename Condition>
  void take_if(const PointSet& all, Condition&& condition) {
    fill(all, [&](const std::vector<float>& from, std::vector<float>& to) {
      to.clear();
      for (std::size_t i = 0; i < from.size(); ++i)
        if (condition(i)) to.push_back(from[i]);
    });
  }

 private:
  /// Fills each field by field(from, to).
  template <typename Field>
  void fill(const PointSet& all, Field&& take_field) {
    for (const auto field : {&PointSet::u, &PointSet::v, &PointSet::x, &PointSet::y, &PointSet::q, &PointSet::sigma_q})
      take_field(all.*field, this->*field);
    for (const auto field : {&PointSet::intensity, &PointSet::gu, &PointSet::gv})
      for (std::size_t level = 0; level < kMaxLevels; ++level) take_field((all.*field)[level], (this->*field)[level]);
    levels = all.levels;
    bias = all.bias;
  }
};

DOT_END_NAMESPACE
