// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player/video_file.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <string>

#include "support/recording_folder.hpp"

#ifdef DOT_EXAMPLE_VIDEO
#include <opencv2/videoio.hpp>
#endif

namespace {

namespace fs = std::filesystem;

int files_in(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

#ifdef DOT_EXAMPLE_VIDEO

class VideoKinds : public ::testing::TestWithParam<const char*> {};

TEST_P(VideoKinds, HoldsThePicturesInTheirOrder) {
  const RecordingFolder folder;
  const fs::path path = folder.path() / (std::string("video") + GetParam());
  player::VideoFile file(path, 12);
  for (int i = 0; i < 5; ++i) file.add(cv::Mat(61, 83, CV_8UC3, cv::Scalar::all(40 + 40 * i)));  // odd sizes
  EXPECT_FALSE(fs::exists(path));
  file.finish();
  EXPECT_EQ(files_in(folder.path()), 1);

  cv::VideoCapture video(path.string());
  ASSERT_TRUE(video.isOpened());
  EXPECT_NEAR(video.get(cv::CAP_PROP_FPS), 12, 0.01);
  cv::Mat picture;
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(video.read(picture)) << i;
    EXPECT_EQ(picture.size(), cv::Size(84, 62));
    EXPECT_NEAR(cv::mean(picture)[1], 40 + 40 * i, 6);
  }
  EXPECT_FALSE(video.read(picture));
}

INSTANTIATE_TEST_SUITE_P(All, VideoKinds, ::testing::Values(".mp4", ".mkv", ".avi"));

TEST(VideoFile, StoppedInTheMiddleLeavesNothing) {
  const RecordingFolder folder;
  {
    player::VideoFile file(folder.path() / "video.mp4", 10);
    file.add(cv::Mat(60, 80, CV_8UC3, cv::Scalar::all(0)));
  }
  EXPECT_EQ(files_in(folder.path()), 0);
}

TEST(VideoFile, SaysWhatCannotBeWritten) {
  const RecordingFolder folder;
  EXPECT_THROW(player::VideoFile(folder.path() / "none" / "video.mp4", 10), runner::FileError);
  fs::create_directory(folder.path() / "folder.mp4");
  EXPECT_THROW(player::VideoFile(folder.path() / "folder.mp4", 10), runner::FileError);
  EXPECT_EQ(files_in(folder.path()), 1) << "nothing is left";
}

#else

TEST(VideoFile, SaysThatTheModuleIsMissing) {
  const RecordingFolder folder;
  try {
    player::VideoFile file(folder.path() / "video.mp4", 10);
    FAIL();
  } catch (const runner::FileError& error) {
    EXPECT_NE(std::string(error.what()).find("built without OpenCV's module videoio"), std::string::npos);
  }
  EXPECT_EQ(files_in(folder.path()), 0);
}

#endif

}  // namespace
