// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "confusion.hpp"
#include "dot/pipeline/result.hpp"
#include "sequence/sequence.hpp"

namespace eval {

constexpr std::size_t band_count = 4;
/// Bands of range, metres: from band_limits[i] to below band_limits[i + 1].
constexpr double band_limits[band_count + 1] = {0, 15, 30, 60, 1e9};
constexpr const char* band_names[band_count] = {"0-15", "15-30", "30-60", "60+"};

constexpr std::size_t speed_count = 9;
constexpr const char* speed_names[speed_count] = {"0",   "0-0.1", "0.1-0.25", "0.25-0.5", "0.5-1",
                                                  "1-3", "3-8",   "8+",       "unknown"};
/// By band of range; the last are those whose range is not known.
using AnswersByRange = std::array<AnswerCounts, band_count + 1>;
using AnswersBySpeed = std::array<AnswersByRange, speed_count>;
AnswerCounts at_all_ranges(const AnswersByRange& by_range);

/// Objects of one band of range.
struct Band {
  Confusion confusion;
  std::vector<double> moving_speed_error;  ///< m/s
  std::vector<double> motion_error_m;      ///< of T_o at the object's origin
  std::vector<double> motion_error_deg;
  std::vector<double> static_speed;  ///< m/s
  std::vector<double> static_nees;   ///< sum of (v / sigma)^2 over x, y, z

  void add(const Band& other);
  double nees_per_axis() const { return mean(static_nees) / 3; }
  double within_95() const;
};

/// Pixels of one frame.
struct FramePixels {
  int frame = 0;
  long moving = 0;   ///< that truly move
  long correct = 0;  ///< of these labelled moving
  long wrong = 0;    ///< labelled moving that do not move
  long missed() const { return moving - correct; }
};

/// One true object in one frame with what is said of it.
struct Sighting {
  int frame = 0;
  double time = 0;
  int id = 0;
  bool moving = false;
  double speed = 0;             ///< m/s; negative: unknown
  double range = not_a_number;  ///< metres
  long area = 0;                ///< pixels
  Answer answer = Answer::Missed;
};

constexpr double turning_deg_per_s = 20;

/// What a run says of objects.
struct ObjectScore {
  Confusion confusion;
  AnswersBySpeed by_speed{};
  std::array<Band, band_count> bands;
  std::vector<FramePixels> pixels;
  Confusion turning;  ///< of objects that turn at `turning_deg_per_s` or more
  std::vector<double> instance_iou;
  std::vector<Sighting> sightings;  ///< all, also those too small to count
  int id_switches = 0;
  int no_depth = 0;
  long decided = 0;  ///< answers moving or static, and how many of them have the figure:
  long with_speed = 0;
  long with_sigma = 0;
  long with_motion = 0;

  long moving_pixels() const;
  double mask_iou() const;
  double speed_coverage() const { return coverage(with_speed); }
  double sigma_coverage() const { return coverage(with_sigma); }
  double motion_coverage() const { return coverage(with_motion); }

 private:
  double coverage(long with) const { return ratio(static_cast<double>(with), static_cast<double>(decided)); }
};

struct ObjectScoring {
  double min_speed = 1;  ///< m/s; slower movers count by speed alone
  int from = 0;          ///< frames with a smaller number do not count
};

/// Scores the frames of a run against the true objects; docs/evaluation.md defines each figure.
class ObjectScorer {
 public:
  explicit ObjectScorer(const ObjectScoring& scoring) : scoring_(scoring) {}

  /// The next frame. Frames without true instances do not count.
  /// @param previous truth of the frame before it, or null.
  FramePixels add(const runner::RecordingEntry& entry, const runner::FrameTruth& truth,
                  const runner::TruthEntry* previous, const dot::Result& result);

  const ObjectScore& score() const { return score_; }

 private:
  /// The pixels of one true object.
  struct Region {
    long area = 0;
    long measured = 0;
    long called_moving = 0;
    std::map<std::uint32_t, long> tracks;
    std::vector<double> depth;
  };

  void add_object(const runner::RecordingEntry& entry, const runner::TruthEntry* previous, const dot::Result& result,
                  int id, const Region& region, double range, long track_area);

  ObjectScoring scoring_;
  ObjectScore score_;
  bool turns(const runner::RecordingEntry& entry, const runner::TruthEntry* previous, int id) const;

  std::map<int, long> previous_area_;
  double previous_time_ = 0;
  std::map<int, std::uint32_t> owner_;
};

}  // namespace eval
