// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "sequence/sequence.hpp"
#include "support/complaints.hpp"

namespace {

void write_room(const RecordingFolder& folder) {
  folder.text("rgb.txt",
              "# color images\n# timestamp filename\n10.00 rgb/10.00.png\n10.03 rgb/10.03.png\n10.06 rgb/10.06.png\n");
  folder.text("depth.txt", "# depth maps\n10.005 depth/10.005.png\n10.055 depth/10.055.png\n10.07 depth/10.07.png\n");
  for (const char* const name : {"rgb/10.00.png", "rgb/10.03.png", "rgb/10.06.png"}) folder.image(name, CV_8UC3);
  for (const char* const name : {"depth/10.005.png", "depth/10.055.png"}) folder.image(name, CV_16UC1, 10000);
}

TEST(TumRgbd, PairsByTime) {
  const RecordingFolder folder("rgbd_dataset_freiburg3_walking_xyz");
  write_room(folder);
  const runner::Recording recording = folder.open();
  EXPECT_EQ(recording.layout, "TUM RGB-D");
  EXPECT_EQ(recording.depth_source, dot::DepthSource::Rgbd);
  ASSERT_EQ(recording.entries.size(), 2u) << "the second image has no depth within 20 ms";
  EXPECT_EQ(recording.entries[0].depth, folder.path() / "depth/10.005.png");
  EXPECT_EQ(recording.entries[1].number, 2);
  EXPECT_DOUBLE_EQ(recording.entries[1].timestamp, 10.06);
  EXPECT_EQ(recording.entries[1].depth, folder.path() / "depth/10.055.png");
  runner::Sequence sequence(folder.options());
  const runner::SequenceFrame frame = sequence.read(0);
  EXPECT_EQ(frame.depth.at<std::uint16_t>(0, 0) / frame.depth_units_per_metre, 2);
}

TEST(TumRgbd, CameraByTheFoldersName) {
  const std::pair<const char*, double> cameras[] = {{"rgbd_dataset_freiburg1_xyz", 517.3},
                                                    {"rgbd_dataset_freiburg2_desk", 520.9},
                                                    {"rgbd_dataset_freiburg3_sitting", 535.4},
                                                    {"rgbd_bonn_crowd", 542.822841},
                                                    {"office", 525}};
  for (const auto& [name, fx] : cameras) {
    const RecordingFolder folder(name);
    write_room(folder);
    EXPECT_EQ(folder.open().intrinsics.fx, fx) << name;
  }
}

TEST(TumRgbd, MasksByTimeOrByNumber) {
  const RecordingFolder folder;
  write_room(folder);
  folder.image("masks/10.00.png", CV_8UC1, 1);
  folder.image("masks/000002.png", CV_8UC1, 1);
  const runner::Recording recording = folder.open();
  EXPECT_EQ(recording.entries[0].masks, folder.path() / "masks/10.00.png");
  EXPECT_EQ(recording.entries[1].masks, folder.path() / "masks/000002.png");
}

TEST(TumRgbd, TruePosesAreInterpolated) {
  const RecordingFolder folder;
  write_room(folder);
  // A quarter of a turn about y (quaternions are x y z w), while x goes from 1 to 2.
  folder.text("groundtruth.txt",
              "# timestamp tx ty tz qx qy qz qw\n9.99 1 2 3 0 0 0 1\n10.01 2 2 3 0 0.70710678 0 0.70710678\n"
              "10.5 0 0 0 0 0 0 1\n");
  const runner::Recording recording = folder.open();
  ASSERT_TRUE(recording.entries[0].truth.camera.has_value());
  const Eigen::Matrix4d& T = *recording.entries[0].truth.camera;
  const Eigen::Matrix3d eighth = Eigen::AngleAxisd(3.14159265358979323846 / 4, Eigen::Vector3d::UnitY()).matrix();
  EXPECT_TRUE((T.topLeftCorner<3, 3>().isApprox(eighth, 1e-6))) << T;
  EXPECT_NEAR(T(1, 3), 2, 1e-9);
  EXPECT_NEAR(T(0, 3), 1.5, 0.01);
  EXPECT_FALSE(recording.entries[1].truth.camera.has_value()) << "in a gap of the truth";
  folder.text("groundtruth.txt", "9.5 1 2 3 0 0 0 1\n10.06 2 2 3 0 0 0 1\n");
  EXPECT_EQ((*folder.open().entries[1].truth.camera)(0, 3), 2) << "at the very time of the last line";
}

TEST(TumRgbd, ErrorsNameFileAndLine) {
  const RecordingFolder folder;
  write_room(folder);
  const std::string rgb = (folder.path() / "rgb.txt").string();
  folder.text("rgb.txt", "# color images\n10.00\n");
  EXPECT_EQ(folder.complaint(), rgb + ":2: must be a time and 1 name");
  folder.text("rgb.txt", "10.00 rgb/10.00.png\n9.00 rgb/10.03.png\n");
  EXPECT_EQ(folder.complaint(), rgb + ":2: times must increase, by a microsecond or more");
  folder.text("rgb.txt", "20.00 rgb/10.00.png\n");
  EXPECT_EQ(folder.complaint(), rgb + ": no image has a depth image of its time");
  write_room(folder);
  folder.text("groundtruth.txt", "9.99 1 2 3 0 0 0\n");
  EXPECT_EQ(folder.complaint(), (folder.path() / "groundtruth.txt").string() + ":1: must be a time and 7 numbers");
}

TEST(TumRgbd, TimesMayBeAnythingWhereTheyAreLookedAt) {
  const RecordingFolder folder;
  write_room(folder);
  folder.text("rgb.txt", "10.06 rgb/10.06.png\n10.00 rgb/10.00.png\n");
  folder.text("depth.txt", "10.055 depth/10.055.png\n10.005 depth/10.005.png\n1e12 depth/10.07.png\n");
  runner::SequenceOptions options = folder.options();
  options.check_times = false;
  const runner::Recording recording = runner::open_recording(options);
  ASSERT_EQ(recording.entries.size(), 2u);
  EXPECT_DOUBLE_EQ(recording.entries[0].timestamp, 10.06);
  EXPECT_EQ(recording.entries[0].depth, folder.path() / "depth/10.055.png");
  EXPECT_DOUBLE_EQ(recording.entries[1].timestamp, 10);
  EXPECT_EQ(recording.entries[1].depth, folder.path() / "depth/10.005.png");
}

/// Whatever stands there would be opened, /dev/zero without an end.
TEST(TumRgbd, NamesThatLeadOutOfTheFolder) {
  using std::string_literals::operator""s;
  for (const std::string list : {"rgb.txt", "depth.txt"}) {
    const RecordingFolder folder;
    write_room(folder);
    const std::string none = " is not the name of a file in this folder";
    expect_complaints(folder, list,
                      {{"from the root", "10.00 /dev/zero\n", ":1: '/dev/zero'" + none},
                       {"from above", "# t\n10.00 rgb/../../10.00.png\n", ":2: 'rgb/../../10.00.png'" + none},
                       {"cut by a NUL", "10.00 rgb/10.00.png\0x\n"s, ":1: 'rgb/10.00.png?x'" + none}});
  }
}

TEST(TumRgbd, TruePosesThatAreNone) {
  const RecordingFolder folder;
  write_room(folder);
  folder.text("groundtruth.txt", "10.00 1 2 3 0 0 0 1\n10.06 1 2 3 0 0 0 1\n");
  const std::string length = ", must be from 0.99 to 1.01";
  expect_complaints(
      folder, "groundtruth.txt",
      {{"three digits", "10.00 1 2 3 0.577 0.577 0.577 0.0\n", ""},
       {"tum_zero_quat", "10.00 0 0 0 0 0 0 0\n", ":1: the quaternion's length is 0" + length},
       {"tum_huge_quat", "# t\n10.00 0 0 0 1e150 0 0 0\n", ":2: the quaternion's length is 1e+150" + length},
       {"tum_huge_quat: position", "10.00 1e300 0 0 1e300 0 0 1e300\n",
        ":1: x is 1e+300, must be from -1000000000 to 1000000000"},
       {"a line that no image needs", "9.00 1 2 3 0 0 0 1\n10.00 1 2 3 0 0 0 1\n20.00 0 0 0 0 0 0 0\n",
        ":3: the quaternion's length is 0" + length},
       {"junk", "10.00 1 2 3 0 0 0 1x\n", ":1: qw '1x' is not a number"}});
}

}  // namespace
