// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "samples.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>

#include "sequence/distortion.hpp"
#include "sequence/entries.hpp"
#include "sequence/errors.hpp"
#include "sequence/images.hpp"
#include "sequence/layouts.hpp"
#include "sequence/stereo.hpp"

namespace check {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t run_length = 24;    ///< frames in a row: lags and repetitions need neighbours
constexpr std::size_t most_runs = 5;      ///< of a long recording
constexpr double most_pixels = 60e6;      ///< of all frames together; about 0.4 GB
constexpr std::size_t least_frames = 24;  ///< however large they are

/// Indices of the frames to look at.
std::vector<std::size_t> chosen(std::size_t count, double pixels) {
  const std::size_t most =
      std::clamp(static_cast<std::size_t>(most_pixels / pixels), least_frames, run_length * most_runs);
  std::vector<std::size_t> indices;
  const std::size_t runs = count <= most ? 1 : most / run_length;
  const std::size_t length = count <= most ? count : run_length;
  for (std::size_t run = 0; run < runs; ++run) {
    const std::size_t first = runs == 1 ? (count - length) / 2 : run * (count - length) / (runs - 1);
    for (std::size_t i = 0; i < length; ++i) indices.push_back(first + i);
  }
  return indices;
}

cv::Mat grey(const fs::path& path, cv::Size size) {
  cv::Mat image = runner::read_image(path, size);
  if (image.depth() != CV_8U || image.channels() == 2)
    throw runner::FileError(path.string() + ": must be 8-bit grey or colour");
  if (image.channels() > 1)
    cv::cvtColor(image, image, image.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  return image;
}

cv::Mat one_channel(const fs::path& path, cv::Mat image) {
  if (image.channels() != 1) throw runner::FileError(path.string() + ": must have one channel");
  return image;
}

}  // namespace

Samples read_samples(const runner::SequenceOptions& options) {
  Samples samples;
  runner::SequenceOptions as_they_are = options;
  as_they_are.check_times = false;
  samples.recording = runner::open_recording(as_they_are);
  const runner::Recording& recording = samples.recording;
  if (!recording.videos.empty())
    throw runner::FileError(options.folder.string() + ": --check reads images, no videos: make images of them");
  const cv::Size size(recording.intrinsics.width, recording.intrinsics.height);
  // Without masks and depth of the same size as the image, that is a finding, and they stay as they are.
  std::optional<runner::Undistorter> undistorter;
  if (recording.distortion) undistorter.emplace(recording.intrinsics, *recording.distortion);
  const auto undistorted = [&](const cv::Mat& labels) {
    return undistorter && labels.size() == size ? undistorter->labels(labels) : labels;
  };
  std::optional<runner::StereoDepth> stereo;
  samples.depth_from_pair = !recording.entries[0].right.empty();
  if (samples.depth_from_pair) stereo.emplace(recording.intrinsics);
  const fs::path right_folder = options.folder / "right";
  // The distortion is that of the left lens alone.
  const bool pair = samples.depth_from_pair ||
                    (!recording.distortion && recording.intrinsics.baseline > 0 && fs::is_directory(right_folder));

  for (const std::size_t index : chosen(recording.entries.size(), size.area())) {
    const runner::RecordingEntry& entry = recording.entries[index];
    Sample frame;
    frame.index = index;
    frame.follows = !samples.frames.empty() && samples.frames.back().index + 1 == index;
    frame.grey = grey(entry.image, size);
    if (undistorter) frame.grey = undistorter->image(frame.grey);
    if (pair) {
      const fs::path right = samples.depth_from_pair ? entry.right : runner::same_frame(right_folder, entry);
      if (samples.depth_from_pair || runner::is_there(right)) frame.right = grey(right, size);
    }
    if (stereo) {
      frame.depth = stereo->compute(frame.grey, frame.right);
    } else {
      frame.depth = runner::read_image(entry.depth);
      if (frame.depth.type() != CV_16UC1)
        throw runner::FileError(entry.depth.string() + ": must be a 16-bit grey image");
      frame.depth = undistorted(frame.depth);
      frame.depth.setTo(0, frame.depth == 65535);
    }
    if (entry.coco)
      frame.ids = undistorted(entry.coco->read(runner::image_name(entry), size, {}).ids);
    else if (!entry.masks.empty())
      frame.ids = undistorted(one_channel(entry.masks, runner::read_indices(entry.masks)));
    samples.frames.push_back(std::move(frame));
  }
  return samples;
}

cv::Mat metres(const Samples& samples, const Sample& frame) {
  cv::Mat depth;
  frame.depth.convertTo(depth, CV_32F, samples.depth_from_pair ? 1 : 1 / samples.recording.depth_units_per_metre);
  return depth;
}

bool has_depth(const Sample& frame) { return frame.depth.size() == frame.grey.size(); }
bool has_masks(const Sample& frame) { return frame.ids.size() == frame.grey.size(); }

}  // namespace check
