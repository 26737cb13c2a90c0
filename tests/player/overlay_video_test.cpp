// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player/overlay_video.hpp"

#include <gtest/gtest.h>

#include "support/recording_folder.hpp"
#include "wall.hpp"

#ifdef DOT_EXAMPLE_VIDEO
#include <opencv2/videoio.hpp>

namespace player {
namespace {

/// Frames 10, 12, 14, ...
runner::Recording recording(int frames, double interval) {
  runner::Recording recording;
  for (int i = 0; i < frames; ++i) {
    recording.entries.emplace_back();
    recording.entries.back().number = 10 + 2 * i;
    recording.entries.back().timestamp = interval * i;
  }
  return recording;
}

/// A frame of one grey value.
runner::SequenceFrame grey(int number, int value) {
  runner::SequenceFrame frame = wall(number);
  frame.image = cv::Scalar::all(value);
  return frame;
}

struct Written {
  double fps = 0;
  std::vector<int> brightness;  ///< of each picture, to 20
};

Written write(const runner::Recording& recording, std::optional<double> fps,
              const std::vector<runner::SequenceFrame>& frames) {
  const RecordingFolder folder;
  const std::filesystem::path path = folder.path() / "run.mp4";
  const HandMadeResult nothing(frame_size);
  OverlayVideo video(path, recording, fps);
  for (const runner::SequenceFrame& frame : frames) video.add(frame, nothing.result(), 1);
  video.finish();
  cv::VideoCapture capture(path.string());
  Written written{capture.get(cv::CAP_PROP_FPS), {}};
  for (cv::Mat picture; capture.read(picture);)
    written.brightness.push_back(20 *
                                 cvRound(cv::mean(picture(cv::Rect(0, 0, picture.cols, picture.rows / 4)))[1] / 20));
  return written;
}

TEST(OverlayVideo, KeepsThePictureWhileFramesAreLeftOut) {
  const Written written = write(recording(6, 0.05), {}, {grey(12, 40), grey(14, 120), grey(20, 200)});
  EXPECT_EQ(written.brightness, (std::vector<int>{40, 40, 120, 120, 120, 200}));
  EXPECT_NEAR(written.fps, 20, 0.01);
}

TEST(OverlayVideo, HasTheRateThatIsAskedFor) {
  EXPECT_NEAR(write(recording(2, 0.05), 5, {grey(10, 40), grey(12, 120)}).fps, 5, 0.01);
  EXPECT_NEAR(write(recording(1, 0), {}, {grey(10, 40)}).fps, 10, 0.01);
}

}  // namespace
}  // namespace player

#endif
