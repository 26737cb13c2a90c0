// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/complaints.hpp"

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
  EXPECT_EQ(folder.complaint(), calib + ":2: has 3 numbers, must have 12");
  folder.text("calib.txt", "P2: 100 0 3 6 0 100 2 0 0 0 1 x\n");
  EXPECT_EQ(folder.complaint(), calib + ":1: P2 'x' is not a number");
  folder.text("calib.txt", with_prefix("P"));
  folder.text("times.txt", "0\n0.2\n0.1\n");
  EXPECT_EQ(folder.complaint(), times + ":3: times must increase, by a microsecond or more");
  folder.text("times.txt", "0\n0.2\n");
  EXPECT_EQ(folder.complaint(), times + ": has 2 lines for 3 frames");
}

TEST(KittiOdometry, CalibrationsThatAreNone) {
  const RecordingFolder folder;
  write_odometry(folder);
  const std::string right = "P3: 100 0 3 -44 0 100 2 0 0 0 1 0\n";
  const std::string shape = " must be 'fx 0 cx . 0 fy cy . 0 0 1 .', the projection of a rectified camera";
  expect_complaints(folder, "calib.txt",
                    {{"calib_huge", "P2: 1e-300 0 3 1e300 0 100 2 0 0 0 1 0\n" + right,
                      ":1: fx is 1e-300, must be from 1 to 1000000"},
                     {"calib_skew", "P2: 100 5 3 0 9 100 2 0 3 3 7 0\n" + right, ":1: P2" + shape},
                     {"singular", right + "P2: 100 0 3 6 0 100 2 0 0 0 0 0\n", ":2: P2" + shape},
                     {"calib_neg_baseline", "P2: 100 0 3 0 0 100 2 0 0 0 1 0\nP3: 100 0 3 50 0 100 2 0 0 0 1 0\n",
                      ":2: the baseline from P2 to P3 is -0.5, must be from 0 to 10"},
                     {"far apart", "P2: 100 0 3 1e300 0 100 2 0 0 0 1 0\n" + right,
                      ":1: x is 1e+298, must be from -1000000000 to 1000000000"},
                     {"not a pair", right + "P2: 100 0 4 6 0 100 2 0 0 0 1 0\n",
                      ":1: P3 has other focal lengths or another centre than P2, as no rectified pair has"}});
}

TEST(KittiOdometry, PosesThatAreNotRigid) {
  const RecordingFolder folder("sequences/07");
  write_odometry(folder);
  const std::string still = "1 0 0 0 0 1 0 0 0 0 1 0\n";
  folder.text("../../poses/07.txt", still + still + still);
  expect_complaints(folder, "../../poses/07.txt",
                    {{"a zero on the diagonal", still + "1 0 0 0 0 0 0 0 0 0 1 0\n" + still,
                      ":2: the pose's 3x3 part is not a rotation"}});
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
  EXPECT_EQ(folder.complaint(),
            (folder.path() / "image_02/timestamps.txt").string() + ":2: must be like '2011-09-26 13:02:25.964389445'");
  write_raw(folder);
  folder.text("oxts/data/0000000001.txt", "49.0 8.4 116 0 0\n");
  folder.text("../calib_imu_to_velo.txt", "R: 1 0 0 0 1 0 0 0 1\nT: 0 0 0\n");
  folder.text("../calib_velo_to_cam.txt", "R: 1 0 0 0 1 0 0 0 1\nT: 0 0 0\n");
  EXPECT_EQ(folder.complaint(),
            (folder.path() / "oxts/data/0000000001.txt").string() + ":1: must begin with six numbers");
}

TEST(KittiRaw, TimesThatAreNone) {
  const RecordingFolder folder("day/drive");
  write_raw(folder);
  const std::string form = ": must be like '2011-09-26 13:02:25.964389445'";
  expect_complaints(
      folder, "image_02/timestamps.txt",
      {{"raw_time_neg", "a -1:00:00\na 0:0:99999\nb 1:1:1\n", ":1" + form},
       {"negative hour", "2011-09-26 -1:00:00\n2011-09-26 00:00:01\n",
        ":1: the hour is -1, must be a whole number from 0 to 23"},
       {"many seconds", "2011-09-26 00:00:00\n\n2011-09-26 00:00:99999\n",
        ":3: the second is 99999, must be from 0 to 60"},
       {"half a minute", "2011-09-26 00:0.5:00\n", ":1: the minute is 0.5, must be a whole number from 0 to 59"},
       {"back a day", "2011-09-26 00:00:00\n2011-09-25 00:00:00\n", ":2: the date goes back"}});
}

TEST(KittiRaw, TimesMayGoBackWhereTheyAreLookedAt) {
  const RecordingFolder folder("day/drive");
  write_raw(folder);
  folder.text("image_02/timestamps.txt", "2011-09-26 00:00:01\n2011-09-25 23:59:59\n");
  runner::SequenceOptions options = folder.options();
  options.check_times = false;
  const runner::Recording recording = runner::open_recording(options);
  EXPECT_NEAR(recording.entries[1].timestamp - recording.entries[0].timestamp, -2, 1e-9);
}

void write_navigation(const RecordingFolder& folder) {
  folder.text("../calib_imu_to_velo.txt", "R: 1 0 0 0 1 0 0 0 1\nT: 0 0 0\n");
  folder.text("../calib_velo_to_cam.txt", "R: 0 -1 0 0 0 -1 1 0 0\nT: 0 0 -1\n");
  folder.text("oxts/data/0000000001.txt", "49.0 8.4 116 0 0 0\n");
  folder.text("oxts/data/0000000002.txt", "49.0 8.4 116 0 0 0\n");
}

TEST(KittiRaw, NavigationOutOfRange) {
  const RecordingFolder folder("day/drive");
  write_raw(folder);
  write_navigation(folder);
  const std::string latitude = ", must be from -85 to 85";
  expect_complaints(
      folder, "oxts/data/0000000001.txt",
      {{"oxts_pole", "90 8.4 112 0 0 0\n", ":1: latitude is 90" + latitude},
       {"oxts_lat", "1000 8.4 112 0 0 0\n", ":1: latitude is 1000" + latitude},
       {"oxts_huge", "49 8.4 1e308 1e300 0 0\n", ":1: altitude is 1e+308, must be from -100000 to 100000"},
       {"roll", "49 8.4 116 1e300 0 0\n", ":1: roll is 1e+300, must be from -7 to 7"},
       {"junk", "49 8.4x 116 0 0 0\n", ":1: longitude '8.4x' is not a number"}});
}

TEST(KittiRaw, MountingsThatAreNotRigid) {
  const RecordingFolder folder("day/drive");
  write_raw(folder);
  write_navigation(folder);
  expect_complaints(folder, "../calib_imu_to_velo.txt",
                    {{"imu_zero", "calib_time: 0\nR: 0 0 0 0 0 0 0 0 0\nT: 0 0 0\n", ":2: R is not a rotation"},
                     {"mirrored", "T: 0 0 0\nR: 1 0 0 0 1 0 0 0 -1\n", ":2: R is a mirror image, not a rotation"},
                     {"far away", "R: 1 0 0 0 1 0 0 0 1\nT: 0 0 1e300\n",
                      ":2: z is 1e+300, must be from -1000000000 to 1000000000"}});
  write_navigation(folder);
  expect_complaints(folder, "../calib_cam_to_cam.txt",
                    {{"rectified by nothing", "R_rect_00: 1 1 0 0 1 0 0 0 1\n" + with_prefix("P_rect_0"),
                      ":1: R_rect_00 is not a rotation"}});
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
