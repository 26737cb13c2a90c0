// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <functional>
#include <map>

#include "errors.hpp"
#include "text.hpp"

namespace runner {

const char* const usage =
    R"(usage: dot_run SEQ --out OUT [options]

Labels the objects of a recorded sequence as static, moving or not observable.

SEQ holds rgb/, depth/ or right/, masks/ and intrinsics.txt. OUT receives labels/, instances/,
camera.txt, objects.csv and timing.csv.

  --out OUT                 folder for the results, made if it does not exist
  --mask-every K            use only the masks of frames 0, K, 2K, ... (default 1)
  --depth-dir NAME          folder of the depth images in SEQ (default depth)
  --mask-dir NAME           folder of the masks in SEQ (default masks)
  --stereo                  compute the depth from rgb/ and right/ (default where there is no depth folder)
  --overlay                 write pictures to OUT/overlay/
  --masks-out DIR           write exclusion masks, 255 = do not use: DIR/mask_dot/ (moving or undecided objects)
                            and DIR/mask_all/ (every object)
  --camera FILE             camera-to-world poses, KITTI format, to use instead of estimating the motion
  --config FILE             settings, `name = value` a line
  --classifier NAME         velocity (default), entropy or entropy-literal
  --always-dynamic CLASS,...
                            classes of the masks' csv files that always count as moving
  --threads N               threads of OpenCV (default 1)
  --help                    print this
)";

namespace {

int positive(const std::string& option, const std::string& value) {
  const std::optional<double> number = parse_number(value);
  if (!number || *number < 1 || *number > 1e6 || *number != static_cast<int>(*number))
    throw UsageError(option + " needs a whole number of at least 1, not '" + value + "'");
  return static_cast<int>(*number);
}

std::string not_empty(const std::string& option, const std::string& value) {
  if (value.empty()) throw UsageError(option + " needs a name");
  return value;
}

}  // namespace

std::optional<dot::ClassifierKind> classifier_by_name(const std::string& name) {
  if (name == "velocity") return dot::ClassifierKind::Velocity;
  if (name == "entropy") return dot::ClassifierKind::Entropy;
  if (name == "entropy-literal") return dot::ClassifierKind::EntropyLiteral;
  return std::nullopt;
}

Arguments parse_arguments(int count, const char* const* values) {
  Arguments a;
  const std::map<std::string, std::function<void()>> flags = {
      {"--stereo", [&] { a.stereo = true; }},
      {"--overlay", [&] { a.overlay = true; }},
      {"--help", [&] { a.help = true; }},
      {"-h", [&] { a.help = true; }},
  };
  using Setter = std::function<void(const std::string& option, const std::string& value)>;
  const std::map<std::string, Setter> options = {
      {"--out", [&](auto& option, auto& value) { a.out = not_empty(option, value); }},
      {"--mask-every", [&](auto& option, auto& value) { a.mask_every = positive(option, value); }},
      {"--depth-dir", [&](auto& option, auto& value) { a.depth_dir = not_empty(option, value); }},
      {"--mask-dir", [&](auto& option, auto& value) { a.mask_dir = not_empty(option, value); }},
      {"--threads", [&](auto& option, auto& value) { a.threads = positive(option, value); }},
      {"--config", [&](auto& option, auto& value) { a.config = not_empty(option, value); }},
      {"--camera", [&](auto& option, auto& value) { a.camera = not_empty(option, value); }},
      {"--masks-out", [&](auto& option, auto& value) { a.masks_out = not_empty(option, value); }},
      {"--always-dynamic", [&](auto& option, auto& value) { a.always_dynamic = split(not_empty(option, value), ','); }},
      {"--classifier",
       [&](auto& option, auto& value) {
         a.classifier = classifier_by_name(value);
         if (!a.classifier)
           throw UsageError(option + " must be velocity, entropy or entropy-literal, not '" + value + "'");
       }},
  };

  for (int i = 1; i < count; ++i) {
    const std::string argument = values[i];
    const std::size_t equals = argument.rfind("--", 0) == 0 ? argument.find('=') : std::string::npos;
    const std::string name = argument.substr(0, equals);
    if (name == "--mask-delay" || name == "--discover") throw UsageError(name + " is not supported by this version");
    if (const auto flag = flags.find(argument); flag != flags.end()) {
      flag->second();
    } else if (const auto option = options.find(name); option != options.end()) {
      if (equals == std::string::npos && i + 1 == count) throw UsageError(name + " needs a value");
      option->second(name, equals == std::string::npos ? values[++i] : argument.substr(equals + 1));
    } else if (argument.rfind("-", 0) == 0) {
      throw UsageError("unknown option '" + argument + "'");
    } else if (a.sequence.empty()) {
      a.sequence = argument;
    } else {
      throw UsageError("more than one sequence: '" + a.sequence.string() + "' and '" + argument + "'");
    }
  }
  if (a.help) return a;
  if (a.sequence.empty()) throw UsageError("no sequence folder given");
  if (a.out.empty()) throw UsageError("--out is missing");
  return a;
}

}  // namespace runner
