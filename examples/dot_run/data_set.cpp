// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "data_set.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "dataset/processes.hpp"
#include "dataset/record.hpp"
#include "dataset/sequence_list.hpp"
#include "dataset/summary.hpp"
#include "dot/version.hpp"
#include "run.hpp"
#include "sequence/errors.hpp"
#include "sequence/output_file.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

const std::string interrupted = "interrupted";

/// Options without effect on the results.
const std::set<std::string> indifferent{"--list", "--out", "--jobs", "--resume", "--shard", "--threads"};
/// Options that name a file whose content matters.
const std::set<std::string> files{"--config", "--network", "--network-classes"};

/// The settings of a run; the same for all sequences.
std::vector<std::string> settings(const Arguments& arguments) {
  std::vector<std::string> lines{"dot " DOT_VERSION_STRING};
  for (const auto& [name, value] : arguments.given) {
    if (indifferent.count(name) > 0) continue;
    std::string& line = lines.emplace_back(name);
    if (value.empty()) continue;
    if (files.count(name) == 0) {
      line += " " + value;
      continue;
    }
    std::error_code error;
    if (fs::exists(value, error) && !fs::is_regular_file(value, error))
      throw FileError(value + ": with --list a regular file is needed, which can be read more than once");
    line += " " + dataset::digest(value);
  }
  return lines;
}

std::vector<std::string> asked(const std::vector<std::string>& settings, const dataset::Item& item) {
  std::vector<std::string> lines = settings;
  lines.push_back("sequence " + fs::absolute(item.folder / "").lexically_normal().string());
  return lines;
}

/// What the one has and the other has not, for a message.
std::string missing(const std::vector<std::string>& of, const std::vector<std::string>& in) {
  std::string text;
  for (const std::string& line : of)
    if (std::find(in.begin(), in.end(), line) == in.end()) text += (text.empty() ? "'" : ", '") + line + "'";
  return text.empty() ? "nothing else" : text;
}

/// The command line of one sequence.
Arguments of_one(const Arguments& all, const dataset::Item& item) {
  Arguments one = all;
  one.data_set = {};
  one.run.sequence.folder = item.folder;
  const fs::path out = all.output.results.out / item.name;
  one.output.results.out = out;
  for (fs::path* const path : {&one.output.results.masks_out, &one.output.video, &one.output.player})
    if (!path->empty()) *path = out / *path;
  return one;
}

/// In a process of its own.
void run_one(const Arguments& arguments, const std::vector<std::string>& asked, std::atomic<bool>& stop) {
  const fs::path& out = arguments.output.results.out;
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw FileError(out.string() + ": the folder cannot be made: " + error.message());
  dataset::write_output_to((out / log_name).string());
  dataset::remove_record(out);
  const RunEnd end = run(arguments, stop);
  if (!end.complete) throw std::runtime_error(interrupted);
  dataset::write_record(out, {asked, end.figures});
}

/// The sequences that are to be done, of those of this shard; the outcomes of the others are filled in. Nothing is
/// written.
std::vector<std::size_t> to_do(const Arguments& arguments, const std::vector<std::string>& settings,
                               std::vector<dataset::Outcome>& outcomes) {
  const DataSet& set = arguments.data_set;
  std::vector<std::size_t> jobs;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    dataset::Outcome& outcome = outcomes[i];
    const fs::path folder = arguments.output.results.out / outcome.item.name;
    std::error_code not_there;
    if (fs::equivalent(folder, outcome.item.folder, not_there))
      throw UsageError("--out must not be the folder that holds a sequence: the results of " +
                       outcome.item.folder.string() + " would go to its own folder");
    // Those of the other shards are looked at as well: they are to go together.
    const std::optional<dataset::Record> record = set.resume ? dataset::read_record(folder) : std::nullopt;
    if (record) {
      const std::vector<std::string> now = asked(settings, outcome.item);
      if (record->asked != now)
        throw UsageError(folder.string() + " was made with " + missing(record->asked, now) + ", and now " +
                         missing(now, record->asked) +
                         " is asked for; do all again without --resume, or name another --out");
      outcome.status = dataset::Status::Complete;
      outcome.figures = record->figures;
    } else if (set.shard.has(i)) {
      jobs.push_back(i);
    }
  }
  return jobs;
}

fs::path summary_path(const Arguments& arguments) {
  const dataset::Shard& shard = arguments.data_set.shard;
  const std::string part =
      shard.count > 1 ? "-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count) : "";
  return arguments.output.results.out / ("summary" + part + ".csv");
}

}  // namespace

int run_data_set(const Arguments& arguments, std::atomic<bool>& stop) {
  const DataSet& set = arguments.data_set;
  const fs::path& out = arguments.output.results.out;
  const std::vector<std::string> common = settings(arguments);
  tracker_options(arguments.run, dot::DepthSource::Unknown);  // what is wrong there is wrong for every sequence
  std::vector<dataset::Outcome> outcomes;
  for (dataset::Item& item : dataset::read_list(set.list)) outcomes.emplace_back().item = std::move(item);
  const std::vector<std::size_t> jobs = to_do(arguments, common, outcomes);
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw FileError(out.string() + ": the folder cannot be made: " + error.message());
  OutputFile table(summary_path(arguments));
  fs::remove(summary_path(arguments), error);  // whoever kills this run is not to find the table of an earlier one
  // Otherwise a later --resume would take them for results of this run.
  for (const std::size_t i : jobs) dataset::remove_record(out / outcomes[i].item.name);

  std::size_t done = 0;
  const auto work = [&](std::size_t i) {
    run_one(of_one(arguments, outcomes[i].item), asked(common, outcomes[i].item), stop);
  };
  const auto ended = [&](std::size_t i, const dataset::Ending& ending) {
    dataset::Outcome& outcome = outcomes[i];
    const auto record = ending.good ? dataset::read_record(out / outcome.item.name) : std::nullopt;
    if (record) outcome.figures = record->figures;
    const bool was_stopped = stop || ending.reason == interrupted;
    outcome.status = record        ? dataset::Status::Complete
                     : was_stopped ? dataset::Status::Interrupted
                                   : dataset::Status::Failed;
    if (ending.reason != interrupted) outcome.reason = ending.reason;
    if (ending.good && !record) outcome.reason = std::string(dataset::record_name) + " cannot be read";
    std::printf("[%zu/%zu] %s: %s%s%s\n", ++done, jobs.size(), outcome.item.name.c_str(), to_string(outcome.status),
                outcome.reason.empty() ? "" : ": ", outcome.reason.c_str());
    std::fflush(stdout);
  };
  const auto stopping = [](std::size_t running) {
    std::fprintf(stderr, "dot_run: interrupted; waiting for the frames of %zu sequences\n", running);
  };
  dataset::Processes{set.jobs, work, ended, stopping}.run(jobs, stop);

  std::vector<dataset::Outcome> own;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (set.shard.has(i)) own.push_back(outcomes[i]);
  table.stream() << summary_csv(own);
  table.finish();
  const auto count = [&](dataset::Status status) {
    return std::count_if(own.begin(), own.end(), [&](auto& outcome) { return outcome.status == status; });
  };
  const long failed = count(dataset::Status::Failed), left = count(dataset::Status::Interrupted);
  std::printf("sequences %zu: %ld complete (%zu of them before), %ld failed, %ld interrupted or not begun\n",
              own.size(), count(dataset::Status::Complete), own.size() - jobs.size(), failed, left);
  std::printf("summary   %s\n", summary_path(arguments).c_str());
  if (left > 0) return status_of_interrupted;
  return failed > 0 ? 1 : 0;
}

}  // namespace runner
