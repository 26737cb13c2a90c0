// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "run/writer.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/hand_made_result.hpp"
#include "support/recording_folder.hpp"

namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Two frames; the second one revises `revisions` motions.
void write_run(const RecordingFolder& folder, std::size_t revisions) {
  const HandMadeResult nothing(cv::Size(6, 4));
  dot::CameraRevision revision;
  revision.T_cur_prev[11] = -0.5;
  std::vector<dot::CameraRevision> revised(revisions, revision);
  for (std::size_t i = 0; i < revisions; ++i) revised[i].frame_id = 7 + i;

  runner::ResultWriter writer({folder.path() / "out", {}, false}, folder.path());
  runner::SequenceFrame frame;
  dot::Result result = nothing.result();
  frame.number = 7;
  writer.write(frame, result, 1);
  EXPECT_FALSE(fs::exists(folder.path() / "out/revised.txt.partial"));
  frame.number = 8;
  result.revised = {revised.data(), revised.size()};
  writer.write(frame, result, 1);
  EXPECT_EQ(fs::exists(folder.path() / "out/revised.txt.partial"), revisions > 0);
  writer.finish();
}

TEST(ResultWriter, RevisedMotionsHaveAFileOnlyIfThereAreAny) {
  const RecordingFolder folder;
  const fs::path file = folder.path() / "out/revised.txt";
  write_run(folder, 2);
  EXPECT_EQ(content(file), "7 1 0 0 0 0 1 0 0 0 0 1 -0.5\n8 1 0 0 0 0 1 0 0 0 0 1 -0.5\n");
  EXPECT_FALSE(fs::exists(runner::partial_name(file)));
  write_run(folder, 0);
  EXPECT_FALSE(fs::exists(file)) << "of the earlier run";
  EXPECT_TRUE(fs::exists(folder.path() / "out/camera.txt"));
}

}  // namespace
