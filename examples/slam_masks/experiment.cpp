// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "experiment.hpp"

#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "dot/camera/depth_noise.hpp"
#include "dot/lie/se3.hpp"
#include "dot/pipeline/exclusion.hpp"
#include "dot/tracker.hpp"
#include "dot_eval/camera_score.hpp"
#include "features.hpp"
#include "odometry.hpp"
#include "sequence/errors.hpp"
#include "sequence/sequence.hpp"

namespace slam {

namespace {

struct Run {
  Odometry odometry;
  std::vector<dot::SE3d> poses;
};

/// The true poses, and the frames that have one.
struct Truth {
  std::vector<std::size_t> frames;
  eval::Poses poses;
};

Truth true_poses(const runner::Sequence& sequence, const std::filesystem::path& folder) {
  Truth truth;
  const std::vector<runner::RecordingEntry>& entries = sequence.recording().entries;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::optional<Eigen::Matrix4d>& T = entries[i].truth.camera;
    if (!T) continue;
    truth.frames.push_back(i);
    truth.poses.push_back(*T);
  }
  constexpr std::size_t fewest = 3;  // positions for an alignment
  if (truth.poses.size() < fewest) throw runner::FileError(folder.string() + ": has no true poses of the camera");
  return truth;
}

eval::CameraScore score(const Truth& truth, const std::vector<dot::SE3d>& poses) {
  eval::Poses estimate;
  for (const std::size_t frame : truth.frames)
    estimate.push_back(runner::pose_from_row_major(poses[frame].row_major().data()));
  return eval::score_camera(truth.poses, estimate);
}

cv::Mat metres(const runner::SequenceFrame& frame) {
  if (frame.depth.type() == CV_32FC1) return frame.depth;
  cv::Mat depth;
  frame.depth.convertTo(depth, CV_32F, 1 / frame.depth_units_per_metre);
  return depth;
}

/// 255 = take no features here.
cv::Mat exclusion(Masks masks, const runner::SequenceFrame& frame, const dot::Result& result) {
  cv::Mat exclude(frame.image.size(), CV_8UC1, cv::Scalar(0));
  if (masks == Masks::None) return exclude;
  dot::ExclusionPolicy policy;
  if (masks == Masks::All && !frame.ids.empty()) {
    const int side = 2 * policy.dilation + 1;
    cv::dilate(frame.ids != 0, exclude, cv::Mat::ones(side, side, CV_8UC1));
    return exclude;
  }
  // Between two segmentations the network's masks are those that the tracker carries on.
  policy.exclude_static = masks == Masks::All;
  dot::exclusion_mask(result, policy,
                      {exclude.data, exclude.cols, exclude.rows, static_cast<std::ptrdiff_t>(exclude.step[0])});
  return exclude;
}

}  // namespace

Experiment run_experiment(const Arguments& arguments, const std::filesystem::path& folder) {
  runner::RunOptions options = arguments.run;
  options.sequence.folder = folder;
  options.sequence.truth = true;
  runner::Sequence sequence(options.sequence);
  const dot::Intrinsics& camera = sequence.intrinsics();
  const dot::Options settings = tracker_options(options, sequence.depth_source());
  dot::Tracker tracker(camera, settings);
  FeatureExtractor extractor(arguments.features);
  PerMasks<std::vector<Run>> runs;
  for (std::vector<Run>& of_masks : runs) {
    for (int seed = 1; seed <= arguments.seeds; ++seed)
      of_masks.push_back({Odometry(camera, {settings.depth_noise, camera}, static_cast<std::uint64_t>(seed)), {}});
  }

  Experiment e;
  e.name = std::filesystem::absolute(folder / "").parent_path().filename().string();
  e.frames = sequence.size();
  const Truth truth = true_poses(sequence, folder);

  for (int i = 0; i < e.frames; ++i) {
    const runner::SequenceFrame frame = sequence.read(i);
    const dot::Result& result = tracker.track(frame.frame());
    extractor.set_frame(frame.image, metres(frame));
    for (std::size_t m = 0; m < runs.size(); ++m) {
      const cv::Mat exclude = exclusion(static_cast<Masks>(m), frame, result);
      e.excluded[m] += cv::countNonZero(exclude) / static_cast<double>(exclude.total()) / e.frames;
      const Features features = extractor.outside(exclude);
      for (Run& run : runs[m]) run.poses.push_back(run.odometry.track(features));
    }
  }

  for (std::size_t m = 0; m < runs.size(); ++m) {
    for (const Run& run : runs[m]) {
      const eval::CameraScore camera_score = score(truth, run.poses);
      e.path = camera_score.path_m;
      e.ate[m].push_back(camera_score.ate_m);
      e.lost[m].push_back(run.odometry.lost());
    }
    std::sort(e.ate[m].begin(), e.ate[m].end());
    std::sort(e.lost[m].begin(), e.lost[m].end());
  }
  return e;
}

}  // namespace slam
