// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coco_masks.hpp"
#include "distortion.hpp"
#include "dot/camera/intrinsics.hpp"
#include "dot/camera/settings.hpp"
#include "video_input.hpp"

/// @file
/// What a recording on disk consists of, images not yet read. Each layout of folders is one function that fills in a
/// Recording (own_layout.hpp is the example to follow); layouts.hpp chooses among them; Sequence reads the images.

namespace runner {

/// What the user says about the recording.
struct SequenceOptions {
  std::filesystem::path folder;
  std::string depth_dir = "depth";          ///< folder of the depth images
  std::string mask_dir = "masks";           ///< folder of the masks, or a file .json in COCO's format
  bool stereo = false;                      ///< depth from the stereo pair even where there are depth images
  std::filesystem::path images;             ///< folder, pattern or video in `folder`; empty: a layout that is known
  std::filesystem::path right;              ///< with `images`: those of the second eye
  std::filesystem::path intrinsics;         ///< with `images`: file of the camera; empty: intrinsics.txt
  std::optional<double> depth_scale;        ///< units of the depth images to the metre, instead of the layout's
  OpenVideo open_video;                     ///< empty: videos are refused
  int mask_every = 1;                       ///< use the masks of frames 0, K, 2K, ... only
  bool masks = true;                        ///< read the masks; off where a network makes them
  std::filesystem::path camera;             ///< camera-to-world poses to use instead of estimating the motion
  std::vector<std::string> always_dynamic;  ///< classes of the masks' csv files
  bool check_times = true;                  ///< refuse those that do not increase or are no seconds
  bool truth = false;                       ///< read the truth as well: a tracker has no business with it
};

/// What is true of one object in one frame.
struct TrueObject {
  bool moving = false;
  double speed = 0;  ///< m/s; negative where it is not known
};

/// The truth of one frame, for scoring alone and only where SequenceOptions::truth asks; each part may be absent.
struct TruthEntry {
  std::filesystem::path instance;         ///< image of ids that are stable over time, 0 = background
  std::filesystem::path depth;            ///< the best depth there is
  std::filesystem::path measured;         ///< the depth as a sensor gave it, if a file of the recording
  std::map<int, TrueObject> objects;      ///< by id
  std::optional<Eigen::Matrix4d> camera;  ///< T_world_camera
  std::map<int, Eigen::Matrix4d> poses;   ///< T_world_object, by id
};

/// The files of one frame. The layout gives either `depth` or `right`.
struct RecordingEntry {
  int number = 0;  ///< unique: names the frame in messages and outputs
  double timestamp = 0;
  std::filesystem::path image;
  std::filesystem::path depth;            ///< 16 bit
  int video_frame = 0;                    ///< place in those of image, depth and right that are videos
  std::filesystem::path right;            ///< of the rectified stereo pair
  std::filesystem::path masks;            ///< image of ids, grey or palette; empty: no segmentation of this frame
  std::filesystem::path instances;        ///< list of id,class,score; may be empty
  std::shared_ptr<const CocoMasks> coco;  ///< that has the masks instead of an image of ids
  TruthEntry truth;
};

struct Recording {
  std::string layout;  ///< name to show
  dot::Intrinsics intrinsics;
  dot::DepthSource depth_source = dot::DepthSource::Unknown;
  double depth_units_per_metre = 256;
  std::optional<Distortion> distortion;  ///< of the images; depth, masks and truth belong to them pixel by pixel
  std::map<std::filesystem::path, std::shared_ptr<VideoInput>> videos;
  std::vector<RecordingEntry> entries;  ///< at least one, by increasing time if that was checked
};

/// Line of a per-frame file for the frame at `index` of `frames`: files hold a line for each image, or, where the
/// images are a part of a longer recording, one for each frame number.
/// @throws FileError when there is no such line.
std::size_t row_of(const std::filesystem::path& path, std::size_t rows, std::size_t frames, std::size_t index,
                   int number);

/// The 4x4 matrix of 12 numbers, 3x4 row-major.
Eigen::Matrix4d pose_from_row_major(const double* values);

}  // namespace runner
