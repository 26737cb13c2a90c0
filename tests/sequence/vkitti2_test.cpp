// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "sequence/sequence.hpp"
#include "support/complaints.hpp"

namespace {

/// The camera drives 1 m a frame along z, from z = 10. Car 0 stands 20 m ahead of its start, car 4 keeps 5 m ahead.
void write_scene(const RecordingFolder& folder) {
  for (const char* const number : {"00000", "00001"}) {
    const std::string n = number;
    for (const char* const camera : {"Camera_0", "Camera_1"})
      folder.image(std::string("frames/rgb/") + camera + "/rgb_" + n + ".jpg", CV_8UC3, 90);
    folder.image("frames/depth/Camera_0/depth_" + n + ".png", CV_16UC1, 1234);
    folder.image("frames/instanceSegmentation/Camera_0/instancegt_" + n + ".png", CV_8UC1, 5);
  }
  folder.text("intrinsic.txt", "frame cameraID K[0,0] K[1,1] K[0,2] K[1,2]\n0 0 725 726 3 2\n0 1 725 726 3 2\n");
  const std::string right = "0 1 1 0 0 -0.5 0 1 0 0 0 0 1 -10 0 0 0 1\n1 1 1 0 0 -0.5 0 1 0 0 0 0 1 -11 0 0 0 1\n";
  folder.text("extrinsic.txt",
              "frame cameraID r1,1 r1,2 r1,3 t1 r2,1 r2,2 r2,3 t2 r3,1 r3,2 r3,3 t3 0 0 0 1\n"
              "0 0 1 0 0 0 0 1 0 0 0 0 1 -10 0 0 0 1\n1 0 1 0 0 0 0 1 0 0 0 0 1 -11 0 0 0 1\n" +
                  right);
  folder.text("pose.txt",
              "frame cameraID trackID alpha width height length world_space_X world_space_Y world_space_Z "
              "rotation_world_space_y rotation_world_space_x rotation_world_space_z camera_space_X camera_space_Y "
              "camera_space_Z rotation_camera_space_y rotation_camera_space_x rotation_camera_space_z\n"
              "0 0 0 0 2 1.5 4 9 9 9 0 0 0 1 2 20 0.5 0 0\n"
              "0 0 4 0 2 1.5 4 9 9 9 0 0 0 0 2 5 0 0 0\n"
              "0 1 0 0 2 1.5 4 9 9 9 0 0 0 0.5 2 20 0.5 0 0\n"
              "1 0 0 0 2 1.5 4 9 9 9 0 0 0 1 2 19 0.5 0 0\n"
              "1 0 4 0 2 1.5 4 9 9 9 0 0 0 0 2 5 0 0 0\n"
              "1 0 7 0 2 1.5 4 9 9 9 0 0 0 0 2 50 0 0 0\n");
  folder.text("bbox.txt",
              "frame cameraID trackID left right top bottom number_pixels truncation_ratio occupancy_ratio isMoving\n"
              "0 0 0 0 1 0 1 4 0 1 False\n0 0 4 0 1 0 1 4 0 1 True\n0 1 0 0 1 0 1 4 0 1 True\n"
              "1 0 0 0 1 0 1 4 0 1 False\n1 0 4 0 1 0 1 4 0 1 True\n1 0 7 0 1 0 1 4 0 1 True\n");
}

TEST(Vkitti2, CameraDepthAndFiles) {
  const RecordingFolder folder("Scene01/clone");
  write_scene(folder);
  const runner::Recording recording = folder.open();
  EXPECT_EQ(recording.layout, "Virtual KITTI 2");
  EXPECT_EQ(recording.intrinsics.fx, 725);
  EXPECT_EQ(recording.intrinsics.fy, 726);
  EXPECT_EQ(recording.intrinsics.width, 6);
  EXPECT_DOUBLE_EQ(recording.intrinsics.baseline, 0.5);
  EXPECT_EQ(recording.depth_source, dot::DepthSource::Unknown);
  ASSERT_EQ(recording.entries.size(), 2u);
  EXPECT_EQ(recording.entries[1].number, 1);
  EXPECT_DOUBLE_EQ(recording.entries[1].timestamp, 0.1);
  EXPECT_EQ(recording.entries[1].depth, folder.path() / "frames/depth/Camera_0/depth_00001.png");
  EXPECT_TRUE(recording.entries[1].right.empty());
  EXPECT_EQ(recording.entries[1].masks, folder.path() / "frames/instanceSegmentation/Camera_0/instancegt_00001.png");
  runner::SequenceOptions without_masks = folder.options();
  without_masks.masks = false;
  EXPECT_TRUE(runner::open_recording(without_masks).entries[1].masks.empty());
  const runner::FrameTruth truth = runner::Sequence(folder.options()).truth(0);
  EXPECT_FLOAT_EQ(truth.depth.at<float>(0, 0), 12.34F);
  EXPECT_EQ(truth.instance.at<int>(0, 0), 5);
}

TEST(Vkitti2, StereoAndNetworkMasksOnRequest) {
  const RecordingFolder folder("Scene01/clone");
  write_scene(folder);
  folder.image("masks/rgb_00001.png", CV_8UC1, 1);
  runner::SequenceOptions options = folder.options();
  options.stereo = true;
  const runner::Recording recording = runner::open_recording(options);
  EXPECT_EQ(recording.depth_source, dot::DepthSource::Stereo);
  EXPECT_EQ(recording.entries[0].right, folder.path() / "frames/rgb/Camera_1/rgb_00000.jpg");
  EXPECT_TRUE(recording.entries[0].depth.empty());
  EXPECT_TRUE(recording.entries[0].masks.empty());
  EXPECT_EQ(recording.entries[1].masks, folder.path() / "masks/rgb_00001.png");
}

TEST(Vkitti2, TruthOfCameraAndObjects) {
  const RecordingFolder folder("Scene01/clone");
  write_scene(folder);
  const runner::Recording recording = folder.open();
  const runner::TruthEntry& first = recording.entries[0].truth;
  const runner::TruthEntry& second = recording.entries[1].truth;
  EXPECT_DOUBLE_EQ((*first.camera)(2, 3), 10);
  EXPECT_DOUBLE_EQ((*second.camera)(2, 3), 11);
  // Ids are one above the track's.
  ASSERT_EQ(first.objects.size(), 2u);
  EXPECT_FALSE(first.objects.at(1).moving);
  EXPECT_NEAR(first.objects.at(1).speed, 0, 1e-9);
  EXPECT_TRUE(first.objects.at(5).moving);
  EXPECT_NEAR(first.objects.at(5).speed, 10, 1e-9) << "over the step that follows";
  EXPECT_NEAR(second.objects.at(5).speed, 10, 1e-9);
  EXPECT_EQ(second.objects.at(8).speed, -1) << "seen once";
  const Eigen::Matrix4d& car = second.poses.at(1);
  EXPECT_TRUE((Eigen::Vector3d(car.topRightCorner<3, 1>()).isApprox(Eigen::Vector3d(1, 2, 30))));
  EXPECT_NEAR(car(0, 2), std::sin(0.5), 1e-12);
}

TEST(Vkitti2, ErrorsNameFileAndLine) {
  const RecordingFolder folder("Scene01/clone");
  write_scene(folder);
  folder.text("bbox.txt", "frame cameraID trackID isMoving\n0 0 0 False\n0 0 4 maybe\n");
  EXPECT_EQ(folder.complaint(), (folder.path() / "bbox.txt").string() + ":3: isMoving 'maybe' is not a number");
  folder.text("bbox.txt", "frame cameraID trackID\n");
  EXPECT_EQ(folder.complaint(), (folder.path() / "bbox.txt").string() + ":1: has no column 'isMoving'");
  write_scene(folder);
  folder.text("extrinsic.txt",
              "frame cameraID r1,1 r1,2 r1,3 t1 r2,1 r2,2 r2,3 t2 r3,1 r3,2 r3,3 t3 0 0 0 1\n"
              "0 0 1 0 0 0 0 1 0 0 0 0 1 -10 0 0 0 1\n");
  EXPECT_EQ(folder.complaint(), (folder.path() / "extrinsic.txt").string() + ": has no line for frame 1");
  runner::SequenceOptions stereo = folder.options();
  stereo.stereo = true;
  EXPECT_THROW(runner::open_recording(stereo), runner::FileError) << "without a second camera";
}

TEST(Vkitti2, ExtrinsicsThatAreNone) {
  const RecordingFolder folder("Scene01/clone");
  write_scene(folder);
  const std::string header = "frame cameraID r1,1 r1,2 r1,3 t1 r2,1 r2,2 r2,3 t2 r3,1 r3,2 r3,3 t3\n";
  const std::string left = "0 0 1 0 0 0 0 1 0 0 0 0 1 0\n1 0 1 0 0 0 0 1 0 0 0 0 1 0\n";
  expect_complaints(
      folder, "extrinsic.txt",
      {{"one camera", header + left, ""},
       {"extr_zero", header + "0 0 0 0 0 0 0 0 0 0 0 0 0 0\n" + left, ":2: the pose's 3x3 part is not a rotation"},
       {"extr_1e300", header + "1e300 0 1 0 0 0 0 1 0 0 0 0 1 0\n" + left,
        ":2: frame is 1e+300, must be a whole number from 0 to 999999999"},
       {"cameras swapped", header + left + "0 1 1 0 0 0.5 0 1 0 0 0 0 1 0\n",
        ":4: the baseline from camera 0 to camera 1 is -0.5, must be from 0 to 10"},
       {"cut", header + left + "1 0 1 0 0\n", ":4: has no t1"}});
}

TEST(Vkitti2, IntrinsicsThatAreNone) {
  const RecordingFolder folder("Scene01/clone");
  write_scene(folder);
  const std::string header = "frame cameraID K[0,0] K[1,1] K[0,2] K[1,2]\n";
  expect_complaints(folder, "intrinsic.txt",
                    {{"no focal length", header + "0 0 0 726 3 2\n", ":2: fx is 0, must be from 1 to 1000000"},
                     {"far centre", header + "0 1 0 0 0 0\n0 0 725 726 3 -1e300\n",
                      ":3: cy is -1e+300, must be from -100000 to 100000"},
                     {"other camera alone", header + "0 1 725 726 3 2\n", ": has no line for camera 0"}});
}

TEST(Vkitti2, ObjectsOutOfRange) {
  const std::string track = ", must be a whole number from 0 to 65534";
  {
    const RecordingFolder folder("Scene01/clone");
    write_scene(folder);
    const std::string header = "frame cameraID trackID isMoving\n";
    expect_complaints(
        folder, "bbox.txt",
        {{"bbox_1e300: frame", header + "1e300 0 4 True\n",
          ":2: frame is 1e+300, must be a whole number from 0 to 999999999"},
         {"bbox_1e300: track", header + "0 0 1e300 True\n", ":2: trackID is 1e+300" + track},
         {"bbox_intmax", header + "0 0 2147483647 True\n", ":2: trackID is 2147483647" + track},
         {"half moving", header + "0 0 4 0.5\n", ":2: isMoving is 0.5, must be a whole number from 0 to 1"}});
  }
  const RecordingFolder folder("Scene01/clone");
  write_scene(folder);
  const std::string header =
      "frame cameraID trackID camera_space_X camera_space_Y camera_space_Z rotation_camera_space_y "
      "rotation_camera_space_x rotation_camera_space_z\n";
  expect_complaints(
      folder, "pose.txt",
      {{"pose_intmax", header + "0 0 2147483647 1 1 1 0 0 0\n", ":2: trackID is 2147483647" + track},
       {"far away", header + "0 0 4 1 1e300 1 0 0 0\n", ":2: y is 1e+300, must be from -1000000000 to 1000000000"}});
}

}  // namespace
