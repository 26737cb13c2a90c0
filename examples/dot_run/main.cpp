// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// Runs the tracker over a recorded sequence and writes what it finds; see arguments.cpp for the usage.

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <opencv2/core/utils/logger.hpp>

#include "arguments.hpp"
#include "check/report.hpp"
#include "data_set.hpp"
#include "dataset/child_process.hpp"
#include "player/video_reader.hpp"
#include "run.hpp"
#include "sequence/errors.hpp"
#include "sequence/output_file.hpp"

namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal's handler sets it");

const pid_t program = getpid();

/// The run ends after its frame; a second signal ends the program. A process of --list may well get two, as one of the
/// program's group and from the program: it ends after its frame all the same, or with the program.
void interrupt(int signal) {
  interrupted = true;
  if (getpid() == program) std::signal(signal, SIG_DFL);
}

constexpr int status_of_faults = 3;

/// @return whether no fault was found.
bool look_at(const runner::Arguments& arguments) {
  const check::Report report = check::check_recording(arguments.run.sequence);
  if (!arguments.check.html.empty()) {
    runner::OutputFile file(arguments.check.html);
    file.stream() << check::html_report(report);
    file.finish();
  }
  std::fputs((arguments.check.json ? check::json_report(report) : check::text_report(report)).c_str(), stdout);
  return report.faults() == 0;
}

/// @return the exit status.
int run_program(int argc, char** argv) {
  using namespace runner;
  Arguments arguments = parse_arguments(argc, argv);
  arguments.run.sequence.open_video = player::open_video;
  if (arguments.help) {
    std::printf("%s", usage().c_str());
    return 0;
  }
  if (arguments.check.wanted) return look_at(arguments) ? 0 : status_of_faults;
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  if (!arguments.data_set.list.empty()) return run_data_set(arguments, interrupted);
  const std::filesystem::path& out = arguments.output.results.out;
  if (!out.empty()) dataset::keep_output_file((out / log_name).string());
  return run(arguments, interrupted).complete ? 0 : status_of_interrupted;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace runner;
  // Errors are told once, in one line, with the file's name.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    const int status = run_program(argc, argv);
    finish_standard_output();
    return status;
  } catch (const UsageError& error) {
    std::fprintf(stderr, "dot_run: %s (dot_run --help lists the options)\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dot_run: %s\n", error.what());
    return 1;
  }
}
