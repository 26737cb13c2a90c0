// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "dot/camera/settings.hpp"
#include "dot/kernel/kernels.hpp"
#include "dot/mask/settings.hpp"
#include "dot/object_motion/estimator.hpp"
#include "dot/points/overlaid_pixels.hpp"
#include "dot/points/settings.hpp"
#include "dot/threads/threads.hpp"

DOT_BEGIN_NAMESPACE

/// The policies and settings for tracking objects. They are borrowed.
template <typename Camera, typename Classifier, typename Noise>
struct TrackingSetup {
  const Camera& camera;                    ///< of level 0
  const Classifier& classifier;            ///< decides whether an object moves
  const Noise& noise;                      ///< of the depth
  const ObjectMotionEstimator& estimator;  ///< finds and checks a motion
  const MaskSettings& mask;                ///< association and propagation
  const SelectionSettings& selection;      ///< of an object's points
  DepthSource depth_source;                ///< source of the depth
  const OverlaidPixels& overlaid;          ///< that give no points
  const kernel::Kernels& kernels;          ///< of the selection
  const Threads& threads;                  ///< that follow objects
};

DOT_END_NAMESPACE
