// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "dot/frame/frame.hpp"
#include "dot/frame/frame_data.hpp"
#include "dot/image/convert.hpp"
#include "dot/image/levels.hpp"
#include "dot/kernel/kernels.hpp"
#include "dot/threads/threads.hpp"

DOT_BEGIN_NAMESPACE

/// Owns all frames and recycles their memory: a frame that is lent to nobody any more is overwritten by a new one. So
/// there are as many as were ever needed at a time, and none is allocated in steady state.
class FrameStore {
 public:
  /// How frames are built.
  struct Settings {
    int max_levels = 1;    ///< of the pyramids
    double max_depth = 0;  ///< metres; what is farther counts as not measured
  };

  /// Builds a frame's pyramids. @param bias to be subtracted from its inverse depth.
  FramePtr add(const Frame& input, const DepthBias& bias, const Settings& settings, const kernel::Kernels& kernels,
               const Threads& threads) {
    FrameData& frame = unused();
    frame.id = input.id;
    frame.timestamp = input.timestamp;
    frame.bias = bias;
    const int width = input.image.width, height = input.image.height;
    const int levels = pyramid_levels(width, height, settings.max_levels);
    threads.run(2, [&](int, int part) {
      if (part == 0)
        frame.pyramid.build(width, height, GreyRows(input.image, grey_rows_), levels, kernels);
      else if (bias.is_zero())
        frame.depth.build(width, height, InverseDepthRows(input.depth, settings.max_depth, kernels), levels, kernels);
      else
        frame.depth.build(width, height, UnbiasedDepthRows(input.depth, settings.max_depth, bias, depth_rows_, kernels),
                          levels, kernels);
    });
    return newest();
  }

  /// How many frames there is memory for.
  std::size_t capacity() const { return frames_.size(); }

 private:
  using Slot = std::shared_ptr<FrameData>;

  FramePtr newest() const { return frames_.back(); }

  /// A frame that nobody holds, moved to the end.
  FrameData& unused() {
    const auto free = std::find_if(frames_.begin(), frames_.end(), [](const Slot& s) { return s.use_count() == 1; });
    if (free == frames_.end())
      frames_.push_back(std::make_shared<FrameData>());
    else
      std::rotate(free, free + 1, frames_.end());
    return *frames_.back();
  }

  std::vector<Slot> frames_;  ///< the last one is the newest
  Image<std::uint8_t> grey_rows_;
  Image<float> depth_rows_;
};

DOT_END_NAMESPACE
