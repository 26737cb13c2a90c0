// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// Measures the tracker over recorded sequences with ground truth; see arguments.cpp for the usage.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <optional>
#include <thread>
#include <vector>

#include "arguments.hpp"
#include "compare.hpp"
#include "evaluate.hpp"
#include "html.hpp"
#include "network_delay.hpp"
#include "pool.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "sequence/errors.hpp"
#include "sequence/output_file.hpp"
#include "starts.hpp"
#include "text_table.hpp"

namespace {

using namespace eval;

/// All jobs, Arguments::jobs of them side by side, in their order.
std::vector<RunScore> evaluate_all(const Arguments& arguments, const std::vector<Job>& jobs) {
  std::vector<RunScore> runs(jobs.size());
  Progress progress(static_cast<int>(jobs.size()));
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      const std::string name = arguments.names[jobs[i].sequence] + " 1/" + std::to_string(jobs[i].every);
      const auto frame_done = [&](int done, int total) { progress.frame(static_cast<int>(i), name, done, total); };
      runs[i] = evaluate(arguments, jobs[i], frame_done);
      progress.finished(static_cast<int>(i), name,
                        runs[i].error.empty() ? std::to_string(runs[i].frames) + " frames" : "FAILED");
    }
  };
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < std::min(jobs.size(), static_cast<std::size_t>(arguments.jobs)); ++i)
    others.emplace_back(work);
  work();
  for (std::thread& thread : others) thread.join();
  return runs;
}

/// All sequences at all rates, in the order of the arguments, rate by rate.
std::vector<Job> rate_jobs(const Arguments& arguments) {
  std::vector<Job> jobs;
  for (const int every : arguments.rates)
    for (std::size_t i = 0; i < arguments.sequences.size(); ++i) jobs.push_back({i, every, std::nullopt});
  return jobs;
}

bool all_measured(const std::vector<RunScore>& runs) {
  return std::all_of(runs.begin(), runs.end(), [](const RunScore& run) { return run.error.empty(); });
}

/// @return whether every sequence could be measured.
bool run_delays(const Arguments& arguments) {
  std::optional<runner::OutputFile> plot;
  if (!arguments.plot.empty()) plot.emplace(arguments.plot);
  const std::vector<RunScore> runs = evaluate_all(arguments, delay_jobs(arguments));
  const std::vector<DelayScore> scores = pool_delays(arguments, runs);
  std::printf("%s", delay_table(runs, scores).c_str());
  if (plot) {
    plot->stream() << delay_plot(scores);
    plot->finish();
  }
  return all_measured(runs);
}

/// @return whether every sequence could be measured.
bool run(const Arguments& arguments) {
  // What is wrong with the settings is wrong for every sequence, and is told at once.
  cv::setNumThreads(tracker_options(arguments.run, dot::DepthSource::Unknown).threads);
  if (arguments.starts > 0) {
    const std::vector<StartRun> starts = evaluate_starts(arguments);
    std::printf("%s", start_table(starts).c_str());
    return std::all_of(starts.begin(), starts.end(), [](const StartRun& s) { return s.error.empty(); });
  }
  if (!arguments.network_delays.empty()) return run_delays(arguments);
  if (arguments.compare) {
    const std::vector<Contender> contenders = compare(arguments);
    std::printf("%s", compare_table(contenders, arguments.rates[0]).c_str());
    return all_measured(contenders[0].runs);
  }
  std::optional<runner::OutputFile> json, html;
  if (!arguments.json.empty()) json.emplace(arguments.json);
  if (!arguments.html.empty()) html.emplace(arguments.html);

  const std::vector<RunScore> runs = evaluate_all(arguments, rate_jobs(arguments));
  std::vector<Pooled> pooled;
  for (const int every : arguments.rates) pooled.push_back(pool(runs, every, arguments.rates[0]));
  std::printf("%s", text_table(runs, pooled).c_str());
  if (json) {
    report(arguments, runs, pooled).write(json->stream());
    json->stream() << '\n';
    json->finish();
  }
  if (html) {
    html->stream() << html_page(runs, pooled);
    html->finish();
  }
  return all_measured(runs);
}

}  // namespace

int main(int argc, char** argv) {
  // Errors are told once, in one line, with the file's name.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    const Arguments arguments = parse_arguments(argc, argv);
    bool good = true;
    if (arguments.help)
      std::printf("%s", usage().c_str());
    else
      good = run(arguments);
    runner::finish_standard_output();
    return good ? 0 : 1;
  } catch (const runner::UsageError& error) {
    std::fprintf(stderr, "dot_eval: %s (dot_eval --help lists the options)\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dot_eval: %s\n", error.what());
    return 1;
  }
}
