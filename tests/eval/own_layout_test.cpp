// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence/own_layout.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <string>

#include "sequence/errors.hpp"
#include "sequence/images.hpp"
#include "sequence/sequence.hpp"

namespace runner {
namespace {

namespace fs = std::filesystem;

/// A sequence of two frames, 8x6, that a test may change before it reads it.
class OwnLayout : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    options.folder = fs::path(::testing::TempDir()) / ("own_layout_" + std::string(test->name()));
    fs::remove_all(options.folder);
    for (const char* folder : {"rgb", "depth", "depth_true", "masks", "instance"})
      fs::create_directories(options.folder / folder);
    for (const char* name : {"000000.png", "000001.png"}) {
      write_image(options.folder / "rgb" / name, cv::Mat(6, 8, CV_8UC1, cv::Scalar(90)));
      write_image(options.folder / "depth" / name, cv::Mat(6, 8, CV_16UC1, cv::Scalar(512)));
      write_image(options.folder / "depth_true" / name, cv::Mat(6, 8, CV_16UC1, cv::Scalar(640)));
      write_image(options.folder / "masks" / name, cv::Mat(6, 8, CV_8UC1, cv::Scalar(3)));
      write_image(options.folder / "instance" / name, cv::Mat(6, 8, CV_16UC1, cv::Scalar(300)));
    }
    write("intrinsics.txt", "10 10 3.5 2.5 8 6 0.5 10\n");
    write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 2\n");
    write("objects.csv", "frame,id,class,moving,speed_mps\n0,300,car,1,2.5\n1,300,car,0,0\n");
    write("object_poses.txt", "1 300 1 0 0 4 0 1 0 5 0 0 1 6\n");
    options.truth = true;
  }

  void TearDown() override { fs::remove_all(options.folder); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(options.folder / name) << text; }

  /// The message of the error that reading gives.
  std::string error() const {
    try {
      Sequence sequence(options);
      for (int i = 0; i < sequence.size(); ++i) {
        sequence.read(i);
        sequence.truth(i);
      }
    } catch (const FileError& error) {
      return error.what();
    }
    return "none";
  }

  SequenceOptions options;
};

TEST_F(OwnLayout, FramesAndTruth) {
  Sequence sequence(options);
  ASSERT_EQ(sequence.size(), 2);
  const SequenceFrame frame = sequence.read(1);
  EXPECT_EQ(frame.number, 1);
  EXPECT_DOUBLE_EQ(frame.timestamp, 0.1);
  EXPECT_EQ(frame.depth.at<std::uint16_t>(0, 0), 512);
  EXPECT_EQ(frame.ids.at<std::uint8_t>(0, 0), 3);
  EXPECT_EQ(sequence.depth_source(), dot::DepthSource::Stereo);

  const FrameTruth truth = sequence.truth(1);
  EXPECT_EQ(truth.instance.at<int>(5, 7), 300);
  EXPECT_FLOAT_EQ(truth.depth.at<float>(0, 0), 2.5F);
  EXPECT_FLOAT_EQ(truth.measured.at<float>(0, 0), 2.0F);
  const TruthEntry& before = sequence.recording().entries[0].truth;
  const TruthEntry& entry = sequence.recording().entries[1].truth;
  EXPECT_TRUE(before.objects.at(300).moving);
  EXPECT_DOUBLE_EQ(before.objects.at(300).speed, 2.5);
  EXPECT_FALSE(entry.objects.at(300).moving);
  ASSERT_TRUE(entry.camera);
  EXPECT_DOUBLE_EQ((*entry.camera)(2, 3), 2);
  EXPECT_DOUBLE_EQ(entry.poses.at(300)(1, 3), 5);
  EXPECT_TRUE(before.poses.empty());
}

TEST_F(OwnLayout, TruthIsReadOnDemandOnly) {
  options.truth = false;
  write("objects.csv", "nonsense\n");
  EXPECT_EQ(error(), "none");
  EXPECT_FALSE(Sequence(options).recording().entries[0].truth.camera);
}

TEST_F(OwnLayout, MaskRate) {
  options.mask_every = 2;
  Sequence sequence(options);
  EXPECT_FALSE(sequence.read(0).ids.empty());
  EXPECT_TRUE(sequence.read(1).ids.empty());
}

TEST_F(OwnLayout, ErrorsNameTheFileAndLine) {
  write("objects.csv", "frame,id,class,moving\n0,300,car,1\n");
  EXPECT_NE(error().find("objects.csv:1: has no column 'speed_mps'"), std::string::npos) << error();
  write("objects.csv", "frame,id,class,moving,speed_mps\n0,300,car,1,fast\n");
  EXPECT_NE(error().find("objects.csv:2: speed_mps 'fast' is not a number"), std::string::npos) << error();
  fs::remove(options.folder / "objects.csv");
  EXPECT_NE(error().find("objects.csv: cannot be read"), std::string::npos) << error();
}

TEST_F(OwnLayout, ErrorsOfPoses) {
  write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_NE(error().find("poses.txt: has 1 lines for 2 frames"), std::string::npos) << error();
  write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0\n");
  EXPECT_NE(error().find("poses.txt:2: "), std::string::npos) << error();
}

TEST_F(OwnLayout, TruthOfAnotherSizeIsAnError) {
  write_image(options.folder / "instance" / "000001.png", cv::Mat(6, 9, CV_16UC1, cv::Scalar(0)));
  EXPECT_NE(error().find("instance/000001.png: is 9x6, the camera is 8x6"), std::string::npos) << error();
}

}  // namespace
}  // namespace runner
