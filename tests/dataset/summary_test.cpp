// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dataset/summary.hpp"

#include <gtest/gtest.h>

namespace dataset {
namespace {

TEST(Summary, HasALineForEachSequence) {
  EXPECT_EQ(summary_csv({{{"/data/a", "a"}, Status::Complete, {24, 2, 3, 1, 0, 5.25}, ""},
                         {{"/data/b", "b"}, Status::Failed, {}, "/data/b/x: is 3x4, the camera is \"5x6\""},
                         {{"/data/c, too", "c"}, Status::Interrupted, {}, ""}}),
            "name,sequence,status,frames,moving,static,undecided,camera_lost,ms_per_frame,reason\n"
            "a,/data/a,complete,24,2,3,1,0,5.250,\n"
            "b,/data/b,failed,,,,,,,\"/data/b/x: is 3x4, the camera is \"\"5x6\"\"\"\n"
            "c,\"/data/c, too\",interrupted,,,,,,,\n");
}

}  // namespace
}  // namespace dataset
