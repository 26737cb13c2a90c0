// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "object_score.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>

#include "pose_error.hpp"

namespace eval {
namespace {

constexpr long min_area = 200;         // pixels, in this frame and in the one before it
constexpr long min_measured = 30;      // pixels with depth
constexpr double chi_square_3 = 7.81;  // 95 % of three squared standard normal variables are below

/// The track that covers most of a region, or 0 where none covers a quarter.
std::uint32_t covering_track(const std::map<std::uint32_t, long>& tracks, long area) {
  std::uint32_t best = 0;
  long most = 0;
  for (const auto& [id, count] : tracks) {
    if (id == 0 || count <= most) continue;
    best = id;
    most = count;
  }
  return most * 4 >= area ? best : 0;
}

std::size_t speed_class(bool moving, double speed) {
  if (!moving) return 0;
  if (speed < 0) return speed_count - 1;
  constexpr double limits[] = {0.1, 0.25, 0.5, 1, 3, 8};
  return 1 + static_cast<std::size_t>(std::upper_bound(std::begin(limits), std::end(limits), speed) - limits);
}

/// @return band_count if the range is not known.
std::size_t band_of(double range) {
  for (std::size_t i = 0; i < band_count; ++i)
    if (range >= band_limits[i] && range < band_limits[i + 1]) return i;
  return band_count;
}

Answer answer_of(const dot::ObjectResult* object) {
  if (object == nullptr) return Answer::Missed;
  if (object->state == dot::State::Moving) return Answer::Moving;
  if (object->state == dot::State::Static) return Answer::Static;
  return Answer::NotObservable;
}

/// Sum of (v / sigma)^2 over the axes, where all sigmas are known.
std::optional<double> squared_normalised(const dot::ObjectResult& object) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double variance = object.velocity_covariance[4 * axis];
    if (!(variance > 0) || !std::isfinite(variance) || !std::isfinite(object.velocity[axis])) return std::nullopt;
    sum += object.velocity[axis] * object.velocity[axis] / variance;
  }
  return sum;
}

bool is_finite(const std::array<double, 12>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

AnswerCounts at_all_ranges(const AnswersByRange& by_range) {
  AnswerCounts all{};
  for (const AnswerCounts& counts : by_range)
    for (std::size_t answer = 0; answer < answer_count; ++answer) all[answer] += counts[answer];
  return all;
}

void Band::add(const Band& other) {
  confusion.add(other.confusion);
  append(moving_speed_error, other.moving_speed_error);
  append(motion_error_m, other.motion_error_m);
  append(motion_error_deg, other.motion_error_deg);
  append(static_speed, other.static_speed);
  append(static_nees, other.static_nees);
}

double Band::within_95() const {
  const auto inside = std::count_if(static_nees.begin(), static_nees.end(), [](double v) { return v < chi_square_3; });
  return ratio(static_cast<double>(inside), static_cast<double>(static_nees.size()));
}

long ObjectScore::moving_pixels() const {
  long sum = 0;
  for (const FramePixels& frame : pixels) sum += frame.moving;
  return sum;
}

double ObjectScore::mask_iou() const {
  long both = 0;
  long either = 0;
  for (const FramePixels& frame : pixels) {
    both += frame.correct;
    either += frame.moving + frame.wrong;
  }
  return ratio(static_cast<double>(both), static_cast<double>(either));
}

FramePixels ObjectScorer::add(const runner::RecordingEntry& entry, const runner::FrameTruth& truth,
                              const runner::TruthEntry* previous, const dot::Result& result) {
  FramePixels pixels;
  pixels.frame = entry.number;
  if (truth.instance.empty()) return pixels;
  std::map<int, Region> regions;
  std::map<std::uint32_t, long> track_areas;
  long called_moving = 0;
  Region* region = nullptr;
  int region_id = 0;
  for (int y = 0; y < truth.instance.rows; ++y) {
    const int* ids = truth.instance.ptr<int>(y);
    const float* depth = truth.depth.empty() ? nullptr : truth.depth.ptr<float>(y);
    const float* measured = truth.measured.empty() ? nullptr : truth.measured.ptr<float>(y);
    for (int x = 0; x < truth.instance.cols; ++x) {
      const std::uint32_t track = result.ids(x, y);
      const bool moving = result.labels(x, y) == static_cast<std::uint8_t>(dot::State::Moving);
      if (track != 0) ++track_areas[track];
      called_moving += moving;
      if (ids[x] == 0) continue;
      if (region == nullptr || ids[x] != region_id) region = &regions[region_id = ids[x]];
      ++region->area;
      ++region->tracks[track];
      region->called_moving += moving;
      region->measured += measured != nullptr && measured[x] > 0;
      if (depth != nullptr && depth[x] > 0) region->depth.push_back(depth[x]);
    }
  }

  pixels.wrong = called_moving;
  std::map<int, long> areas;
  for (auto& [id, r] : regions) {
    areas[id] = r.area;
    const auto object = entry.truth.objects.find(id);
    if (object == entry.truth.objects.end()) continue;
    const bool moving = object->second.moving;
    const bool slow = moving && object->second.speed >= 0 && object->second.speed < scoring_.min_speed;
    const bool blind = !truth.measured.empty() && r.measured < min_measured;
    if (slow || blind || moving) pixels.wrong -= r.called_moving;
    if (moving && !slow && !blind) {
      pixels.moving += r.area;
      pixels.correct += r.called_moving;
    }
    const std::uint32_t track = covering_track(r.tracks, r.area);
    const double range = median(r.depth);
    score_.sightings.push_back({entry.number, entry.timestamp, id, moving, object->second.speed, range, r.area,
                                answer_of(track != 0 ? result.find(track) : nullptr)});
    const auto before = previous_area_.find(id);
    const bool counts = r.area >= min_area && before != previous_area_.end() && before->second >= min_area;
    if (!counts || entry.number < scoring_.from) continue;
    if (blind)
      ++score_.no_depth;
    else
      add_object(entry, previous, result, id, r, range, track != 0 ? track_areas[track] : 0);
  }
  previous_area_ = std::move(areas);
  previous_time_ = entry.timestamp;
  if (entry.number >= scoring_.from) score_.pixels.push_back(pixels);
  return pixels;
}

/// Whether the true poses say so of an object since the frame before.
bool ObjectScorer::turns(const runner::RecordingEntry& entry, const runner::TruthEntry* previous, int id) const {
  const double seconds = entry.timestamp - previous_time_;
  if (previous == nullptr || !(seconds > 0)) return false;
  const auto before = previous->poses.find(id);
  const auto after = entry.truth.poses.find(id);
  if (before == previous->poses.end() || after == entry.truth.poses.end()) return false;
  const Eigen::Matrix4d motion = after->second * before->second.inverse();
  return rotation_angle_deg(motion.topLeftCorner<3, 3>()) >= turning_deg_per_s * seconds;
}

void ObjectScorer::add_object(const runner::RecordingEntry& entry, const runner::TruthEntry* previous,
                              const dot::Result& result, int id, const Region& region, double range, long track_area) {
  const runner::TrueObject& truth = entry.truth.objects.at(id);
  const std::uint32_t track = covering_track(region.tracks, region.area);
  const dot::ObjectResult* object = track != 0 ? result.find(track) : nullptr;
  const Answer answer = answer_of(object);
  const std::size_t where = band_of(range);
  Band* band = where < band_count ? &score_.bands[where] : nullptr;

  const bool slow = truth.moving && truth.speed >= 0 && truth.speed < scoring_.min_speed;
  ++score_.by_speed[speed_class(truth.moving, truth.speed)][where][static_cast<std::size_t>(answer)];
  if (!slow) score_.confusion.add(truth.moving, answer);
  if (turns(entry, previous, id)) score_.turning.add(truth.moving, answer);
  if (!slow && band != nullptr) band->confusion.add(truth.moving, answer);
  if (object == nullptr) return;

  const long both = region.tracks.at(track);
  score_.instance_iou.push_back(ratio(static_cast<double>(both), static_cast<double>(region.area + track_area - both)));
  const auto [owner, is_new] = owner_.try_emplace(id, track);
  if (!is_new && owner->second != track) ++score_.id_switches;
  owner->second = track;

  const bool measured = object->reason == dot::Reason::None;
  const bool has_speed = measured && std::isfinite(object->speed);
  const bool has_motion = measured && is_finite(object->T_o);
  const std::optional<double> nees = measured ? squared_normalised(*object) : std::nullopt;
  if (answer == Answer::Moving || answer == Answer::Static) {
    ++score_.decided;
    score_.with_speed += has_speed;
    score_.with_sigma += nees.has_value();
    score_.with_motion += has_motion;
  }
  if (band == nullptr) return;
  if (!truth.moving) {
    if (truth.speed > 0) return;  // it creeps, or has just stopped
    if (has_speed) band->static_speed.push_back(object->speed);
    if (has_speed && nees) band->static_nees.push_back(*nees);
    return;
  }
  if (has_speed && truth.speed >= 0) band->moving_speed_error.push_back(std::abs(object->speed - truth.speed));
  if (!has_motion || previous == nullptr || !previous->camera) return;
  const auto before = previous->poses.find(id);
  const auto after = entry.truth.poses.find(id);
  if (before == previous->poses.end() || after == entry.truth.poses.end()) return;
  const MotionError error =
      motion_error(runner::pose_from_row_major(object->T_o.data()), *previous->camera, before->second, after->second);
  band->motion_error_m.push_back(error.metres);
  band->motion_error_deg.push_back(error.degrees);
}

}  // namespace eval
