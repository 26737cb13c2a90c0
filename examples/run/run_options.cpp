// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "run_options.hpp"

#include <string>

#include "config.hpp"
#include "dot/pipeline/validate_options.hpp"
#include "sequence/errors.hpp"
#include "sequence/fields.hpp"
#include "sequence/plausible.hpp"
#include "sequence/text.hpp"

namespace runner {

const char* const run_options_usage =
    R"(  --images NAME             SEQ holds images of any names: a folder, a pattern like left/%04d.png, or a video.
                            --depth-dir or --right then name the depth or the second eye in the same manner; see
                            docs/recordings.md
  --right NAME              with --images: the second eye of a rectified stereo pair
  --intrinsics FILE         with --images: the camera's file in SEQ, .txt, or .json as Open3D writes it (default
                            intrinsics.txt)
  --depth-dir NAME          folder of the depth images in SEQ (default depth)
  --depth-scale UNITS       units of the depth images to the metre, as 1000 for millimetres (default by the layout)
  --mask-dir NAME           folder of the masks in SEQ, or a file .json in COCO's format (default masks)
  --stereo                  compute the depth from the stereo pair (default where there are no depth images)
  --camera FILE             camera-to-world poses, KITTI format, to use instead of estimating the motion
  --config FILE             settings, `name = value` a line
  --classifier NAME         velocity (default), entropy or entropy-literal
  --always-dynamic CLASS,...
                            classes of the masks' csv files that always count as moving
  --discover                look for moving things that no mask shows
  --threads N               threads, 1 to 256, of OpenCV's pool (default 1)
)";

namespace {

constexpr int most_threads = 256;  // as dot::validate has it

}  // namespace

void add_run_options(CommandLine& line, RunOptions& options) {
  SequenceOptions& sequence = options.sequence;
  line.flag("--stereo", sequence.stereo);
  line.flag("--discover", options.discover);
  line.option("--depth-dir", [&](auto& name, auto& value) { sequence.depth_dir = not_empty(name, value); });
  line.option("--mask-dir", [&](auto& name, auto& value) { sequence.mask_dir = not_empty(name, value); });
  line.option("--images", [&](auto& name, auto& value) { sequence.images = not_empty(name, value); });
  line.option("--right", [&](auto& name, auto& value) { sequence.right = not_empty(name, value); });
  line.option("--intrinsics", [&](auto& name, auto& value) { sequence.intrinsics = not_empty(name, value); });
  line.option("--depth-scale",
              [&](auto& name, auto& value) { sequence.depth_scale = depth_scale<UsageError>(name, value); });
  line.option("--camera", [&](auto& name, auto& value) { sequence.camera = not_empty(name, value); });
  line.option("--always-dynamic",
              [&](auto& name, auto& value) { sequence.always_dynamic = split(not_empty(name, value), ','); });
  line.option("--config", [&](auto& name, auto& value) { options.config = not_empty(name, value); });
  line.option("--threads",
              [&](auto& name, auto& value) { options.threads = whole_number(name, value, 1, most_threads); });
  line.option("--classifier", [&](auto& name, auto& value) {
    options.classifier = classifier_by_name(value);
    if (!options.classifier)
      throw UsageError(name + " must be velocity, entropy or entropy-literal, not '" + value + "'");
  });
}

dot::Options tracker_options(const RunOptions& options, dot::DepthSource source) {
  dot::Options settings;
  settings.depth_noise.source = source;
  if (!options.config.empty()) read_config(options.config, settings);
  if (options.classifier) settings.classifier = *options.classifier;
  if (options.discover) settings.discover_unknown = true;
  if (options.threads) settings.threads = *options.threads;
  dot::validate(settings);
  return settings;
}

}  // namespace runner
