// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "images.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "errors.hpp"

namespace runner {
namespace {

bool starts_with(const std::vector<std::uint8_t>& bytes, const std::vector<std::uint8_t>& marker) {
  return bytes.size() >= marker.size() && std::equal(marker.begin(), marker.end(), bytes.begin());
}

bool ends_with(const std::vector<std::uint8_t>& bytes, const std::vector<std::uint8_t>& marker) {
  // Some writers pad; what follows the end of the image does not matter.
  constexpr std::ptrdiff_t padding = 4096;
  const auto size = static_cast<std::ptrdiff_t>(bytes.size());
  const auto tail = bytes.end() - std::min(size, padding);
  return std::search(tail, bytes.end(), marker.begin(), marker.end()) != bytes.end();
}

/// A decoder fills the missing part of a truncated JPEG with grey and calls it read, hence this check.
bool cut_short(const std::vector<std::uint8_t>& bytes) {
  if (starts_with(bytes, {0xFF, 0xD8})) return !ends_with(bytes, {0xFF, 0xD9});
  if (starts_with(bytes, {0x89, 'P', 'N', 'G'})) return !ends_with(bytes, {'I', 'E', 'N', 'D', 0xAE, 0x42, 0x60, 0x82});
  return false;
}

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path) {
  std::vector<std::uint8_t> bytes;
  try {
    std::ifstream stream(path, std::ios::binary);
    if (stream) bytes.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  } catch (const std::ios_base::failure&) {
    bytes.clear();  // a folder, or a failing disk
  }
  if (bytes.empty()) throw FileError(path.string() + ": cannot be read");
  return bytes;
}

}  // namespace

cv::Mat read_image(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = read_bytes(path);
  if (cut_short(bytes)) throw FileError(path.string() + ": the file is cut short");
  cv::Mat image;
  try {
    image = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) throw FileError(path.string() + ": not a readable image");
  return image;
}

cv::Mat read_image(const std::filesystem::path& path, cv::Size size) {
  cv::Mat image = read_image(path);
  if (image.size() != size)
    throw FileError(path.string() + ": is " + std::to_string(image.cols) + "x" + std::to_string(image.rows) +
                    ", the camera is " + std::to_string(size.width) + "x" + std::to_string(size.height));
  return image;
}

void write_image(const std::filesystem::path& path, const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", image, bytes);
  std::ofstream stream(path, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!stream.flush()) throw FileError(path.string() + ": cannot be written");
}

}  // namespace runner
