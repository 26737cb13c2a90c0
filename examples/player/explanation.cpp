// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "explanation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "run/turning.hpp"
#include "sequence/text.hpp"

namespace player {
namespace {

using runner::format;

/// Near things move at centimetres per second.
constexpr double slow = 0.1;  // m/s

std::string in_metres_per_second(double speed) { return format(speed < slow ? "%.3f m/s" : "%.2f m/s", speed); }

std::string with_sigma(double speed, double sigma) {
  const bool fine = std::min(speed, sigma) < slow;
  return format(fine ? "%.3f m/s" : "%.2f m/s", speed) + format(fine ? " (sigma %.3f)" : " (sigma %.2f)", sigma);
}

/// A threshold.
std::string probability(double p) { return format("%.3g", p); }

const char* name_of(dot::State state) {
  return state == dot::State::NotObservable ? "not decided" : dot::to_string(state);
}

std::string measured(const dot::ObjectResult& object, const dot::Options& options) {
  std::string text = "Measured " +
                     with_sigma(object.speed, sigma_of_length(object.velocity, object.velocity_covariance)) +
                     format(" at %.1f m", object.range);
  if (options.classifier == dot::ClassifierKind::Velocity) {
    const runner::Turning turning = runner::turning_of(object);
    if (options.velocity.most_turning > 0 && turning.sigma > 0)
      text += "; turning moves its points by " + with_sigma(turning.speed, turning.sigma);
    return text + "; faster than " + in_metres_per_second(options.velocity.v0_at(object.range)) + " counts as moving. ";
  }
  const dot::EntropySettings& s = options.entropy;
  text += "; its points move by " + format("%.1f px", object.disparity_px) + ", the limit is " +
          format("%.1f px", std::max(s.min_disparity, s.noise_factor * object.disparity_noise_px)) +
          "; the entropy is " + format("%.1f nats", object.entropy) + ", it must be ";
  return text +
         (options.classifier == dot::ClassifierKind::Entropy ? "below " + format("%.1f", s.max_entropy)
                                                             : "above " + format("%.1f", s.min_entropy)) +
         ". ";
}

/// How the belief leads to the state, for the velocity test.
std::string believed(const dot::ObjectResult& object, const dot::VelocitySettings& s) {
  const double p = object.p_moving;
  const std::string is = "P(moving) is " + format("%.3f", p);
  switch (object.state) {
    case dot::State::Moving:
      return is + (p > s.decide ? ", above " + probability(s.decide) + ": moving."
                                : ", still above " + probability(s.keep) + ": it stays moving.");
    case dot::State::Static:
      return is + (p < 1 - s.decide ? ", below " + probability(1 - s.decide) + ": static."
                                    : ", still below " + probability(1 - s.keep) + ": it stays static.");
    default:
      return is + ": not decided. Above " + probability(s.decide) + " it would be moving, below " +
             probability(1 - s.decide) + " static.";
  }
}

/// What keeps an undecided object undecided although it was measured.
std::string weak_evidence(const dot::ObjectResult& object, const dot::VelocitySettings& s) {
  const double limit = s.v0_at(object.range);
  const double sigma = sigma_of_length(object.velocity, object.velocity_covariance);
  const bool turns = s.most_turning > 0 && runner::turning_of(object).exceeds(limit);
  const bool moves = turns || object.speed - 2 * sigma > limit;
  if (moves || object.speed + 2 * sigma < limit)
    return std::string(" This frame alone speaks for ") + (moves ? "moving" : "static") +
           ", but a single measurement may be wrong: more are needed.";
  return " With this sigma the speed may be on either side of the limit: the measurement tells little.";
}

}  // namespace

const char* in_words(dot::Reason reason) {
  constexpr std::array<const char*, 17> words{
      "measured",
      "it is new, and the frame before gives no motion",
      "the frames before were dropped, so there is nothing to compare with",
      "its mask has too few pixels",
      "its mask has too little valid depth",
      "it has too little texture",
      "too small a part of it stays inside the image",
      "nearer objects hide too much of it",
      "the alignment did not converge",
      "its pixels do not look as they did in the frames before (phi is low)",
      "too few of its points agree with the motion found",
      "the motion found contradicts the measured depth",
      "the motion found is faster than object.max_speed",
      "it is hidden: not expected to be visible, and no mask shows it",
      "the camera's motion was not found",
      "it was not seen for too long and is dropped",
      "there are more objects than object.max_fitted, and it is not among the largest"};
  static_assert(words.size() == static_cast<std::size_t>(dot::Reason::TooManyObjects) + 1);
  const auto index = static_cast<std::size_t>(reason);
  return index < words.size() ? words[index] : dot::to_string(reason);
}

const char* in_words(dot::CameraStatus status) {
  switch (status) {
    case dot::CameraStatus::FirstFrame: return "There is no earlier frame to compare with.";
    case dot::CameraStatus::Tracked: return "The camera's motion was found.";
    case dot::CameraStatus::FromHost: return "The camera's motion was given.";
    case dot::CameraStatus::TooLittleDepth:
      return "Too little depth in the background: the camera's motion is a guess.";
    case dot::CameraStatus::Lost: return "The camera's motion was not found: it is a guess.";
  }
  return dot::to_string(status);
}

std::string explanation(const dot::ObjectResult& object, const dot::Options& options) {
  const bool is_measured = object.reason == dot::Reason::None;
  std::string text = is_measured ? measured(object, options)
                                 : std::string("Not measured in this frame: ") + in_words(object.reason) + ". ";
  if (object.always_dynamic) return text + "Its class always counts as moving.";
  const bool undecided = object.state == dot::State::NotObservable;
  if (options.classifier == dot::ClassifierKind::Velocity) {
    text += believed(object, options.velocity);
    if (undecided && is_measured) text += weak_evidence(object, options.velocity);
  } else {
    text += std::string("It is ") + name_of(object.state) + (is_measured ? "." : ", as before.");
  }
  if (undecided && object.last_decided != dot::State::NotObservable)
    text += std::string(" It was last decided: ") + name_of(object.last_decided) + '.';
  return text;
}

double sigma_of_length(const std::array<double, 3>& v, const std::array<double, 9>& covariance) {
  double squared = 0, variance = 0;
  for (std::size_t r = 0; r < 3; ++r) {
    squared += v[r] * v[r];
    for (std::size_t c = 0; c < 3; ++c) variance += v[r] * covariance[3 * r + c] * v[c];
  }
  // Without a direction the largest of the axes.
  if (squared <= 0) return std::sqrt(std::max({covariance[0], covariance[4], covariance[8]}));
  return std::sqrt(std::max(0.0, variance / squared));
}

}  // namespace player
