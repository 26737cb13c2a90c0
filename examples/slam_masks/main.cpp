// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// How much the masks help a visual odometry: the experiment of the paper's section 4; see docs/slam-masks.md.

#include <cstdio>
#include <exception>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>

#include "arguments.hpp"
#include "experiment.hpp"
#include "sequence/errors.hpp"
#include "table.hpp"

int main(int argc, char** argv) {
  // Errors are told once, in one line, with the file's name.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    const slam::Arguments arguments = slam::parse_arguments(argc, argv);
    if (arguments.help) {
      std::printf("%s", slam::usage().c_str());
      return 0;
    }
    cv::setNumThreads(tracker_options(arguments.run, dot::DepthSource::Unknown).threads);
    slam::Table table(arguments.seeds);
    for (const std::filesystem::path& sequence : arguments.sequences)
      table.add(slam::run_experiment(arguments, sequence));
    table.finish();
    return 0;
  } catch (const runner::UsageError& error) {
    std::fprintf(stderr, "slam_masks: %s (slam_masks --help lists the options)\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "slam_masks: %s\n", error.what());
    return 1;
  }
}
