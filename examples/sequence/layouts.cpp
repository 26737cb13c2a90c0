// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "layouts.hpp"

#include <string>
#include <utility>

#include "errors.hpp"
#include "kitti_odometry.hpp"
#include "kitti_raw.hpp"
#include "named_layout.hpp"
#include "own_layout.hpp"
#include "tum_rgbd.hpp"
#include "vkitti2.hpp"

namespace runner {

namespace {

Recording read_layout(const SequenceOptions& options) {
  if (!options.images.empty()) return read_named_layout(options);
  if (is_tum_rgbd(options.folder)) return read_tum_rgbd(options);
  if (is_vkitti2(options.folder)) return read_vkitti2(options);
  if (is_kitti_odometry(options.folder)) return read_kitti_odometry(options);
  if (is_kitti_raw(options.folder)) return read_kitti_raw(options);
  // Last, and without a question: its messages say what a folder that is nothing else lacks.
  return read_own_layout(options);
}

}  // namespace

Recording open_recording(const SequenceOptions& options) {
  if (options.images.empty())
    for (const auto& [value, name] :
         {std::pair{&options.right, "--right"}, std::pair{&options.intrinsics, "--intrinsics"}})
      if (!value->empty()) throw UsageError(std::string(name) + " needs --images");
  if (!std::filesystem::is_directory(options.folder)) throw FileError(options.folder.string() + ": no such folder");
  Recording recording = read_layout(options);
  if (recording.distortion && !recording.entries[0].right.empty())
    throw FileError(options.folder.string() +
                    ": depth from a stereo pair needs images without distortion: rectify them");
  if (options.depth_scale) recording.depth_units_per_metre = *options.depth_scale;
  return recording;
}

}  // namespace runner
