// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "run.hpp"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <deque>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "dot/tracker.hpp"
#include "outputs.hpp"
#include "real_time/delayed_masks.hpp"
#include "real_time/real_time.hpp"
#include "sequence/depth_source.hpp"
#include "sequence/sequence.hpp"

namespace runner {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Who makes the masks that come late: the network, or the sequence itself.
real_time::LateNetwork late_network(const Arguments& arguments, const std::optional<network::Network>& network) {
  real_time::LateNetwork late = real_time::recorded_masks(arguments.network_seconds.value_or(0));
  if (network) {
    late.segment = [&network](const SequenceFrame& frame) { return network->segment(frame.image); };
    late.takes = [](const SequenceFrame& frame) { return frame.masks_wanted; };
  }
  return late;
}

/// One frame after the other, each with its masks or, after --mask-delay, with those of an earlier one.
std::string run_in_order(const Arguments& arguments, const std::optional<network::Network>& network, Sequence& sequence,
                         dot::Tracker& tracker, const std::atomic<bool>& stop, Outputs& outputs) {
  std::deque<SequenceFrame> frames;  // the last one, and those before whose masks are on their way
  std::vector<double> network_ms;
  const int delay = arguments.mask_delay;
  const std::string option = "--mask-delay " + std::to_string(delay) + ": ";
  if (delay >= sequence.size() && delay > 0)
    throw std::runtime_error(option + "no mask would arrive within " + std::to_string(sequence.size()) + " frames");
  for (int i = 0; i < sequence.size() && !stop; ++i) {
    frames.push_back(sequence.read(i));
    SequenceFrame& frame = frames.back();
    if (network && frame.masks_wanted) {
      const auto start = std::chrono::steady_clock::now();
      Segmentation segmentation = network->segment(frame.image);
      network_ms.push_back(milliseconds_since(start));
      frame.ids = std::move(segmentation.ids);
      frame.instances = std::move(segmentation.instances);
    }
    dot::Frame now = frame.frame();
    if (delay > 0) now.masks.reset();
    const auto start = std::chrono::steady_clock::now();
    const dot::Result& result = tracker.track(now);
    if (const dot::Frame then = frames.front().frame(); i >= delay && delay > 0 && then.masks) {
      try {
        tracker.submit_masks(then.id, *then.masks);
      } catch (const std::invalid_argument& error) {
        throw std::runtime_error(option + error.what());
      }
    }
    outputs.add(frame, result, milliseconds_since(start));
    if (i >= delay) frames.pop_front();
  }
  return network_ms.empty() ? "" : "          the network took " + real_time::median_and_p99(network_ms, 1) + "\n";
}

/// One frame after the other, with masks as late as a network's in the time of the sequence.
std::string run_delayed(const real_time::LateNetwork& network, Sequence& sequence, dot::Tracker& tracker,
                        const std::atomic<bool>& stop, Outputs& outputs) {
  real_time::DelayedMasks delayed(network, tracker);
  for (int i = 0; i < sequence.size() && !stop; ++i) {
    const auto frame = std::make_shared<const SequenceFrame>(sequence.read(i));
    const dot::Frame now = delayed.next(frame);  // runs the network, whose time is not the tracker's
    const auto start = std::chrono::steady_clock::now();
    const dot::Result& result = tracker.track(now);
    outputs.add(*frame, result, milliseconds_since(start));
  }
  return delayed.report().text();
}

/// As from a camera.
std::string run_in_real_time(const Arguments& arguments, const real_time::LateNetwork& network, Sequence& sequence,
                             dot::Tracker& tracker, std::atomic<bool>& stop, Outputs& outputs) {
  real_time::Source source{[&](int i) { return sequence.read(i); }, {}, network};
  const std::vector<RecordingEntry>& entries = sequence.recording().entries;
  for (std::size_t i = 0; i < entries.size(); ++i)
    source.times.push_back(arguments.fps ? static_cast<double>(i) / *arguments.fps
                                         : entries[i].timestamp - entries[0].timestamp);
  real_time::SteadyClock clock;
  return real_time::play(source, clock, stop, tracker,
                         [&](const SequenceFrame& frame, const dot::Result& result, double total_ms) {
                           outputs.add(frame, result, total_ms);
                         })
      .text();
}

}  // namespace

RunEnd run(const Arguments& arguments, std::atomic<bool>& stop) {
  const SequenceOptions& source = arguments.run.sequence;
  Sequence sequence(source);
  const dot::Intrinsics& camera = sequence.intrinsics();
  const dot::Options options = tracker_options(arguments.run, sequence.depth_source());
  cv::setNumThreads(options.threads);
  dot::Tracker tracker(camera, options);
  std::optional<network::Network> network;
  if (!arguments.network.model.empty())
    network = network::open_network(arguments.network, {camera.width, camera.height});
  Outputs outputs(arguments, sequence, options, network ? network->class_names : std::vector<std::string>{});
  std::printf("sequence  %s: %d frames, %dx%d, depth %s (%s)\n", source.folder.c_str(), sequence.size(), camera.width,
              camera.height, sequence.stereo() ? "computed from the stereo pair" : "from files",
              to_string(options.depth_noise.source));
  if (network) std::printf("network   %s: %s\n", arguments.network.model.c_str(), network->description.c_str());

  std::string remarks;
  if (arguments.real_time)
    remarks = run_in_real_time(arguments, late_network(arguments, network), sequence, tracker, stop, outputs);
  else if (arguments.network_seconds)
    remarks = run_delayed(late_network(arguments, network), sequence, tracker, stop, outputs);
  else
    remarks = run_in_order(arguments, network, sequence, tracker, stop, outputs);
  const bool complete = !stop;
  return {complete, outputs.finish(complete, remarks)};
}

}  // namespace runner
