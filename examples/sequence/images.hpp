// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace runner {

/// Reads a PNG or JPEG file with its own depth and channels.
/// @throws FileError when it cannot be read, is cut short or is damaged.
cv::Mat read_image(const std::filesystem::path& path);

/// Like read_image, and checks the size.
cv::Mat read_image(const std::filesystem::path& path, cv::Size size);

/// @throws FileError naming the file when its image is not of the camera's size.
void check_size(const std::filesystem::path& path, const cv::Mat& image, cv::Size size);

/// Like read_image, but of a PNG file with a palette the indices themselves, CV_8UC1, whatever their colours.
cv::Mat read_indices(const std::filesystem::path& path, cv::Size size);

/// Of any size.
cv::Mat read_indices(const std::filesystem::path& path);

/// Writes a PNG file; under its name stands a whole picture at any time, see OutputFile.
/// @throws FileError when that fails.
void write_image(const std::filesystem::path& path, const cv::Mat& image);

}  // namespace runner
