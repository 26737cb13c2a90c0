// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sequence/sequence.hpp"

namespace eval {

/// Replaces the masks of a frame by a list of their boxes, as a detector gives them: they overlap, and show what is
/// beside and behind the objects. @param margin added on each side, as a share of the box's width or height.
void make_boxes(double margin, runner::SequenceFrame& frame);

}  // namespace eval
