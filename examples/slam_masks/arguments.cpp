// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include "run/command_line.hpp"
#include "sequence/errors.hpp"

namespace slam {
namespace {

const char* const own_usage =
    R"(usage: slam_masks SEQ... [options]

Runs a visual odometry over recorded sequences with features from the whole image (no masks), from all
but what dot finds to move (DOT masks), and from outside of every instance (all masks). Prints the
absolute trajectory error of each against the sequence's own poses.

  --mask-every K            use only the masks of frames 0, K, 2K, ... (default 1)
  --seeds N                 runs of each, with other features drawn (default 5)
  --features N              corners of a frame (default 1500)
)";

}  // namespace

std::string usage() {
  return own_usage + std::string(runner::run_options_usage) + "  --help                    print this\n";
}

Arguments parse_arguments(int count, const char* const* values) {
  using runner::whole_number;
  Arguments a;
  runner::CommandLine line;
  add_run_options(line, a.run);
  line.flag("--help", a.help);
  line.flag("-h", a.help);
  line.option("--mask-every", [&](auto& name, auto& value) { a.run.sequence.mask_every = whole_number(name, value); });
  line.option("--seeds", [&](auto& name, auto& value) { a.seeds = whole_number(name, value); });
  line.option("--features", [&](auto& name, auto& value) { a.features = whole_number(name, value, 100); });
  line.parse(count, values, [&](const std::string& argument) { a.sequences.emplace_back(argument); });
  if (!a.help && a.sequences.empty()) throw runner::UsageError("no sequence folder given");
  return a;
}

}  // namespace slam
