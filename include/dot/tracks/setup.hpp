// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/camera/settings.hpp"
#include "dot/kernel/kernels.hpp"
#include "dot/mask/settings.hpp"
#include "dot/object_motion/estimator.hpp"
#include "dot/points/settings.hpp"
#include "dot/threads/threads.hpp"

DOT_BEGIN_NAMESPACE

/// The policies and settings for tracking objects. They are borrowed.
template <typename Camera, typename Classifier, typename Noise>
struct TrackingSetup {
  const Camera& camera;
  const Classifier& classifier;
  const Noise& noise;
  const ObjectMotionEstimator& estimator;
  const MaskSettings& mask;
  const SelectionSettings& selection;
  DepthSource depth_source;
  const kernel::Kernels& kernels;
  const Threads& threads;
  bool exact_predictions;  ///< predicted outlines are needed at full resolution
};

DOT_END_NAMESPACE
