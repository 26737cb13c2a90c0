// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "dot/frame/black_border.hpp"
#include "dot/frame/depth_densifier.hpp"
#include "dot/frame/flicker_removal.hpp"
#include "dot/frame/frame.hpp"
#include "dot/frame/frame_data.hpp"
#include "dot/frame/repeated_image.hpp"
#include "dot/image/convert.hpp"
#include "dot/image/levels.hpp"
#include "dot/kernel/kernels.hpp"
#include "dot/threads/threads.hpp"

DOT_BEGIN_NAMESPACE

/// Owns all frames and recycles their memory. A frame without other users is overwritten by a new one. So the number of
/// frames is the largest number ever needed at a time, and none is allocated in steady state.
class FrameStore {
 public:
  /// How frames are built.
  struct Settings {
    int max_levels = 1;                                          ///< of the pyramids
    double max_depth = 0;                                        ///< metres; farther depth counts as not measured
    double saturated = std::numeric_limits<double>::infinity();  ///< metres; so does depth from there on
  };

  /// Builds a frame's pyramids. @param bias is subtracted from its inverse depth. @param noise of the depth.
  /// @param previous the frame before, or null.
  template <typename Noise>
  FramePtr add(const Frame& input, const DepthBias& bias, const Noise& noise, const Settings& settings,
               const kernel::Kernels& kernels, const Threads& threads, const FrameData* previous = nullptr) {
    FrameData& frame = unused();
    frame.id = input.id;
    frame.timestamp = input.timestamp;
    frame.bias = bias;
    const int width = input.image.width, height = input.image.height;
    const int levels = pyramid_levels(width, height, settings.max_levels);
    const InverseDepthRows measured(input.depth, std::min(settings.max_depth, settings.saturated), kernels);
    threads.run(2, [&](int, int part) {
      if (part == 0)
        build_image(input.image, levels, kernels, previous != nullptr, frame.pyramid);
      else if (bias.is_zero())
        build_depth(measured, noise, width, height, levels, kernels, frame);
      else
        build_depth(UnbiasedDepthRows(measured, settings.max_depth, bias, depth_rows_, kernels), noise, width, height,
                    levels, kernels, frame);
    });
    if (border_.fill(frame.pyramid.levels[0], frame.depth.levels[0], previous != nullptr))
      build_levels(
          width, height, levels, [](int, std::uint8_t*) {}, kernels.halve, frame.pyramid.levels);
    const bool repeated = repeated_.repeats(frame.pyramid, previous ? &previous->pyramid : nullptr);
    frame.repeats = repeated ? previous->repeats + 1 : 0;
    if (frame.repeats > FrameData::kLongestRun) repeated_.forget();
    return newest();
  }

  /// If there is one frame, allocates a second one and writes to its memory. In the second frame of a sequence all
  /// motions are searched, so it is the slowest. The first aligns nothing, and takes the page faults of new memory.
  void prepare_second() {
    if (frames_.size() == 1) frames_.insert(frames_.begin(), std::make_shared<FrameData>(*frames_.back()));
  }

 private:
  using Slot = std::shared_ptr<FrameData>;

  FramePtr newest() const { return frames_.back(); }

  /// Builds the pyramid of the image without the bands of flickering light. @param follows the frame before.
  void build_image(const ImageRef& image, int levels, const kernel::Kernels& kernels, bool follows, Pyramid& out) {
    out.build(image.width, image.height, GreyRows(image, grey_rows_), levels, kernels);
    if (!flicker_.compare(out, follows)) return;
    const auto correct = [&](int y, std::uint8_t* row) { flicker_.correct(y, image.height, row, image.width); };
    build_levels(image.width, image.height, levels, correct, kernels.halve, out.levels);
  }

  /// Builds the depth pyramid. Sparse depth is interpolated, see DepthDensifier.
  template <typename Rows, typename Noise>
  void build_depth(Rows rows, const Noise& noise, int width, int height, int levels, const kernel::Kernels& kernels,
                   FrameData& frame) {
    frame.measured.clear();
    if (!may_be_sparse(rows, width, height)) return frame.depth.build(width, height, rows, levels, kernels);
    sparse_.resize(width, height);
    for (int y = 0; y < height; ++y) rows(y, sparse_.row(y));
    const double density = DepthDensifier::density(sparse_);
    const bool is_sparse = density > 0 && density < DepthDensifier::kSparse;
    const auto sigma = [&noise](double q) { return noise.prior_pixel_sigma(q); };
    if (is_sparse) densify_(sparse_, density, sigma, frame.measured, dense_);
    const Image<float>& filled = is_sparse ? dense_ : sparse_;
    const auto copy = [&](int y, float* to) { std::copy_n(filled.row(y), width, to); };
    frame.depth.build(width, height, copy, levels, kernels);
  }

  /// Decides by some of the rows. Their distances have no period, because the beams of a lidar have one.
  template <typename Rows>
  bool may_be_sparse(Rows& rows, int width, int height) {
    constexpr int kEvery = 8;
    constexpr double kGoldenRatio = 0.6180339887498949;
    row_.resize(static_cast<std::size_t>(width));
    const int count = height / kEvery + 1;
    const double least = DepthDensifier::kSparse * count * width;  // pixels of dense depth
    int measured = 0;
    for (int i = 0; i < count && measured < least; ++i) {  // of most depth a third of these rows is enough
      const double place = kGoldenRatio * i;
      rows(static_cast<int>((place - std::floor(place)) * height), row_.data());
      measured += static_cast<int>(std::count_if(row_.begin(), row_.end(), [](float q) { return q > 0; }));
    }
    return measured < least;
  }

  /// Finds or allocates a frame without users, and moves it to the end.
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
  RepeatedImage repeated_;
  FlickerRemoval flicker_;
  BlackBorder border_;
  Image<float> depth_rows_;
  std::vector<float> row_;
  Image<float> sparse_, dense_;
  DepthDensifier densify_;
};

DOT_END_NAMESPACE
