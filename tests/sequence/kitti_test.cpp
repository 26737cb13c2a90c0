// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/recording_folder.hpp"

namespace {

/// A rig of f = 100, baseline 0.5 m, its left colour camera 0.06 m left of camera 0.
const char* const projections =
    "0: 100 0 3 0 0 100 2 0 0 0 1 0\n"
    "1: 100 0 3 -50 0 100 2 0 0 0 1 0\n"
    "2: 100 0 3 6 0 100 2 0 0 0 1 0\n"
    "3: 100 0 3 -44 0 100 2 0 0 0 1 0\n";

std::string with_prefix(const std::string& prefix) {
  std::string text = projections;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) text.insert(at, prefix);
  return text;
}

void write_odometry(const RecordingFolder& folder) {
  for (const char* const name : {"000000.png", "000001.png", "000002.png"}) {
    folder.image(std::string("image_2/") + name, CV_8UC3);
    folder.image(std::string("image_3/") + name, CV_8UC3);
  }
  folder.text("calib.txt", with_prefix("P") + "Tr: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  folder.text("times.txt", "0.000000e+00\n1.037359e-01\n2.075e-01\n");
}

TEST(KittiOdometry, CameraTimesAndFiles) {
  const RecordingFolder folder("07");
  write_odometry(folder);
  folder.image("masks/000001.png", CV_8UC1, 3);
  folder.text("masks/000001.csv", "3,car,0.9\n");
  const runner::Recording recording = folder.open();
  EXPECT_EQ(recording.layout, "KITTI odometry");
  EXPECT_EQ(recording.intrinsics.fx, 100);
  EXPECT_EQ(recording.intrinsics.cx, 3);
  EXPECT_EQ(recording.intrinsics.cy, 2);
  EXPECT_EQ(recording.intrinsics.width, 6);
  EXPECT_EQ(recording.intrinsics.height, 4);
  EXPECT_DOUBLE_EQ(recording.intrinsics.baseline, 0.5);
  EXPECT_EQ(recording.depth_source, dot::DepthSource::Stereo);
  ASSERT_EQ(recording.entries.size(), 3u);
  EXPECT_EQ(recording.entries[1].number, 1);
  EXPECT_DOUBLE_EQ(recording.entries[1].timestamp, 0.1037359);
  EXPECT_EQ(recording.entries[1].image, folder.path() / "image_2/000001.png");
  EXPECT_EQ(recording.entries[1].right, folder.path() / "image_3/000001.png");
  EXPECT_TRUE(recording.entries[1].depth.empty());
  EXPECT_EQ(recording.entries[1].masks, folder.path() / "masks/000001.png");
  EXPECT_EQ(recording.entries[1].instances, folder.path() / "masks/000001.csv");
  EXPECT_TRUE(recording.entries[0].masks.empty());
  EXPECT_FALSE(recording.entries[0].truth.camera.has_value());
}

TEST(KittiOdometry, DepthImagesWhereThereAreSome) {
  const RecordingFolder folder;
  write_odometry(folder);
  folder.image("depth/000000.png", CV_16UC1, 256);
  const runner::Recording recording = folder.open();
  EXPECT_EQ(recording.entries[0].depth, folder.path() / "depth/000000.png");
  EXPECT_TRUE(recording.entries[0].right.empty());
  EXPECT_EQ(recording.depth_units_per_metre, 256);
}

TEST(KittiOdometry, PosesOfTheBenchmarkAreThoseOfCameraZero) {
  const RecordingFolder folder("sequences/07");
  write_odometry(folder);
  // Camera 0 looks along the world's x axis in the second frame and along its z axis in the others.
  folder.text("../../poses/07.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n0 0 1 5 0 1 0 0 -1 0 0 1\n1 0 0 0 0 1 0 0 0 0 1 2\n");
  const runner::Recording recording = folder.open();
  ASSERT_TRUE(recording.entries[1].truth.camera.has_value());
  const Eigen::Vector3d first = recording.entries[0].truth.camera->topRightCorner<3, 1>();
  const Eigen::Vector3d second = recording.entries[1].truth.camera->topRightCorner<3, 1>();
  EXPECT_TRUE(first.isApprox(Eigen::Vector3d(-0.06, 0, 0))) << first.transpose();
  EXPECT_TRUE(second.isApprox(Eigen::Vector3d(5, 0, 1.06))) << second.transpose();
  runner::SequenceOptions blind = folder.options();
  blind.truth = false;
  EXPECT_FALSE(runner::open_recording(blind).entries[1].truth.camera.has_value());
}

TEST(KittiOdometry, GreyPairWhereThereIsNoColour) {
  const RecordingFolder folder;
  folder.image("image_0/000004.png");
  folder.image("image_1/000004.png");
  folder.text("calib.txt", with_prefix("P"));
  folder.text("times.txt", "0\n0.1\n0.2\n0.3\n0.4\n");
  const runner::Recording recording = folder.open();
  EXPECT_DOUBLE_EQ(recording.intrinsics.baseline, 0.5);
  EXPECT_EQ(recording.entries[0].timestamp, 0.4) << "a part of a longer recording takes the line of its number";
}

TEST(KittiOdometry, ErrorsNameFileAndLine) {
  const RecordingFolder folder;
  write_odometry(folder);
  const std::string calib = (folder.path() / "calib.txt").string(), times = (folder.path() / "times.txt").string();
  folder.text("calib.txt", "P2: 100 0 3 6 0 100 2 0 0 0 1 0\n");
  EXPECT_EQ(folder.complaint(), calib + ": has no line 'P3:'");
  folder.text("calib.txt", "P2: 100 0 3 6 0 100 2 0 0 0 1 0\nP3: 100 0 3\n");
  EXPECT_EQ(folder.complaint(), calib + ": line 2 has 3 numbers, must have 12");
  folder.text("calib.txt", "P2: 100 0 3 6 0 100 2 0 0 0 1 x\n");
  EXPECT_EQ(folder.complaint(), calib + ": line 1: 'x' is not a number");
  folder.text("calib.txt", with_prefix("P"));
  folder.text("times.txt", "0\n0.2\n0.1\n");
  EXPECT_EQ(folder.complaint(), times + ": line 3: times must increase");
  folder.text("times.txt", "0\n0.2\n");
  EXPECT_EQ(folder.complaint(), times + ": has 2 lines for 3 frames");
}

void write_raw(const RecordingFolder& folder) {
  for (const char* const name : {"0000000001.png", "0000000002.png"}) {
    folder.image(std::string("image_02/data/") + name, CV_8UC3);
    folder.image(std::string("image_03/data/") + name, CV_8UC3);
  }
  folder.text("../calib_cam_to_cam.txt",
              "calib_time: 09-Jan-2012 13:57:47\nR_rect_00: 1 0 0 0 1 0 0 0 1\n" + with_prefix("P_rect_0"));
  folder.text("image_02/timestamps.txt",
              "2011-09-26 23:59:59.850000000\n2011-09-26 23:59:59.964389445\n2011-09-27 00:00:00.064389445\n");
}

TEST(KittiRaw, CameraTimesAndFiles) {
  const RecordingFolder folder("2011_09_26/2011_09_26_drive_0001_sync");
  write_raw(folder);
  folder.image("masks/0000000002.png", CV_8UC1, 1);
  const runner::Recording recording = folder.open();
  EXPECT_EQ(recording.layout, "KITTI raw");
  EXPECT_EQ(recording.intrinsics.fx, 100);
  EXPECT_DOUBLE_EQ(recording.intrinsics.baseline, 0.5);
  ASSERT_EQ(recording.entries.size(), 2u);
  EXPECT_EQ(recording.entries[0].number, 1);
  EXPECT_NEAR(recording.entries[1].timestamp - recording.entries[0].timestamp, 0.1, 1e-9) << "over midnight";
  EXPECT_EQ(recording.entries[1].right, folder.path() / "image_03/data/0000000002.png");
  EXPECT_EQ(recording.entries[1].masks, folder.path() / "masks/0000000002.png");
  EXPECT_TRUE(recording.entries[0].masks.empty());
  EXPECT_FALSE(recording.entries[0].truth.camera.has_value());
}

TEST(KittiRaw, ErrorsNameFileAndLine) {
  const RecordingFolder folder("day/drive");
  write_raw(folder);
  folder.text("image_02/timestamps.txt", "2011-09-26 13:02:25.96\n2011-09-26 13:02\n");
  EXPECT_EQ(folder.complaint(), (folder.path() / "image_02/timestamps.txt").string() +
                                    ": line 2: must be like '2011-09-26 13:02:25.964389445'");
  write_raw(folder);
  folder.text("oxts/data/0000000001.txt", "49.0 8.4 116 0 0\n");
  folder.text("../calib_imu_to_velo.txt", "R: 1 0 0 0 1 0 0 0 1\nT: 0 0 0\n");
  folder.text("../calib_velo_to_cam.txt", "R: 1 0 0 0 1 0 0 0 1\nT: 0 0 0\n");
  EXPECT_EQ(folder.complaint(),
            (folder.path() / "oxts/data/0000000001.txt").string() + ": line 1 must begin with six numbers");
}

/// A car that drives east, then turns left by 90 degrees on the spot; the camera is 1 m ahead of the navigation unit
/// and looks forward.
TEST(KittiRaw, NavigationGivesTheCamerasPoses) {
  const RecordingFolder folder("day/drive");
  write_raw(folder);
  folder.text("../calib_imu_to_velo.txt", "calib_time: x\nR: 1 0 0 0 1 0 0 0 1\nT: 0 0 0\n");
  // x forward, y left, z up to x right, y down, z forward.
  folder.text("../calib_velo_to_cam.txt", "calib_time: x\nR: 0 -1 0 0 0 -1 1 0 0\nT: 0 0 -1\n");
  const double latitude = 60, degree = 111319.49079327357;  // metres of longitude at the equator
  const auto packet = [&](double east, double yaw) {
    return std::to_string(latitude) + " " + std::to_string(east / (degree * 0.5)) + " 100 0 0 " + std::to_string(yaw) +
           " 0 0 0\n";
  };
  folder.text("oxts/data/0000000001.txt", packet(0, 0));
  folder.text("oxts/data/0000000002.txt", packet(557, 1.5707963));
  const runner::Recording recording = folder.open();
  ASSERT_TRUE(recording.entries[1].truth.camera.has_value());
  const Eigen::Matrix4d T_first_second =
      recording.entries[0].truth.camera->inverse() * *recording.entries[1].truth.camera;
  // The unit moved 557 m ahead; the camera's lever arm and its offset of 0.06 m turned with it. Positions are written
  // to 1e-6 degrees, six centimetres.
  const Eigen::Vector3d t = T_first_second.topRightCorner<3, 1>();
  EXPECT_NEAR(t.x(), -1 + 0.06, 1e-4);
  EXPECT_NEAR(t.y(), 0, 1e-4);
  EXPECT_NEAR(t.z(), 557 - 1 - 0.06, 0.06);
  const Eigen::Vector3d ahead = T_first_second.block<3, 1>(0, 2);
  EXPECT_TRUE(ahead.isApprox(Eigen::Vector3d(-1, 0, 0), 1e-5)) << ahead.transpose();
}

}  // namespace
