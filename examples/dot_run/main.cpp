// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// Runs the tracker over a recorded sequence and writes what it finds; see arguments.cpp for the usage.

#include <chrono>
#include <cstdio>
#include <deque>
#include <exception>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>

#include "arguments.hpp"
#include "dot/tracker.hpp"
#include "progress.hpp"
#include "run_writer.hpp"
#include "sequence/depth_source.hpp"
#include "sequence/errors.hpp"
#include "sequence/sequence.hpp"

namespace {

using namespace runner;

void run(const Arguments& arguments) {
  const SequenceOptions& source = arguments.run.sequence;
  Sequence sequence(source);
  const dot::Options options = tracker_options(arguments.run, sequence.depth_source());
  cv::setNumThreads(options.threads);
  dot::Tracker tracker(sequence.intrinsics(), options);
  RunWriter writer(arguments.output, source, sequence, options);
  Summary summary(source);
  std::printf("sequence  %s: %d frames, %dx%d, depth %s (%s)\n", source.folder.c_str(), sequence.size(),
              sequence.intrinsics().width, sequence.intrinsics().height,
              sequence.stereo() ? "computed from the stereo pair" : "from files",
              to_string(options.depth_noise.source));
  {
    Progress progress(sequence.size());
    std::deque<SequenceFrame> frames;  // the last one, and those before whose masks are on their way
    for (int i = 0; i < sequence.size(); ++i) {
      const int delay = arguments.mask_delay;
      frames.push_back(sequence.read(i));
      const SequenceFrame& frame = frames.back();
      dot::Frame now = frame.frame();
      if (delay > 0) now.masks.reset();
      const auto start = std::chrono::steady_clock::now();
      const dot::Result& result = tracker.track(now);
      if (const dot::Frame then = frames.front().frame(); i >= delay && delay > 0 && then.masks)
        tracker.submit_masks(then.id, *then.masks);
      const std::chrono::duration<double, std::milli> total = std::chrono::steady_clock::now() - start;
      writer.write(frame, result, total.count());
      summary.add(frame, result, total.count());
      progress.show(i + 1, result, total.count());
      if (i >= delay) frames.pop_front();
    }
  }
  writer.finish();
  summary.print(arguments.output);
}

}  // namespace

int main(int argc, char** argv) {
  // Errors are told once, in one line, with the file's name.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    const Arguments arguments = parse_arguments(argc, argv);
    if (arguments.help) {
      std::printf("%s", usage().c_str());
      return 0;
    }
    run(arguments);
    return 0;
  } catch (const UsageError& error) {
    std::fprintf(stderr, "dot_run: %s (dot_run --help lists the options)\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dot_run: %s\n", error.what());
    return 1;
  }
}
