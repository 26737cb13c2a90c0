// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "sequence/instance_list.hpp"
#include "sequence/sequence.hpp"
#include "support/complaints.hpp"

namespace {

using std::string_literals::operator""s;

const std::string still = "1 0 0 0 0 1 0 0 0 0 1 0\n";

/// Two frames of 6x4 with truth.
void write_frames(const RecordingFolder& folder) {
  for (const char* const name : {"000000.png", "000001.png"}) {
    folder.image("rgb/"s + name);
    folder.image("depth/"s + name, CV_16UC1, 512);
    folder.image("instance/"s + name, CV_8UC1, 1);
  }
  folder.text("intrinsics.txt", "36 36 2.5 1.5 6 4 0.5 10\n");
  folder.text("poses.txt", still + still);
  folder.text("objects.csv", "frame,id,class,moving,speed_mps\n0,1,car,1,2.5\n1,1,car,0,-1\n");
  folder.text("object_poses.txt", "0 1 " + still);
}

TEST(OwnLayout, ImplausibleIntrinsics) {
  const RecordingFolder folder;
  write_frames(folder);
  expect_complaints(
      folder, "intrinsics.txt",
      {{"fx_tiny", "1e-300 36 2.5 1.5 6 4 0.5 10", ":1: fx is 1e-300, must be from 1 to 1000000"},
       {"fy negative", "36 -36 2.5 1.5 6 4 0.5 10", ":1: fy is -36, must be from 1 to 1000000"},
       {"cx_huge", "36 36 1e300 1.5 6 4 0.5 10", ":1: cx is 1e+300, must be from -100000 to 100000"},
       {"size_neg_int", "36 36 2.5 1.5 -2e10 4 0.5 10", ":1: width is -2e+10, must be a whole number from 1 to 65535"},
       {"width too large", "36 36 2.5 1.5 65536 4 0.5 10",
        ":1: width is 65536, must be a whole number from 1 to 65535"},
       {"half a pixel", "36 36 2.5 1.5 6 3.5 0.5 10", ":1: height is 3.5, must be a whole number from 1 to 65535"},
       {"negative baseline", "36 36 2.5 1.5 6 4 -0.5 10", ":1: baseline is -0.5, must be from 0 to 10"},
       {"fps_huge", "36 36 2.5 1.5 6 4 0.5 1e300", ":1: fps is 1e+300, must be from 0.001 to 100000"},
       {"fps_tiny", "36 36 2.5 1.5 6 4 0.5 1e-300", ":1: fps is 1e-300, must be from 0.001 to 100000"},
       {"nul_number", "36\0junk 36 2.5 1.5 6 4 0.5 10"s, ":1: fx '36?junk' is not a number"},
       {"nul_only", "36 36 \0 \0 6 4 0.5 10"s, ":1: cx '?' is not a number"},
       {"cut", "36 36 2.5 1.5 6 4 0.5", ":1: fps is missing"},
       {"too many", "36 36 2.5 1.5 6 4 0.5 10 2", ":1: has more than eight numbers"},
       {"depth twice", "36 36 2.5 1.5 6 4 0.5 10\ndepth lidar\ndepth rgbd",
        ":3: nothing may follow the line of the depth but that of the distortion"}});
}

// As editors on Windows write it, and as its shell does.
TEST(OwnLayout, TextWithAByteOrderMark) {
  const RecordingFolder folder;
  write_frames(folder);
  expect_complaints(folder, "intrinsics.txt",
                    {{"UTF-8",
                      "\xEF\xBB\xBF"
                      "36 36 2.5 1.5 6 4 0.5 10\r\n",
                      ""},
                     {"UTF-16",
                      "\xFF\xFE"
                      "3\0006\0 \000"s,
                      ": is UTF-16, must be ASCII or UTF-8"},
                     {"UTF-16, big endian", "\xFE\xFF\0003\0006\0 "s, ": is UTF-16, must be ASCII or UTF-8"}});
}

/// A tracker would take memory for images of the size that is claimed.
TEST(OwnLayout, ImagesHaveTheSizeOfTheCamera) {
  const RecordingFolder folder;
  write_frames(folder);
  folder.text("intrinsics.txt", "36 36 2.5 1.5 65535 65535 0.5 10");
  EXPECT_EQ(folder.complaint(), (folder.path() / "rgb/000000.png").string() + ": is 6x4, the camera is 65535x65535");
}

TEST(OwnLayout, TimesThatAreNone) {
  const RecordingFolder folder;
  write_frames(folder);
  folder.text("times.txt", "0\n0.1\n");
  expect_complaints(folder, "times.txt",
                    {{"of the epoch", "1305031710.1\n1305031710.2\n", ""},
                     {"nanoseconds", "1403636579763555584\n1403636579813555456\n",
                      ":1: the time is 1.40363658e+18, must be from -1e+11 to 1e+11"},
                     {"too short a step", "0\n\n1e-300\n", ":3: times must increase, by a microsecond or more"},
                     {"not finite", "0\nnan\n", ":2: 'nan' is not a number"}});
}

TEST(OwnLayout, PosesThatAreNotRigid) {
  const RecordingFolder folder;
  write_frames(folder);
  const std::string none = ": the pose's 3x3 part is not a rotation";
  expect_complaints(
      folder, "poses.txt",
      {{"rounded", still + "0.866 -0.5 0 0 0.5 0.866 0 0 0 0 1 0\n", ""},
       {"of a longer recording", still + still + still + still, ""},
       {"poses_zero", "0 0 0 0 0 0 0 0 0 0 0 0\n" + still, ":1" + none},
       {"poses_cut_number", still + "1 0 0 0 0 0 0 0 0 0 1 0", ":2" + none},
       {"scaled", still + "1.01 0 0 0 0 1.01 0 0 0 0 1.01 0", ":2" + none},
       {"huge", still + "1e200 0 0 0 0 1 0 0 0 0 1 0", ":2" + none},
       {"mirrored", still + "1 0 0 0 0 1 0 0 0 0 -1 0", ":2: the pose's 3x3 part is a mirror image, not a rotation"},
       {"far away", still + "1 0 0 0 0 1 0 -1e308 0 0 1 0",
        ":2: y is -1e+308, must be from -1000000000 to 1000000000"}});
}

TEST(OwnLayout, ObjectsOutOfRange) {
  const RecordingFolder folder;
  write_frames(folder);
  const std::string header = "frame,id,moving,speed_mps\n";
  expect_complaints(
      folder, "objects.csv",
      {{"a frame that is not played", header + "7,1,0,0\n", ""},
       {"objects_frac: frame", header + "0.7,1,0,-3\n", ":2: frame is 0.7, must be a whole number from 0 to 999999999"},
       {"objects_frac: id", header + "0,1.5,0,-3\n", ":2: id is 1.5, must be a whole number from 1 to 65535"},
       {"objects_frac: moving", header + "0,1,0.5,-3\n", ":2: moving is 0.5, must be a whole number from 0 to 1"},
       {"objects_frame_1e300", header + "1e300,1,0,0\n",
        ":2: frame is 1e+300, must be a whole number from 0 to 999999999"},
       {"objects_id_1e300", header + "0,1e300,0,0\n", ":2: id is 1e+300, must be a whole number from 1 to 65535"},
       {"background", header + "0,0,0,0\n", ":2: id is 0, must be a whole number from 1 to 65535"},
       {"speed", header + "\n0,1,0,1e300\n", ":3: speed_mps is 1e+300, must be from -100000 to 100000"},
       {"cut", header + "0,1,0\n", ":2: has no speed_mps"}});
}

TEST(OwnLayout, ObjectPosesOutOfRange) {
  const RecordingFolder folder;
  write_frames(folder);
  expect_complaints(
      folder, "object_poses.txt",
      {{"objpose_1e300: frame", "1e300 1 " + still, ":1: frame is 1e+300, must be a whole number from 0 to 999999999"},
       {"objpose_1e300: id", "0 1e300 " + still, ":1: id is 1e+300, must be a whole number from 1 to 65535"},
       {"objpose_zero", "0 1 0 0 0 0 0 0 0 0 0 0 0 0", ":1: the pose's 3x3 part is not a rotation"}});
}

/// What is said of a file of the camera's poses; it may stand anywhere.
std::string camera_complaint(const RecordingFolder& folder, const std::string& content) {
  folder.text("camera", content);
  runner::SequenceOptions options = folder.options();
  options.camera = folder.path() / "camera";
  try {
    runner::Sequence sequence(options);
  } catch (const runner::FileError& error) {
    return std::string(error.what()).substr(options.camera.string().size());
  }
  return {};
}

TEST(CameraFile, PosesThatAreNotRigid) {
  const RecordingFolder folder;
  write_frames(folder);
  std::string extra;
  for (int i = 0; i < 50; ++i) extra += still;
  EXPECT_EQ(camera_complaint(folder, extra), "") << "camera_extra: of a longer recording";
  EXPECT_EQ(camera_complaint(folder, still + "1 0 0 0 0 1 0 0 0 0 1"), ":2: has 11 numbers, must have 12")
      << "camera_short";
  EXPECT_EQ(camera_complaint(folder, still), ": has 1 lines for 2 frames") << "camera_trunc";
  EXPECT_EQ(camera_complaint(folder, "1.01 0 0 0 0 1.01 0 0 0 0 1.01 0\n" + still),
            ":1: the pose's 3x3 part is not a rotation")
      << "camera_scaled";
  EXPECT_EQ(camera_complaint(folder, still + "1 0 0 1e308 0 1 0 0 0 0 1 0"),
            ":2: x is 1e+308, must be from -1000000000 to 1000000000")
      << "camera_huge";
}

/// What is said of a list of instances.
std::string list_complaint(const std::string& content, std::vector<dot::Instance>* instances = nullptr) {
  const RecordingFolder folder;
  folder.text("list.csv", content);
  const std::filesystem::path path = folder.path() / "list.csv";
  try {
    const std::vector<dot::Instance> read = runner::read_instances(path, {"nan"});
    if (instances != nullptr) *instances = read;
  } catch (const runner::FileError& error) {
    return std::string(error.what()).substr(path.string().size());
  }
  return {};
}

TEST(InstanceList, NumbersOutOfRange) {
  const std::string id = ", must be a whole number from 1 to 65535";
  EXPECT_EQ(list_complaint("1e300,car,0.9\n"), ":1: id is 1e+300" + id) << "masks_id_1e300";
  EXPECT_EQ(list_complaint("id,class,score\n0.5,car,1\n"), ":2: id is 0.5" + id);
  EXPECT_EQ(list_complaint("1\0,car,1\n"s), ":1: id '1?' is not a number");
  EXPECT_EQ(list_complaint("1,nan,1e300\n"), ":1: score is 1e+300, must be from -1000000 to 1000000")
      << "masks_class_nan: the score";
  EXPECT_EQ(list_complaint("1,car,high\n"), ":1: score 'high' is not a number");
  EXPECT_EQ(list_complaint("1,2147483648,1\n").substr(0, 26), ":1: class is 2147483648, m");
  EXPECT_EQ(list_complaint("1,1.5,1\n").substr(0, 19), ":1: class is 1.5, m");
  EXPECT_EQ(list_complaint("1\n"), ":1: must be id,class,score");
}

TEST(InstanceList, AClassMayBeNamedNan) {
  std::vector<dot::Instance> instances;
  EXPECT_EQ(list_complaint("1,nan,0.5\n2,7,1\n", &instances), "");
  ASSERT_EQ(instances.size(), 2U);
  EXPECT_EQ(instances[0].class_id, dot::Instance{}.class_id);
  EXPECT_TRUE(instances[0].always_dynamic);
  EXPECT_EQ(instances[1].class_id, 7);
}

}  // namespace
