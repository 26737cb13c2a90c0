// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

#include "sequence/errors.hpp"
#include "sequence/fields.hpp"
#include "sequence/sequence_names.hpp"
#include "sequence/text.hpp"

namespace eval {
namespace {

using runner::UsageError;

const char* const own_usage =
    R"(usage: dot_eval SEQ... [options]

Runs the tracker over recorded sequences and measures its answers against their ground truth.
docs/evaluation.md defines the figures. The exit status is 1 when a sequence failed.

  --rates K,...             mask rates: the masks of frames 0, K, 2K, ... are used (default 1); mask IoU
                            is compared with the first of them
  --html FILE               a page with tables, plots and pictures
  --json FILE               all figures
  --out DIR                 write what dot_run writes, to DIR/NAME-everyK/
  --jobs N                  sequences to run side by side (default 1); times are honest with 1 alone
  --min-speed V             slower true movers count by speed alone, m/s (default 1)
  --from F                  leave out the frames before number F, the camera aside
  --boxes MARGIN            give the masks' boxes instead, as a detector does, each wider by a share of its width
                            and height on each side
  --hide-movers             take every second true mover out of the masks and measure how much of it is found
  --compare                 let the rules of published systems decide the same masks, given the true camera, and
                            measure them beside the tracker, instead of the above; see docs/evaluation.md
  --starts STEP             start a tracker at every STEP-th frame and measure its first frames, instead of the above
  --start-frames N          frames after each start (default 8)
  --drop-largest K          with --starts: leave the largest mover out of the masks of the first K frames
  --network-delay MS,...    hand the masks over as late as a network that takes so many ms for a frame, and compare
                            with masks that come with their frame, instead of the above
  --plot FILE               with --network-delay: F1, mask IoU and decided share against the delay, as SVG
)";

std::vector<int> parse_rates(const std::string& option, const std::string& value) {
  std::vector<int> rates;
  for (const std::string& piece : runner::split(value, ',')) rates.push_back(runner::whole_number(option, piece));
  if (rates.empty()) throw UsageError(option + " needs whole numbers");
  if (std::set<int>(rates.begin(), rates.end()).size() != rates.size())
    throw UsageError(option + " names a rate twice: " + value);
  return rates;
}

std::vector<int> parse_delays(const std::string& option, const std::string& value) {
  constexpr int most = 10000;  // ms
  std::vector<int> delays;
  for (const std::string& piece : runner::split(value, ','))
    delays.push_back(runner::whole_number(option, piece, 0, most));
  if (delays.empty()) throw UsageError(option + " needs whole numbers of milliseconds");
  std::sort(delays.begin(), delays.end());
  delays.erase(std::unique(delays.begin(), delays.end()), delays.end());
  return delays;
}

double parse_speed(const std::string& option, const std::string& value) {
  const std::optional<double> speed = runner::parse_number(value);
  if (!speed || *speed < 0) throw UsageError(option + " needs a speed of at least 0 m/s, not '" + value + "'");
  return *speed;
}

double parse_margin(const std::string& option, const std::string& value) {
  const std::optional<double> margin = runner::parse_number(value);
  if (!margin || !(*margin >= 0) || *margin > 1)
    throw UsageError(option + " needs a share from 0 to 1, not '" + value + "'");
  return *margin;
}

void check(const Arguments& a) {
  if (a.sequences.empty()) throw UsageError("no sequence folder given");
  if (!a.run.sequence.camera.empty() && a.sequences.size() > 1)
    throw UsageError("--camera belongs to one sequence, and " + std::to_string(a.sequences.size()) + " are given");
  const bool starts = a.starts > 0, delays = !a.network_delays.empty();
  if (a.drop_largest > 0 && !starts) throw UsageError("--drop-largest needs --starts");
  if (!a.plot.empty() && a.network_delays.size() < 2)
    throw UsageError("--plot needs --network-delay with two delays or more");
  if (!starts && !delays && !a.compare) return;
  const std::string instead = starts ? "--starts" : delays ? "--network-delay" : "--compare";
  if (a.rates.size() > 1) throw UsageError(instead + " takes one rate");
  const std::pair<bool, const char*> others[] = {{!a.html.empty(), "--html"},
                                                 {!a.json.empty(), "--json"},
                                                 {!a.out.empty(), "--out"},
                                                 {starts && delays, "--network-delay"},
                                                 {(starts || delays) && a.compare, "--compare"},
                                                 {(starts || a.compare) && a.hide_movers, "--hide-movers"},
                                                 {starts && a.scoring.from > 0, "--from"},
                                                 {a.boxes.has_value(), "--boxes"},
                                                 {(starts || a.compare) && a.jobs > 1, "--jobs"}};
  for (const auto& [given, name] : others)
    if (given) throw UsageError(std::string(name) + " cannot be combined with " + instead);
}

}  // namespace

std::string usage() {
  return own_usage + std::string(runner::run_options_usage) + "  --help                    print this\n";
}

Arguments parse_arguments(int count, const char* const* values) {
  Arguments a;
  runner::CommandLine line;
  add_run_options(line, a.run);
  line.flag("--hide-movers", a.hide_movers);
  line.flag("--compare", a.compare);
  line.flag("--help", a.help);
  line.flag("-h", a.help);
  line.option("--rates", [&](auto& name, auto& value) { a.rates = parse_rates(name, value); });
  line.option("--html", [&](auto& name, auto& value) { a.html = runner::not_empty(name, value); });
  line.option("--json", [&](auto& name, auto& value) { a.json = runner::not_empty(name, value); });
  line.option("--out", [&](auto& name, auto& value) { a.out = runner::not_empty(name, value); });
  line.option("--jobs", [&](auto& name, auto& value) { a.jobs = runner::whole_number(name, value); });
  line.option("--min-speed", [&](auto& name, auto& value) { a.scoring.min_speed = parse_speed(name, value); });
  line.option("--starts", [&](auto& name, auto& value) { a.starts = runner::whole_number(name, value); });
  line.option("--start-frames",
              [&](auto& name, auto& value) { a.start_frames = runner::whole_number(name, value, 2); });
  line.option("--drop-largest",
              [&](auto& name, auto& value) { a.drop_largest = runner::whole_number(name, value, 0); });
  line.option("--network-delay", [&](auto& name, auto& value) { a.network_delays = parse_delays(name, value); });
  line.option("--plot", [&](auto& name, auto& value) { a.plot = runner::not_empty(name, value); });
  line.option("--boxes", [&](auto& name, auto& value) { a.boxes = parse_margin(name, value); });
  line.option("--from", [&](auto& name, auto& value) { a.scoring.from = runner::whole_number(name, value, 0); });
  line.parse(count, values, [&](const std::string& argument) { a.sequences.emplace_back(argument); });
  if (!a.help) check(a);
  a.names = runner::sequence_names(a.sequences);
  return a;
}

}  // namespace eval
