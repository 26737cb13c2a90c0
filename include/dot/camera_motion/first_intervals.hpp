// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "dot/camera_motion/background.hpp"
#include "dot/camera_motion/constant_velocity.hpp"
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
  /// to `revised`, the oldest first. None is revised if some of the background still moves as before: then the newest
  /// motion may be the wrong one.
  /// @param background the points of the newest interval. @param cur it leads to. @param step it, which is known.
  template <typename Camera, typename Aligner>
  void revise(const Background& background, const FrameData& cur, const CameraStep& step, const Camera& camera,
              const CameraMotionEstimator& estimator, Aligner& aligner, MinimaWorkspace& workspace,
              std::vector<RevisedInterval>& revised) {
    const auto contradicts = [&](const CameraStep& one, const CameraStep& other) {
      return change_of_place(one.T_cur_prev, motion_at_velocity_of(other, one.seconds)) > estimator.reach(one.seconds);
    };
    CameraStep next = step;
    for (std::size_t i = intervals_.size(); i-- > 0 && intervals_[i].cur && contradicts(intervals_[i].step, next);) {
      const Interval& past = intervals_[i];
      if (revised.empty() && other_motion(AlignProblem<Camera>{background.points, cur.pyramid, camera},
                                          background.T_now_points, step, past.step, estimator, aligner, workspace))
        return;
      const auto right = other_motion(AlignProblem<Camera>{past.points, past.cur->pyramid, camera}, past.T_prev_points,
                                      past.step, next, estimator, aligner, workspace);
      if (!right) return;
      next = *right;
      revised.insert(revised.begin(), {past.cur->id, past.cur->timestamp, next});
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

  static SE3d motion_at_velocity_of(const CameraStep& step, double seconds) {
    return SE3d::exp(step.T_cur_prev.log() * (seconds / step.seconds));
  }

  /// The motion, at about the velocity of another interval, of the points that the motion found for an interval does
  /// not explain. With all points the motion that was found would be found again.
  /// @param problem the interval's points and image. @param T_prev_points from the points' frame to its beginning.
  template <typename Camera, typename Aligner>
  std::optional<CameraStep> other_motion(const AlignProblem<Camera>& problem, const SE3d& T_prev_points,
                                         const CameraStep& found, const CameraStep& other,
                                         const CameraMotionEstimator& estimator, Aligner& aligner,
                                         MinimaWorkspace& workspace) {
    SecondMotion::take_unexplained(problem, found.alignment.state, 0, found.alignment.sigma_intensity, aligner,
                                   workspace);
    std::swap(unexplained_, workspace.unexplained);
    if (unexplained_.size() < estimator.settings.min_points) return std::nullopt;
    const SE3d expected = motion_at_velocity_of(other, found.seconds);
    const double reach = estimator.reach(found.seconds);
    starts_.assign(1, expected * T_prev_points);
    const std::vector<const PointSet*> no_objects;
    CameraStep step = found;
    Alignment& a = step.alignment;
    a = estimator.estimate(unexplained_, problem.image, problem.camera, starts_, nullptr,
                           {no_objects, T_prev_points.inverse(), reach}, aligner, workspace);
    estimator.set_motion(AlignProblem<Camera>{unexplained_, problem.image, problem.camera}, T_prev_points, aligner,
                         step);
    const bool explains_much = a.inliers >= SecondMotion::kMinShare * found.alignment.seen;
    if (!explains_much || !estimator.accepts(a, false) || change_of_place(step.T_cur_prev, expected) > reach)
      return std::nullopt;
    return step;
  }

  RecyclingList<Interval> intervals_;  ///< oldest first
  PointSet unexplained_;
  std::vector<SE3d> starts_;
};

DOT_END_NAMESPACE
