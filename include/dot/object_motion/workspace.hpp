// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "dot/align/minima.hpp"
#include "dot/mask/observations.hpp"
#include "dot/object_motion/reference.hpp"
#include "dot/points/select.hpp"

DOT_BEGIN_NAMESPACE

/// Buffers of a thread that follows objects, with its own copy of the aligner.
template <typename Aligner>
struct ObjectWorkspace {
  Aligner aligner;                                             ///< the thread's own
  MinimaWorkspace minima;                                      ///< of the object's cost
  std::vector<SE3d> starts;                                    ///< motions T_o to start from
  std::vector<std::pair<double, const Observation*>> nearest;  ///< with squared distances
  ObjectReference here;                                        ///< the object as the current frame shows it
  SelectionWorkspace selection;                                ///< of the object's points
};

DOT_END_NAMESPACE
