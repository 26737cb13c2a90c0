// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <cstddef>
#include <initializer_list>
#include <map>
#include <utility>

#include "sequence/errors.hpp"
#include "sequence/fields.hpp"

namespace runner {
namespace {

const char* const own_usage =
    R"(usage: dot_run SEQ [--out OUT] [--player FILE] [--video FILE] [options]
       dot_run --list FILE --out OUT [--jobs N] [--resume] [--shard I/N] [options]
       dot_run SEQ --check [--html FILE] [--json]

Labels the objects of a recorded sequence as static, moving or not observable.

SEQ holds rgb/, depth/ or right/, masks/ and intrinsics.txt, or is a recording of KITTI, Virtual KITTI 2
or TUM RGB-D, see docs/recordings.md. OUT receives labels/, instances/, camera.txt, objects.csv and
timing.csv, and revised.txt if motions of the camera were revised; the tables end in .partial until the
last frame is done. At least one of OUT, a player and a video must be named.

instead of a run
  --check                   look at the recording, and say what is wrong with its images, depth, masks and times;
                            status 0: nothing found, 3: faults found; see docs/check.md
  --html FILE               with --check: the report as a page, .html
  --json                    with --check: the report as JSON on standard output

what to write
  --out OUT                 folder for the results, made if it does not exist; those of an earlier run in it
                            are removed
  --overlay                 write pictures to OUT/overlay/
  --masks-out DIR           write exclusion masks, 255 = do not use: DIR/mask_dot/ (moving or undecided objects)
                            and DIR/mask_all/ (every object)
  --player FILE             write a page, .html, to look at the run in a browser: frames, objects, why each has
                            its state; see docs/player.md
  --video FILE              write the pictures of --overlay as a video, .mp4, .mkv or .avi

many sequences, see docs/datasets.md
  --list FILE               run the sequences that the file names, a folder a line, each in a process of its own;
                            the results go to OUT/NAME/ and a table of them to OUT/summary.csv. --masks-out,
                            --player and --video are names within OUT/NAME/
  --jobs N                  sequences to run side by side (default 1)
  --resume                  leave out the sequences whose results are complete
  --shard I/N               do the I-th of N parts of the list, as one of several machines; its table is
                            OUT/summary-I-of-N.csv

masks
  --mask-every K            use only the masks of frames 0, K, 2K, ... (default 1)
  --mask-delay N            hand a frame's masks over only after N further frames, as if a network had taken
                            that long (default 0: with their frame)
  --network FILE            segment the images with this ONNX network instead of reading masks; see
                            docs/network.md
  --network-format NAME     what it gives: yolo-seg, mask-rcnn or ids (default: by its outputs)
  --network-classes FILE    its classes, `name` or `name, moves|dynamic|ignored` a line (default: COCO's)
  --network-size WxH        size of its input, where the file leaves it open
  --network-score S         least score of an instance, 0 to 1 (default 0.25 for yolo-seg, 0.5 for mask-rcnn)
  --network-backend NAME    opencv or onnxruntime (default: ONNX Runtime if the program was built with it)
  --network-delay MS        masks come as late as from a network that takes so long for a frame; with
                            --real-time the network's own time counts, too. Without --network: the masks of
                            the sequence
  --real-time [FPS]         frames come by their timestamps, or FPS of them a second, and those that come too
                            fast are dropped; the network runs beside the tracker, and its masks come late

input and tracker
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

void check_outputs(const OutputPaths& output) {
  const bool no_results = output.results.out.empty();
  if (no_results && output.video.empty() && output.player.empty())
    throw UsageError("--out is missing (or --video, or --player)");
  if (no_results && (output.results.overlay || !output.results.masks_out.empty()))
    throw UsageError(std::string(output.results.overlay ? "--overlay" : "--masks-out") + " needs --out");
}

template <typename T>
T one_of(const std::string& option, const std::string& value, std::initializer_list<std::pair<const char*, T>> names) {
  std::string list;
  for (const auto& [name, meaning] : names) {
    if (value == name) return meaning;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  throw UsageError(option + " must be one of " + list + ", not '" + value + "'");
}

double positive(const std::string& option, const std::string& value, int most) {
  const std::optional<double> number = parse_number(value);
  if (!number || !(*number > 0 && *number <= most))
    throw UsageError(option + " needs a number over 0 and at most " + std::to_string(most) + ", not '" + value + "'");
  return *number;
}

cv::Size input_size(const std::string& option, const std::string& value) {
  constexpr int most = 16384;
  const auto length = [](const std::string& text) {
    const std::optional<double> number = parse_number(text);
    return number ? to_whole(*number, 1, most) : std::nullopt;
  };
  const std::size_t x = value.find('x');
  std::optional<int> width, height;
  if (x != std::string::npos) width = length(value.substr(0, x)), height = length(value.substr(x + 1));
  if (!width || !height)
    throw UsageError(option + " needs WxH, as 640x384, each from 1 to " + std::to_string(most) + ", not '" + value +
                     "'");
  return {*width, *height};
}

void add_network_options(CommandLine& line, Arguments& a, std::string& needs_network) {
  network::NetworkOptions& n = a.network;
  line.option("--network", [&](auto& name, auto& value) { n.model = not_empty(name, value); });
  const std::map<std::string, CommandLine::Setter> setters{
      {"--network-format",
       [&](auto& name, auto& value) {
         using network::Format;
         n.format = one_of<Format>(
             name, value, {{"yolo-seg", Format::YoloSeg}, {"mask-rcnn", Format::MaskRcnn}, {"ids", Format::Ids}});
       }},
      {"--network-classes", [&](auto& name, auto& value) { n.classes = not_empty(name, value); }},
      {"--network-size", [&](auto& name, auto& value) { n.size = input_size(name, value); }},
      {"--network-score", [&](auto& name, auto& value) { n.score = static_cast<float>(positive(name, value, 1)); }},
      {"--network-backend", [&](auto& name, auto& value) {
         using network::BackendChoice;
         n.backend = one_of<BackendChoice>(
             name, value, {{"opencv", BackendChoice::OpenCv}, {"onnxruntime", BackendChoice::OnnxRuntime}});
       }}};
  for (const auto& [option, setter] : setters)
    line.option(option, [&needs_network, set = setter](auto& name, auto& value) {
      needs_network = name;
      set(name, value);
    });
  line.option("--network-delay",
              [&](auto& name, auto& value) { a.network_seconds = whole_number(name, value, 0, 60000) / 1000.0; });
  line.optional_number("--real-time", [&](auto& name, auto& value) {
    constexpr int most = 1000;
    a.real_time = true;
    if (!value.empty()) a.fps = positive(name, value, most);
  });
}

void add_data_set_options(CommandLine& line, DataSet& set) {
  line.option("--list", [&](auto& name, auto& value) { set.list = not_empty(name, value); });
  line.option("--jobs", [&](auto& name, auto& value) { set.jobs = whole_number(name, value, 1, 1024); });
  line.option("--shard", [&](auto& name, auto& value) { set.shard = dataset::parse_shard(name, value); });
  line.flag("--resume", set.resume);
}

/// Where the one sequence, or else the list of sequences comes from.
void check_sequences(const Arguments& a) {
  const std::filesystem::path& folder = a.run.sequence.folder;
  if (a.data_set.list.empty()) {
    for (const char* const option : {"--jobs", "--shard", "--resume"})
      if (a.given.count(option) > 0) throw UsageError(std::string(option) + " needs --list");
    if (folder.empty()) throw UsageError("no sequence folder given");
    return;
  }
  if (!folder.empty()) throw UsageError("--list and a sequence: '" + folder.string() + "'");
  if (a.output.results.out.empty()) throw UsageError("--list needs --out");
  if (!a.run.sequence.camera.empty()) throw UsageError("--camera belongs to one sequence, and does not go with --list");
  if (a.real_time && a.data_set.jobs > 1)
    throw UsageError("--jobs does not go with --real-time, whose results depend on the time");
  for (const char* const option : {"--masks-out", "--video", "--player"}) {
    const auto given = a.given.find(option);
    if (given == a.given.end()) continue;
    const std::filesystem::path name = std::filesystem::path(given->second).lexically_normal();
    if (name.is_absolute() || *name.begin() == "..")
      throw UsageError(given->first + " is within the folder of each sequence with --list: a relative name is needed");
  }
}

void check(Arguments& a, const std::string& needs_network) {
  SequenceOptions& sequence = a.run.sequence;
  if (a.check.wanted && !a.data_set.list.empty()) throw UsageError("--check looks at one sequence, not at a --list");
  check_sequences(a);
  if (a.check.wanted) return;
  if (!a.check.html.empty() || a.check.json)
    throw UsageError(std::string(a.check.json ? "--json" : "--html") + " needs --check");
  check_outputs(a.output);
  if (a.mask_delay > 0 && (a.real_time || a.network_seconds))
    throw UsageError("--mask-delay does not go with --real-time or --network-delay");
  if (a.network.model.empty()) {
    if (!needs_network.empty()) throw UsageError(needs_network + " needs --network");
    return;
  }
  if (sequence.mask_dir != SequenceOptions{}.mask_dir) throw UsageError("--mask-dir does not go with --network");
  sequence.masks = false;
  a.network.always_dynamic = sequence.always_dynamic;
}

}  // namespace

std::string usage() { return own_usage + std::string(run_options_usage) + "  --help                    print this\n"; }

Arguments parse_arguments(int count, const char* const* values) {
  Arguments a;
  CommandLine line;
  add_run_options(line, a.run);
  line.flag("--overlay", a.output.results.overlay);
  line.flag("--check", a.check.wanted);
  line.flag("--json", a.check.json);
  line.option("--html", [&](auto& name, auto& value) { a.check.html = with_ending(name, value, {".html"}); });
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
  std::string needs_network;
  add_network_options(line, a, needs_network);
  add_data_set_options(line, a.data_set);
  a.given = line.parse(count, values, [&](const std::string& argument) {
    std::filesystem::path& folder = a.run.sequence.folder;
    if (!folder.empty()) throw UsageError("more than one sequence: '" + folder.string() + "' and '" + argument + "'");
    folder = argument;
  });
  if (!a.help) check(a, needs_network);
  return a;
}

}  // namespace runner
