// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// All headers of the header tier. The compiled default pipeline, without Eigen and OpenCV in its interface, is in
/// dot/tracker.hpp.

#include "dot/camera/pinhole.hpp"
#include "dot/camera/radtan.hpp"
#include "dot/image/opencv.hpp"
#include "dot/motion/classifier.hpp"
#include "dot/pipeline/compiled.hpp"
#include "dot/pipeline/dot.hpp"
#include "dot/pipeline/exclusion.hpp"
#include "dot/version.hpp"
