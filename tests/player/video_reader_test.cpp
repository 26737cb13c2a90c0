// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player/video_reader.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "player/video_file.hpp"
#include "sequence/errors.hpp"

namespace {

namespace fs = std::filesystem;

class VideoReaderTest : public ::testing::Test {
 protected:
  // A name of its own for each test, because they run side by side.
  VideoReaderTest()
      : path_(fs::temp_directory_path() / (std::string("dot_video_reader_") +
                                           ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".avi")) {
    fs::remove(path_);
  }
  ~VideoReaderTest() override { fs::remove(path_); }

  fs::path path_;
};

#ifdef DOT_EXAMPLE_VIDEO

TEST_F(VideoReaderTest, ReadsFramesInAnyOrder) {
  {
    player::VideoFile video(path_, 10);
    for (int i = 0; i < 6; ++i) video.add(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(40 * i)));
    video.finish();
  }
  const auto video = player::open_video(path_);
  ASSERT_EQ(video->times().size(), 6U);
  for (std::size_t i = 1; i < 6; ++i) EXPECT_NEAR(video->times()[i] - video->times()[i - 1], 0.1, 1e-6);
  for (const int i : {0, 1, 4, 2, 5, 5}) {
    const cv::Mat image = video->read(i);
    ASSERT_EQ(image.type(), CV_8UC3);
    EXPECT_EQ(image.size(), cv::Size(64, 48));
    EXPECT_NEAR(cv::mean(image)[0], 40 * i, 4) << "frame " << i;
  }
  EXPECT_THROW(video->read(6), runner::FileError);
}

TEST_F(VideoReaderTest, WhatIsNoVideoIsRefused) {
  EXPECT_THROW(player::open_video(path_), runner::FileError);
  std::ofstream(path_) << "no video";
  EXPECT_THROW(player::open_video(path_), runner::FileError);
}

#else

TEST_F(VideoReaderTest, SaysWhatItWasBuiltWithout) { EXPECT_THROW(player::open_video(path_), runner::FileError); }

#endif

}  // namespace
