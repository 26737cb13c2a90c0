// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fields.hpp"
#include "recording.hpp"

/// @file
/// Fills in the entries of a Recording from the files of its folders; what several layouts share.

namespace runner {

/// Whether a file is there. A dangling link counts: reading it then says what is wrong.
/// @throws FileError when that cannot be found out.
bool is_there(const std::filesystem::path& path);

/// What lies in a folder.
/// @throws FileError when it cannot be read, or is none.
std::vector<std::filesystem::path> list_files(const std::filesystem::path& folder);

/// The images of a folder whose names are `prefix` and a number, by that number.
/// @throws FileError when there are none, or two of one number.
std::vector<RecordingEntry> list_images(const std::filesystem::path& folder, const std::string& prefix = "");

/// Name of a frame's image, that of its number where it is in a video.
std::string image_name(const RecordingEntry& entry);

/// The file of `folder` that belongs to the same frame: named as its image, or by the number in six digits.
std::filesystem::path same_frame(const std::filesystem::path& folder, const RecordingEntry& entry);

/// One time in seconds a line.
/// @param plausible whether they must be, and increase.
/// @throws FileError naming the line at which time does not increase.
void read_times(const std::filesystem::path& path, std::vector<RecordingEntry>& entries, bool plausible = true);

/// Times in seconds that a layout has read in its own manner, one a row.
/// @throws FileError naming the line at which time does not increase.
void set_times(const std::filesystem::path& path, const std::vector<Row>& rows, std::vector<RecordingEntry>& entries,
               bool plausible = true);

/// Camera-to-world poses, 3x4 row-major, as the truth.
void read_poses(const std::filesystem::path& path, std::vector<RecordingEntry>& entries);

/// Masks of the folder or file that the options name; frames without a file have none.
/// @return whether there is such a folder, and the masks are asked for (SequenceOptions::masks).
/// @throws FileError when a folder is missing that the user has named, cannot be read or has no mask of any frame.
bool list_masks(const SequenceOptions& options, std::vector<RecordingEntry>& entries);

/// Fills in exactly one of `depth` and `right` of each entry: the folder of depth images that the options name, or the
/// right images.
/// @param calibration file to name when stereo is asked for and there is no baseline.
/// @param stated noise of the depth images; without it stereo if there is a baseline, else unknown.
void choose_depth(const SequenceOptions& options, const std::filesystem::path& right,
                  const std::filesystem::path& calibration, std::optional<dot::DepthSource> stated,
                  Recording& recording);

}  // namespace runner
