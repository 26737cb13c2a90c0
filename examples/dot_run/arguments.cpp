// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <initializer_list>

#include "sequence/errors.hpp"

namespace runner {
namespace {

const char* const own_usage =
    R"(usage: dot_run SEQ [--out OUT] [--video FILE] [--player FILE] [options]

Labels the objects of a recorded sequence as static, moving or not observable.

SEQ holds rgb/, depth/ or right/, masks/ and intrinsics.txt, or is a recording of KITTI, Virtual KITTI 2
or TUM RGB-D, see docs/recordings.md. OUT receives labels/, instances/, camera.txt, objects.csv and
timing.csv; the tables end in .partial until the last frame is done. At least one of OUT, a video and a
player must be named.

  --out OUT                 folder for the results, made if it does not exist; those of an earlier run in it
                            are removed
  --mask-every K            use only the masks of frames 0, K, 2K, ... (default 1)
  --mask-delay N            hand a frame's masks over only after N further frames, as if a network had taken
                            that long (default 0: with their frame)
  --overlay                 write pictures to OUT/overlay/
  --video FILE              write these pictures as a video, .mp4, .mkv or .avi
  --player FILE             write a page, .html, to look at the run in a browser: frames, objects, why each has its
                            state
  --masks-out DIR           write exclusion masks, 255 = do not use: DIR/mask_dot/ (moving or undecided objects)
                            and DIR/mask_all/ (every object)
)";

/// An ending that none of the recording's files has: these cannot be overwritten by mistake.
std::filesystem::path with_ending(const std::string& option, const std::string& value,
                                  std::initializer_list<const char*> endings) {
  std::filesystem::path path = not_empty(option, value);
  std::string known;
  for (const char* const ending : endings) {
    if (path.extension() == ending) return path;
    known += (known.empty() ? "" : " or ") + std::string(ending);
  }
  throw UsageError(option + " needs a name that ends in " + known + ", not '" + value + "'");
}

void check_outputs(const Outputs& output) {
  const bool no_results = output.results.out.empty();
  if (no_results && output.video.empty() && output.player.empty())
    throw UsageError("--out is missing (or --video, or --player)");
  if (no_results && (output.results.overlay || !output.results.masks_out.empty()))
    throw UsageError(std::string(output.results.overlay ? "--overlay" : "--masks-out") + " needs --out");
}

}  // namespace

std::string usage() { return own_usage + std::string(run_options_usage) + "  --help                    print this\n"; }

Arguments parse_arguments(int count, const char* const* values) {
  Arguments a;
  CommandLine line;
  add_run_options(line, a.run);
  line.flag("--overlay", a.output.results.overlay);
  line.flag("--help", a.help);
  line.flag("-h", a.help);
  line.option("--out", [&](auto& name, auto& value) { a.output.results.out = not_empty(name, value); });
  line.option("--masks-out", [&](auto& name, auto& value) { a.output.results.masks_out = not_empty(name, value); });
  line.option("--video", [&](auto& name, auto& value) {
    a.output.video = with_ending(name, value, {".mp4", ".mkv", ".avi"});
  });
  line.option("--player", [&](auto& name, auto& value) { a.output.player = with_ending(name, value, {".html"}); });
  line.option("--mask-every", [&](auto& name, auto& value) { a.run.sequence.mask_every = whole_number(name, value); });
  line.option("--mask-delay", [&](auto& name, auto& value) { a.mask_delay = whole_number(name, value, 0); });
  line.parse(count, values, [&](const std::string& argument) {
    std::filesystem::path& folder = a.run.sequence.folder;
    if (!folder.empty()) throw UsageError("more than one sequence: '" + folder.string() + "' and '" + argument + "'");
    folder = argument;
  });
  if (a.help) return a;
  if (a.run.sequence.folder.empty()) throw UsageError("no sequence folder given");
  check_outputs(a.output);
  return a;
}

}  // namespace runner
