// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include "dot/motion/belief.hpp"
#include "dot/motion/state.hpp"

/// @file
/// Classifiers: policies that turn fits into states. A classifier is a struct with a nested `Memory`, default
/// constructible and copyable, and the operator below. The pipeline keeps one `Memory` for each object.
///
///     Decision operator()(Memory&, const MotionEstimate* fit, const Matrix3<double>& R_cur_prev, double dt) const;
///
/// The operator is called once a frame for each object, with null if there was no fit. Velocities of the fit are in the
/// previous camera's axes, those of the decision in the current one's. An object whose first mask is of this frame is
/// fitted to the frame before. That fit is given in the current camera's axes, with R_cur_prev = 1 and dt = 0.

DOT_BEGIN_NAMESPACE

/// A classifier's decision about an object.
struct Decision {
  State state = State::NotObservable;                    ///< Static, Moving or NotObservable
  double p_moving = 0.5;                                 ///< probability that it moves, 0 to 1
  Vector3<double> velocity = Vector3<double>::Zero();    ///< fused, m/s, axes of the current camera
  Matrix3<double> covariance = Matrix3<double>::Zero();  ///< zero if there is no velocity
};

namespace classifier_concept {
/// Whether T has Memory and the call of the concept.
template <typename T, typename = void>
inline constexpr bool holds_v = false;
template <typename T>
inline constexpr bool holds_v<
    T, std::enable_if_t<std::is_same_v<decltype(std::declval<const T&>()(std::declval<typename T::Memory&>(),
                                                                         std::declval<const MotionEstimate*>(),
                                                                         std::declval<const Matrix3<double>&>(), 0.1)),
                                       Decision>>> = true;
}  // namespace classifier_concept

/// Whether T satisfies the concept above.
template <typename T>
inline constexpr bool is_classifier_v = classifier_concept::holds_v<T>;

/// Default: tests whether the object is faster than v0 or turns as fast, by a belief over time, see Belief. A state is
/// reached at the probability `decide` and kept down to `keep`.
struct VelocityClassifier {
  VelocitySettings settings;  ///< thresholds and priors

  /// What is known of an object.
  struct Memory {
    Belief belief;                       ///< over the fits so far
    State state = State::NotObservable;  ///< after the last frame
  };

  /// v0 of an object at this range, m/s. Near objects count as moving at lower speeds.
  double v0(double range) const { return settings.v0_at(range); }

  /// Decides on an object in a frame, see the concept.
  Decision operator()(Memory& m, const MotionEstimate* fit, const Matrix3<double>& R_cur_prev, double dt) const;
};

/// The velocity test of a single frame, without memory: moving if the 99 % ellipsoid of v excludes the ball
/// |v| <= v0, static if it lies inside. For comparison.
struct SingleFrameClassifier {
  VelocitySettings settings;  ///< of these, only those of v0 count
  /// Nothing is kept.
  struct Memory {};

  /// Decides on an object in a frame, see the concept.
  Decision operator()(Memory&, const MotionEstimate* fit, const Matrix3<double>& R_cur_prev, double) const;
};

/// The paper's rule (section 3.5), with the gate as H < H_max: a badly determined pose has *high* entropy, so the
/// printed condition H > H_min would reject the best observed objects first; `literal` applies it as printed.
/// Moving if d_d > f(H) = max(d_min, k d_noise).
struct EntropyClassifier {
  EntropySettings settings;  ///< thresholds
  bool literal = false;      ///< whether to apply the condition as printed

  /// What is known of an object.
  struct Memory {
    State state = State::NotObservable;  ///< after the last frame
  };

  /// Decides on an object in a frame, see the concept.
  Decision operator()(Memory& m, const MotionEstimate* fit, const Matrix3<double>& R_cur_prev, double) const;
};

DOT_END_NAMESPACE

#ifndef DOT_USES_COMPILED_PIPELINE
#include "dot/motion/impl/classifier.hpp"
#endif
