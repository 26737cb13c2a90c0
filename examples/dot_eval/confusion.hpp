// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "statistics.hpp"

namespace eval {

/// What the tracker says of a true object: the state of the track that covers most of it, or that none does.
enum class Answer { Static, Moving, NotObservable, Missed };

constexpr std::size_t answer_count = 4;
constexpr const char* answer_names[answer_count] = {"static", "moving", "unobservable", "missed"};

using AnswerCounts = std::array<long, answer_count>;

/// Counts of object-frames by truth and answer.
struct Confusion {
  AnswerCounts standing{};
  AnswerCounts moving{};

  void add(bool is_moving, Answer answer) { ++(is_moving ? moving : standing)[static_cast<std::size_t>(answer)]; }
  void add(const Confusion& other) {
    for (std::size_t i = 0; i < answer_count; ++i) {
      standing[i] += other.standing[i];
      moving[i] += other.moving[i];
    }
  }

  long of_standing(Answer answer) const { return standing[static_cast<std::size_t>(answer)]; }
  long of_moving(Answer answer) const { return moving[static_cast<std::size_t>(answer)]; }
  long standing_total() const { return sum(standing); }
  long moving_total() const { return sum(moving); }
  long total() const { return standing_total() + moving_total(); }
  long correct() const { return of_moving(Answer::Moving) + of_standing(Answer::Static); }
  long decided() const { return correct() + of_moving(Answer::Static) + of_standing(Answer::Moving); }

  double precision() const { return share(of_moving(Answer::Moving), called_moving()); }
  double recall() const { return share(of_moving(Answer::Moving), moving_total()); }
  double f1() const { return share(2 * of_moving(Answer::Moving), called_moving() + moving_total()); }
  double decided_share() const { return share(decided(), total()); }
  double decided_accuracy() const { return share(correct(), decided()); }
  double missed_share() const { return share(of_moving(Answer::Missed) + of_standing(Answer::Missed), total()); }
  double static_kept_share() const { return share(of_standing(Answer::Static), standing_total()); }
  double static_moving_share() const { return share(of_standing(Answer::Moving), standing_total()); }

 private:
  static long sum(const AnswerCounts& counts) { return counts[0] + counts[1] + counts[2] + counts[3]; }
  static double share(long part, long whole) { return ratio(static_cast<double>(part), static_cast<double>(whole)); }
  long called_moving() const { return of_moving(Answer::Moving) + of_standing(Answer::Moving); }
};

}  // namespace eval
