// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "sequence/sequence.hpp"
#include "support/recording_folder.hpp"

namespace {

using std::string_literals::operator""s;

const std::string camera = "36 36 2.5 1.5 6 4 0.5 10\n";

/// Three frames, `value` times their place + 1 in each.
void write(const RecordingFolder& folder, const std::vector<std::string>& names, int type, double value) {
  for (std::size_t i = 0; i < names.size(); ++i) folder.image(names[i], type, value * static_cast<double>(i + 1));
}

void write_folders(const RecordingFolder& folder) {
  write(folder, {"cam/img8.png", "cam/img9.png", "cam/img10.png"}, CV_8UC1, 10);
  write(folder, {"range/a.png", "range/b.png", "range/c.png"}, CV_16UC1, 1000);
  folder.text("intrinsics.txt", camera);
}

runner::SequenceOptions options_for(const RecordingFolder& folder) {
  runner::SequenceOptions options = folder.options();
  options.truth = false;
  options.images = "cam";
  options.depth_dir = "range";
  return options;
}

std::string complaint(const runner::SequenceOptions& options) {
  try {
    runner::Sequence sequence(options);
    for (int i = 0; i < sequence.size(); ++i) sequence.read(i);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

double metres(const runner::SequenceFrame& frame) {
  return frame.depth.at<std::uint16_t>(1, 1) / frame.depth_units_per_metre;
}

TEST(NamedLayout, FoldersInTheirOrder) {
  const RecordingFolder folder;
  write_folders(folder);
  folder.image("masks/img9.png", CV_8UC1, 5);
  folder.image("masks/000002.png", CV_8UC1, 6);
  runner::Sequence sequence(options_for(folder));
  ASSERT_EQ(sequence.size(), 3);
  for (int i = 0; i < 3; ++i) {
    const runner::SequenceFrame frame = sequence.read(i);
    EXPECT_EQ(frame.number, i);
    EXPECT_DOUBLE_EQ(frame.timestamp, 0.1 * i);
    EXPECT_EQ(frame.image.at<std::uint8_t>(0, 0), 10 * (i + 1));
    EXPECT_DOUBLE_EQ(metres(frame), i + 1) << "millimetres";
    EXPECT_EQ(frame.ids.empty(), i == 0);
  }
}

TEST(NamedLayout, PatternsByTheirNumbers) {
  const RecordingFolder folder;
  write(folder, {"l_04.png", "l_07.png"}, CV_8UC1, 10);
  write(folder, {"d4.png", "d5.png", "d7.png"}, CV_16UC1, 500);
  folder.text("intrinsics.txt", camera);
  runner::SequenceOptions options = options_for(folder);
  options.images = "l_%02d.png";
  options.depth_dir = "d%d.png";
  options.depth_scale = 500;
  runner::Sequence sequence(options);
  ASSERT_EQ(sequence.size(), 2);
  EXPECT_EQ(sequence.read(1).number, 7);
  EXPECT_DOUBLE_EQ(sequence.read(1).timestamp, 0.7);
  EXPECT_DOUBLE_EQ(metres(sequence.read(0)), 1);
  EXPECT_DOUBLE_EQ(metres(sequence.read(1)), 3) << "of number 7, not the second one";
  std::filesystem::remove(folder.path() / "d7.png");
  EXPECT_NE(complaint(options).find("d%d.png: there is none for l_07.png"), std::string::npos) << complaint(options);
}

TEST(NamedLayout, APercentInTheFoldersNameMeansNothing) {
  const RecordingFolder folder("100%d");
  write_folders(folder);
  ASSERT_EQ(complaint(options_for(folder)), "none");
  EXPECT_EQ(runner::Sequence(options_for(folder)).read(2).number, 2);
  write(folder, {"l_04.png", "l_07.png"}, CV_8UC1, 10);
  write(folder, {"d4.png", "d5.png", "d7.png"}, CV_16UC1, 1000);
  runner::SequenceOptions options = options_for(folder);
  options.images = "l_%02d.png";
  options.depth_dir = "d%d.png";
  ASSERT_EQ(complaint(options), "none");
  EXPECT_DOUBLE_EQ(metres(runner::Sequence(options).read(1)), 3) << "of number 7, not the second one";
}

TEST(NamedLayout, WhatIsMissingOrDoesNotFitIsNamed) {
  const RecordingFolder folder;
  write_folders(folder);
  const auto says = [](const runner::SequenceOptions& options, const std::string& text) {
    const std::string said = complaint(options);
    EXPECT_NE(said.find(text), std::string::npos) << said;
  };
  runner::SequenceOptions options = options_for(folder);
  ASSERT_EQ(complaint(options), "none");
  options.images = "none";
  says(options, "none: the folder cannot be read");
  options = options_for(folder);
  options.depth_dir = "none";
  says(options, "none: the folder cannot be read");
  options = options_for(folder);
  options.intrinsics = "none.txt";
  says(options, "none.txt: cannot be read");
  options = options_for(folder);
  options.images = "color.mp4";
  says(options, "color.mp4: this program reads no videos");
  options = options_for(folder);
  options.right = "range";
  says(options, "range/a.png: must be 8-bit grey or colour");
  options = options_for(folder);
  options.images.clear();
  options.right = "range";
  says(options, "--right needs --images");

  folder.image("range/d.png", CV_16UC1, 1);
  says(options_for(folder), "range: has 4 frames, and the images have 3 frames");
  std::filesystem::remove(folder.path() / "range/d.png");
  folder.image("range/b.png", CV_8UC1, 1);
  says(options_for(folder), "range/b.png: must be a 16-bit grey image");
  folder.text("range/b.png", "damaged");
  says(options_for(folder), "range/b.png: not a readable image");
  folder.text("intrinsics.txt", "36 36 2.5 1.5 7 4 0.5 10\n");
  says(options_for(folder), "cam/img8.png: is 6x4, the camera is 7x4");
  folder.text("intrinsics.txt", "36 36 2.5 1.5 6 4 0 10\n");
  options = options_for(folder);
  options.right = "cam";
  says(options, "intrinsics.txt: baseline must be > 0 for stereo");
}

TEST(NamedLayout, ACameraOfOpen3D) {
  const RecordingFolder folder;
  write(folder, {"color/00000.jpg", "color/00001.jpg"}, CV_8UC3, 100);
  write(folder, {"depth/00000.png", "depth/00001.png"}, CV_16UC1, 2000);
  const std::string before =
      R"({"color_mode": "MJPG_1080P", "depth_scale": 1000.0, "fps": 30.0, "height": 4, "intrinsic_matrix": )";
  folder.text("intrinsic.json", before + R"([36.0, 0.0, 0.0, 0.0, 37.0, 0.0, 2.5, 1.5, 1.0], "width": 6})");
  runner::SequenceOptions options = options_for(folder);
  options.images = "color";
  options.depth_dir = "depth";
  options.intrinsics = "intrinsic.json";
  runner::Sequence sequence(options);
  EXPECT_EQ(sequence.depth_source(), dot::DepthSource::Rgbd);
  EXPECT_EQ(sequence.intrinsics().fx, 36);
  EXPECT_EQ(sequence.intrinsics().fy, 37);
  EXPECT_EQ(sequence.intrinsics().cx, 2.5);
  EXPECT_EQ(sequence.intrinsics().cy, 1.5);
  EXPECT_DOUBLE_EQ(sequence.read(1).timestamp, 1 / 30.0);
  EXPECT_DOUBLE_EQ(metres(sequence.read(0)), 2);
  const auto says_of_scale = [&](const std::string& scale, const std::string& text) {
    folder.text("intrinsic.json",
                R"({"depth_scale": )" + scale +
                    R"(, "height": 4, "intrinsic_matrix": [36, 0, 0, 0, 37, 0, 2.5, 1.5, 1], "width": 6})");
    EXPECT_NE(complaint(options).find("intrinsic.json: depth_scale " + text), std::string::npos) << complaint(options);
  };
  says_of_scale("0", "needs a number from 1 to 1000000, not '0'");
  says_of_scale("-1000", "needs a number from 1 to 1000000, not '-1000'");
  says_of_scale("0.001", "is the number of units to the metre: of units of 0.001 m these are 1000");
  folder.text("intrinsic.json", before + "[36, 0, 0], \"width\": 6}");
  EXPECT_NE(complaint(options).find("intrinsic.json: has no 'intrinsic_matrix' of nine numbers"), std::string::npos);
  folder.text("intrinsic.json", "{}");
  EXPECT_NE(complaint(options).find("intrinsic.json: has no"), std::string::npos);
}

TEST(NamedLayout, ALensIsUndistorted) {
  const RecordingFolder folder;
  write_folders(folder);
  folder.text("intrinsics.txt", camera + "depth rgbd\ndistortion radtan 9 0 0 0\n");
  runner::Sequence sequence(options_for(folder));
  EXPECT_EQ(sequence.depth_source(), dot::DepthSource::Rgbd);
  // A strong pincushion: 0, 0 is at x = -2.5 / 36 (1 + 9 r2) = -.0695 (1 + .0595), .15 px farther out.
  const cv::Mat depth = sequence.read(0).depth;
  EXPECT_EQ(depth.at<std::uint16_t>(1, 2), 1000);
  folder.text("intrinsics.txt", camera + "distortion radtan 900 0 0 0\n");
  EXPECT_EQ(runner::Sequence(options_for(folder)).read(0).depth.at<std::uint16_t>(0, 0), 0);
  runner::SequenceOptions stereo = options_for(folder);
  stereo.right = "cam";
  EXPECT_NE(complaint(stereo).find("rectify them"), std::string::npos) << complaint(stereo);
  const auto says = [&](const std::string& line, const std::string& text) {
    folder.text("intrinsics.txt", camera + line);
    const std::string said = complaint(options_for(folder));
    EXPECT_NE(said.find("intrinsics.txt:2: " + text), std::string::npos) << said;
  };
  says("distortion\n", "must be 'distortion radtan");
  says("distortion omni 1 2 3 4\n", "must be 'distortion radtan");
  says("distortion radtan 1 2 3\n", "radtan has 3 coefficients, must have 4 or 5");
  says("distortion equidistant 1 2 3 4 5\n", "equidistant has 5 coefficients, must have 4");
  says("distortion radtan 1 2 x 4\n", "a coefficient 'x' is not a number");
}

/// A video in memory: each frame of one value.
class FakeVideo : public runner::VideoInput {
 public:
  FakeVideo(int type, double value, std::vector<double> times) : type_(type), value_(value), times_(std::move(times)) {}
  const std::vector<double>& times() const override { return times_; }
  cv::Mat read(int index) override { return cv::Mat(4, 6, type_, cv::Scalar::all(value_ * (index + 1))); }

 private:
  int type_;
  double value_;
  std::vector<double> times_;
};

TEST(NamedLayout, Videos) {
  const RecordingFolder folder;
  for (const char* const name : {"color.mkv", "depth.mkv", "colours.mkv", "short.mkv"}) folder.text(name, "");
  folder.text("intrinsics.txt", camera);
  folder.image("masks/000001.png", CV_8UC1, 5);
  runner::SequenceOptions options = options_for(folder);
  options.images = "color.mkv";
  options.depth_dir = "depth.mkv";
  options.open_video = [](const std::filesystem::path& path) -> std::unique_ptr<runner::VideoInput> {
    const std::string name = path.filename().string();
    if (name == "depth.mkv") return std::make_unique<FakeVideo>(CV_16UC1, 3000, std::vector<double>{0, 0.1, 0.25});
    if (name == "short.mkv") return std::make_unique<FakeVideo>(CV_16UC1, 3000, std::vector<double>{0, 0.1});
    return std::make_unique<FakeVideo>(CV_8UC3, 20, std::vector<double>{0, 0.1, 0.25});
  };
  runner::Sequence sequence(options);
  ASSERT_EQ(sequence.size(), 3);
  const runner::SequenceFrame last = sequence.read(2), middle = sequence.read(1);
  EXPECT_EQ(last.number, 2);
  EXPECT_DOUBLE_EQ(last.timestamp, 0.25) << "the video's own, not by a rate";
  EXPECT_EQ(last.image.at<cv::Vec3b>(0, 0), cv::Vec3b(60, 60, 60));
  EXPECT_DOUBLE_EQ(metres(last), 9);
  EXPECT_DOUBLE_EQ(metres(middle), 6);
  EXPECT_TRUE(last.ids.empty());
  EXPECT_EQ(middle.ids.at<std::uint8_t>(0, 0), 5);

  options.depth_dir = "short.mkv";
  EXPECT_NE(complaint(options).find("short.mkv: has 2 frames, and the images have 3 frames"), std::string::npos);
  options.depth_dir = "colours.mkv";
  EXPECT_NE(complaint(options).find("colours.mkv: does not come as 16-bit grey; make images of it: ffmpeg -i "
                                    "colours.mkv -pix_fmt gray16be depth/%06d.png"),
            std::string::npos)
      << complaint(options);
  options.depth_dir = "none.mkv";
  EXPECT_NE(complaint(options).find("none.mkv: no such file"), std::string::npos);
  options.depth_dir = "depth.mkv";
  options.right = "color.mkv";
  EXPECT_EQ(runner::Sequence(options).depth_source(), dot::DepthSource::Stereo);
}

}  // namespace
