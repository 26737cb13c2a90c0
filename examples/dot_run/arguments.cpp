// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include "sequence/errors.hpp"

namespace runner {
namespace {

const char* const own_usage =
    R"(usage: dot_run SEQ --out OUT [options]

Labels the objects of a recorded sequence as static, moving or not observable.

SEQ holds rgb/, depth/ or right/, masks/ and intrinsics.txt, or is a recording of KITTI, Virtual KITTI 2
or TUM RGB-D, see docs/recordings.md. OUT receives labels/, instances/, camera.txt, objects.csv and
timing.csv; the tables end in .partial until the last frame is done.

  --out OUT                 folder for the results, made if it does not exist; those of an earlier run in it
                            are removed
  --mask-every K            use only the masks of frames 0, K, 2K, ... (default 1)
  --mask-delay N            hand a frame's masks over only after N further frames, as if a network had taken
                            that long (default 0: with their frame)
  --overlay                 write pictures to OUT/overlay/
  --masks-out DIR           write exclusion masks, 255 = do not use: DIR/mask_dot/ (moving or undecided objects)
                            and DIR/mask_all/ (every object)
)";

}  // namespace

std::string usage() { return own_usage + std::string(run_options_usage) + "  --help                    print this\n"; }

Arguments parse_arguments(int count, const char* const* values) {
  Arguments a;
  CommandLine line;
  add_run_options(line, a.run);
  line.flag("--overlay", a.output.overlay);
  line.flag("--help", a.help);
  line.flag("-h", a.help);
  line.option("--out", [&](auto& name, auto& value) { a.output.out = not_empty(name, value); });
  line.option("--masks-out", [&](auto& name, auto& value) { a.output.masks_out = not_empty(name, value); });
  line.option("--mask-every", [&](auto& name, auto& value) { a.run.sequence.mask_every = whole_number(name, value); });
  line.option("--mask-delay", [&](auto& name, auto& value) { a.mask_delay = whole_number(name, value, 0); });
  line.parse(count, values, [&](const std::string& argument) {
    std::filesystem::path& folder = a.run.sequence.folder;
    if (!folder.empty()) throw UsageError("more than one sequence: '" + folder.string() + "' and '" + argument + "'");
    folder = argument;
  });
  if (a.help) return a;
  if (a.run.sequence.folder.empty()) throw UsageError("no sequence folder given");
  if (a.output.out.empty()) throw UsageError("--out is missing");
  return a;
}

}  // namespace runner
