// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "named_layout.hpp"

#include <cstddef>
#include <string>
#include <utility>

#include "entries.hpp"
#include "errors.hpp"
#include "image_source.hpp"
#include "images.hpp"
#include "intrinsics_file.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

constexpr double millimetres = 1000;  // to the metre: what most RGB-D cameras record

fs::path in_folder(const SequenceOptions& options, const fs::path& name) {
  return (options.folder / name).lexically_normal();
}

const VideoInput& open_video(const SequenceOptions& options, const fs::path& path, Recording& recording) {
  if (!options.open_video) throw FileError(path.string() + ": this program reads no videos");
  if (!is_there(path)) throw FileError(path.string() + ": no such file");
  std::shared_ptr<VideoInput>& video = recording.videos[path];
  if (!video) video = options.open_video(path);
  return *video;
}

std::string frames(std::size_t count) { return std::to_string(count) + (count == 1 ? " frame" : " frames"); }

/// The frames that the images are.
void list_frames(const SequenceOptions& options, double fps, Recording& recording) {
  const fs::path source = in_folder(options, options.images);
  if (is_video(source)) {
    const std::vector<double>& times = open_video(options, source, recording).times();
    for (std::size_t i = 0; i < times.size(); ++i) {
      RecordingEntry& entry = recording.entries.emplace_back();
      entry.number = entry.video_frame = static_cast<int>(i);
      entry.timestamp = times[i];
      entry.image = source;
    }
    return;
  }
  int place = 0;
  for (const ImageSource::File& file : list_source(options.folder, options.images).files) {
    RecordingEntry& entry = recording.entries.emplace_back();
    entry.number = file.number.value_or(place);
    entry.video_frame = place++;
    entry.timestamp = entry.number / fps;
    entry.image = file.path;
  }
}

/// Gives each frame its file: by the numbers where both are patterns, otherwise in their order.
void pair_up(const SequenceOptions& options, const fs::path& name, fs::path RecordingEntry::*member,
             Recording& recording) {
  const fs::path source = in_folder(options, name);
  std::vector<RecordingEntry>& entries = recording.entries;
  const auto check_count = [&](std::size_t count) {
    if (count != entries.size())
      throw FileError(source.string() + ": has " + frames(count) + ", and the images have " + frames(entries.size()));
  };
  if (is_video(source)) {
    check_count(open_video(options, source, recording).times().size());
    for (RecordingEntry& entry : entries) entry.*member = source;
    return;
  }
  const ImageSource list = list_source(options.folder, name);
  if (!is_pattern(options.images) || !list.numbered) {
    check_count(list.files.size());
    for (std::size_t i = 0; i < entries.size(); ++i) entries[i].*member = list.files[i].path;
    return;
  }
  std::map<int, fs::path> by_number;
  for (const ImageSource::File& file : list.files) by_number[*file.number] = file.path;
  for (RecordingEntry& entry : entries) {
    const auto found = by_number.find(entry.number);
    if (found == by_number.end())
      throw FileError(source.string() + ": there is none for " + entry.image.filename().string());
    entry.*member = found->second;
  }
}

}  // namespace

Recording read_named_layout(const SequenceOptions& options) {
  const fs::path camera_file = in_folder(options, options.intrinsics.empty() ? "intrinsics.txt" : options.intrinsics);
  const CameraFile camera = read_camera_file(camera_file);
  Recording recording;
  recording.layout = "named files";
  recording.intrinsics = camera.intrinsics;
  recording.distortion = camera.distortion;
  recording.depth_units_per_metre = camera.depth_units_per_metre.value_or(millimetres);
  list_frames(options, camera.fps, recording);
  if (!is_video(options.images))  // before anybody takes memory for images of the size that is claimed
    read_image(recording.entries[0].image, {camera.intrinsics.width, camera.intrinsics.height});
  if (const fs::path times = options.folder / "times.txt"; is_there(times))
    read_times(times, recording.entries, options.check_times);

  const bool stereo = options.stereo || !options.right.empty();
  if (stereo) {
    if (!(camera.intrinsics.baseline > 0)) throw FileError(camera_file.string() + ": baseline must be > 0 for stereo");
    pair_up(options, options.right.empty() ? "right" : options.right, &RecordingEntry::right, recording);
    recording.depth_source = dot::DepthSource::Stereo;
  } else {
    pair_up(options, options.depth_dir, &RecordingEntry::depth, recording);
    recording.depth_source = camera.stated_source.value_or(camera.intrinsics.baseline > 0 ? dot::DepthSource::Stereo
                                                                                          : dot::DepthSource::Unknown);
  }
  list_masks(options, recording.entries);
  return recording;
}

}  // namespace runner
