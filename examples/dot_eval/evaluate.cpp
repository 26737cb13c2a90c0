// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "evaluate.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <memory>
#include <utility>

#include "boxes.hpp"
#include "dot/lie/se3.hpp"
#include "dot/tracker.hpp"
#include "real_time/delayed_masks.hpp"
#include "run/writer.hpp"
#include "sequence/errors.hpp"

namespace eval {
namespace {

/// True and estimated poses of the frames whose true one is known.
class CameraLog {
 public:
  void add(const std::optional<Eigen::Matrix4d>& truth, const dot::CameraResult& camera) {
    const dot::SE3d T_cur_prev = dot::SE3d::from_row_major(camera.T_cur_prev);
    T_world_camera_ = T_world_camera_ * T_cur_prev.inverse();
    const std::optional<Eigen::Matrix4d> before = std::exchange(before_, truth);
    if (!truth) return;
    if (before && camera.status == dot::CameraStatus::Tracked) {
      const Eigen::Matrix4d T = truth->inverse() * *before;
      const dot::SE3d true_motion{T.topLeftCorner<3, 3>(), T.topRightCorner<3, 1>()};
      nees_.push_back(
          camera_nees(true_motion, T_cur_prev, Eigen::Map<const dot::Matrix6<double>>(camera.covariance.data())));
    }
    truth_.push_back(*truth);
    estimate_.push_back(runner::pose_from_row_major(T_world_camera_.row_major().data()));
  }

  std::optional<CameraScore> score() const {
    if (truth_.size() < 2) return std::nullopt;
    CameraScore score = score_camera(truth_, estimate_);
    score.step_nees = nees_;
    return score;
  }

 private:
  dot::SE3d T_world_camera_;
  Poses truth_;
  Poses estimate_;
  std::optional<Eigen::Matrix4d> before_;  ///< the true pose of the last frame
  std::vector<double> nees_;
};

/// The first frame does not count: it takes the buffers and has nothing to compare with.
class TimeLog {
 public:
  void add(const StageTimes& stages, double total) {
    if (++frames_ == 1) return;
    for (std::size_t i = 0; i < stages.size(); ++i) stages_[i] += stages[i];
    frame_ms_.push_back(total);
  }

  void store(RunScore& score) const {
    for (std::size_t i = 0; i < stages_.size(); ++i) score.stage_ms[i] = ratio(stages_[i], frames_ - 1);
    score.frame_ms = frame_ms_;
  }

 private:
  int frames_ = 0;
  StageTimes stages_{};
  std::vector<double> frame_ms_;
};

void run(const Arguments& arguments, const std::filesystem::path& folder, const FrameDone& frame_done,
         RunScore& score) {
  runner::SequenceOptions source = arguments.run.sequence;
  source.folder = folder;
  source.mask_every = score.every;
  source.truth = true;
  runner::Sequence sequence(source);
  const runner::Recording& recording = sequence.recording();
  if (!has_truth(recording)) throw runner::FileError(folder.string() + ": has no ground truth");
  const dot::Options options = tracker_options(arguments.run, sequence.depth_source());
  dot::Tracker tracker(sequence.intrinsics(), options);
  std::optional<runner::ResultWriter> writer;
  if (!arguments.out.empty())
    writer.emplace(
        runner::OutputOptions{arguments.out / (score.name + "-every" + std::to_string(score.every)), {}, false},
        folder);

  ObjectScorer objects(arguments.scoring);
  std::optional<HiddenMovers> hidden;
  if (arguments.hide_movers) hidden.emplace(recording, arguments.scoring);
  std::optional<real_time::DelayedMasks> delayed;
  if (score.network_seconds) delayed.emplace(real_time::recorded_masks(*score.network_seconds), tracker);
  CameraLog camera;
  TimeLog times;
  PictureBook pictures(sequence.size());
  for (int i = 0; i < sequence.size(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    const runner::RecordingEntry& entry = recording.entries[index];
    const auto read = std::make_shared<runner::SequenceFrame>(sequence.read(i));
    runner::SequenceFrame& frame = *read;
    const runner::FrameTruth truth = sequence.truth(i);
    if (hidden) hidden->remove(frame, truth.instance);
    if (arguments.boxes) make_boxes(*arguments.boxes, frame);

    const dot::Frame now = delayed ? delayed->next(read) : frame.frame();
    const auto start = std::chrono::steady_clock::now();
    const dot::Result& result = tracker.track(now);
    const std::chrono::duration<double, std::milli> total = std::chrono::steady_clock::now() - start;

    if (writer) writer->write(frame, result, total.count());
    const FramePixels pixels = objects.add(entry, truth, i > 0 ? &recording.entries[index - 1].truth : nullptr, result);
    if (hidden) hidden->add(entry, truth.instance, result);
    camera.add(entry.truth.camera, result.camera);
    times.add(result.stage_ms, total.count());
    if (!arguments.html.empty())
      pictures.consider(i, frame, entry.truth, truth.instance, pixels, result, total.count());
    frame_done(i + 1, sequence.size());
  }

  if (writer) writer->finish();
  score.frames = sequence.size();
  score.camera = camera.score();
  if (!objects.score().sightings.empty() || !objects.score().pixels.empty()) {
    score.objects = objects.score();
    score.latency = decision_latency(
        score.objects->sightings, std::min(options.velocity.v0, arguments.scoring.min_speed), arguments.scoring.from);
  }
  if (hidden) score.hidden = hidden->score();
  if (delayed) score.late = delayed->report();
  times.store(score);
  score.pictures = pictures.take();
}

}  // namespace

FrameTime frame_time(const std::vector<double>& frame_ms) {
  if (frame_ms.empty()) return {};
  return {mean(frame_ms), median(frame_ms), percentile(frame_ms, 99), percentile(frame_ms, 100), frame_ms.front()};
}

bool has_truth(const runner::Recording& recording) {
  for (const runner::RecordingEntry& entry : recording.entries)
    if (!entry.truth.instance.empty() || entry.truth.camera) return true;
  return false;
}

RunScore evaluate(const Arguments& arguments, const Job& job, const FrameDone& frame_done) {
  RunScore score;
  score.name = arguments.names[job.sequence];
  score.every = job.every;
  score.network_seconds = job.network_seconds;
  try {
    run(arguments, arguments.sequences[job.sequence], frame_done, score);
  } catch (const std::exception& error) {
    score.error = error.what();
  }
  return score;
}

}  // namespace eval
