// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dot/camera_motion/background.hpp"
#include "dot/camera_motion/estimator.hpp"
#include "dot/camera_motion/second_motion.hpp"
#include "dot/containers/recycling_list.hpp"
#include "dot/frame/frame_data.hpp"

DOT_BEGIN_NAMESPACE

/// An earlier interval, with the motion that a later one proved to be the right one.
struct RevisedInterval {
  std::uint64_t frame_id = 0;  ///< of the frame that the interval leads to
  double timestamp = 0;        ///< of that frame
  CameraStep step;             ///< as `CameraTracker::track` should have answered
};

/// The intervals since the camera's motion was searched without a velocity. Such a motion can be wrong: a large object
/// that has no mask yet may have most of the texture. The next intervals then have the same wrong velocity, until the
/// object gets its mask. A camera cannot change its velocity in no time, so the first right interval contradicts them.
/// They are aligned again, the newest first, each from the velocity of the one after it.
class FirstIntervals {
 public:
  /// Adds the newest interval, unless enough have agreed. @param background the points that measured it. @param
  /// searched it is the first one.
  void add(const Background& background, const CameraStep& step, bool searched) {
    const bool belongs = searched || (!intervals_.empty() && intervals_.size() < kMost);
    if (searched || !belongs) clear();
    if (!belongs) return;
    Interval& added = intervals_.push_back();
    added.points = background.points;
    added.T_prev_points = background.T_now_points;
    added.step = step;
  }
  /// Keeps the frame that the last interval leads to.
  void keep_frame(const FramePtr& frame) {
    if (!intervals_.empty()) intervals_.back().cur = frame;
  }
  /// Forgets all. Keeps the memory of the points.
  void clear() noexcept {
    for (Interval& interval : intervals_) interval.cur.reset();
    intervals_.clear();
  }

  /// Aligns the intervals that contradict the newest one again, and adds those that have a motion that agrees with it
  /// to `revised`, the oldest first. @param step the newest interval, which is known.
  template <typename Camera, typename Aligner>
  void revise(const CameraStep& step, const Camera& camera, const CameraMotionEstimator& estimator, Aligner& aligner,
              MinimaWorkspace& workspace, std::vector<RevisedInterval>& revised) {
    const std::vector<const PointSet*> no_objects;
    Vector6<double> velocity = step.T_cur_prev.log() / step.seconds;
    for (std::size_t i = intervals_.size(); i-- > 0 && intervals_[i].cur;) {
      const Interval& past = intervals_[i];
      const SE3d expected = SE3d::exp(velocity * past.step.seconds);
      const double reach = estimator.reach(past.step.seconds);
      const auto agrees = [&](const SE3d& T) { return (T.t - expected.t).norm() <= reach; };
      if (agrees(past.step.T_cur_prev)) return;

      // By the points that the wrong motion does not explain: with the others its minimum would be found again.
      const Alignment& wrong = past.step.alignment;
      SecondMotion::take_unexplained(AlignProblem<Camera>{past.points, past.cur->pyramid, camera}, wrong.state, 0,
                                     wrong.sigma_intensity, aligner, workspace);
      std::swap(unexplained_, workspace.unexplained);
      if (unexplained_.size() < estimator.settings.min_points) return;
      starts_.assign(1, expected * past.T_prev_points);
      RevisedInterval again{past.cur->id, past.cur->timestamp, past.step};
      Alignment& a = again.step.alignment;
      a = estimator.estimate(unexplained_, past.cur->pyramid, camera, starts_, nullptr,
                             {no_objects, past.T_prev_points.inverse(), reach}, aligner, workspace);
      again.step.T_cur_prev = a.state.T * past.T_prev_points.inverse();
      again.step.covariance = estimator.settings.covariance_scale * a.covariance.template topLeftCorner<6, 6>();
      const bool explains_much = a.inliers >= SecondMotion::kMinShare * wrong.seen;
      if (!explains_much || !estimator.accepts(a, false) || !agrees(again.step.T_cur_prev)) return;
      velocity = again.step.T_cur_prev.log() / past.step.seconds;
      revised.insert(revised.begin(), again);
    }
  }

 private:
  static constexpr std::size_t kMost = 4;  ///< older intervals are believed, because each one holds a frame

  struct Interval {
    PointSet points;     ///< of the background, as they were then
    SE3d T_prev_points;  ///< from their frame to the one where the interval begins
    CameraStep step;
    FramePtr cur;  ///< the frame that it leads to
  };

  RecyclingList<Interval> intervals_;  ///< oldest first
  PointSet unexplained_;
  std::vector<SE3d> starts_;
};

DOT_END_NAMESPACE
