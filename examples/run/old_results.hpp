// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace runner {

/// Names in a folder of results.
struct ResultNames {
  static constexpr const char* pictures[] = {"labels", "instances", "overlay"};  ///< folders
  static constexpr const char* masks[] = {"mask_dot", "mask_all"};               ///< folders of --masks-out
  static constexpr const char* camera = "camera.txt";
  static constexpr const char* objects = "objects.csv";
  static constexpr const char* revised = "revised.txt";  ///< only if there is something to write
  static constexpr const char* timing = "timing.csv";    ///< the first table to be begun and the last to be complete
  static constexpr const char* tables[] = {camera, objects, revised, timing};
};

/// Makes a folder ready for new results, which must not mix with those of an earlier run. Removed are the record that
/// they are complete (dataset/record.hpp), the tables, and pictures and masks that are named as a frame's, 000012.png;
/// nothing else, and no folder but one that has become empty. An earlier run is known by its table of times, complete
/// or not, which the caller begins anew before anything else.
/// @throws FileError naming one of such files when there is no such table: they are somebody else's.
void remove_old_results(const std::filesystem::path& out);

/// The same for the folder of the exclusion masks; the names mask_dot and mask_all tell whose they are.
void remove_old_masks(const std::filesystem::path& masks_out);

}  // namespace runner
