// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "images.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "errors.hpp"
#include "output_file.hpp"

namespace runner {
namespace {

bool starts_with(const std::vector<std::uint8_t>& bytes, const std::vector<std::uint8_t>& marker) {
  return bytes.size() >= marker.size() && std::equal(marker.begin(), marker.end(), bytes.begin());
}

const std::vector<std::uint8_t> png_marker = {0x89, 'P', 'N', 'G'};

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
  if (starts_with(bytes, png_marker)) return !ends_with(bytes, {'I', 'E', 'N', 'D', 0xAE, 0x42, 0x60, 0x82});
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

// Places in the header of a PNG file (ISO/IEC 15948, 11.2.2).
constexpr std::size_t png_header = 8, png_width = 16, png_height = 20, png_bit_depth = 24, png_colour_type = 25,
                      png_header_crc = 29, png_chunks = 33;

std::uint32_t big_endian(const std::uint8_t* b) {
  return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | std::uint32_t{b[3]};
}

/// A few bytes can claim a size for which a decoder takes gigabytes.
bool too_large(const std::vector<std::uint8_t>& bytes) {
  constexpr std::uint64_t most_pixels = std::uint64_t{1} << 27;
  return starts_with(bytes, png_marker) && bytes.size() > png_chunks &&
         std::uint64_t{big_endian(&bytes[png_width])} * big_endian(&bytes[png_height]) > most_pixels;
}

cv::Mat decode(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes) {
  if (too_large(bytes)) throw FileError(path.string() + ": has more than 134 million pixels");
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

bool has_palette(const std::vector<std::uint8_t>& bytes) {
  constexpr int palette = 3;
  return bytes.size() > png_chunks && starts_with(bytes, png_marker) && bytes[png_colour_type] == palette;
}

/// The cyclic redundancy check of PNG chunks (ISO/IEC 15948, annex D).
std::uint32_t crc(const std::uint8_t* begin, const std::uint8_t* end) {
  std::uint32_t c = 0xFFFFFFFF;
  for (; begin != end; ++begin) {
    c ^= *begin;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xEDB88320 ^ (c >> 1) : c >> 1;
  }
  return ~c;
}

/// The same file with its pixels declared as grey values. OpenCV shows the colours of a palette alone, which need not
/// be distinct.
std::vector<std::uint8_t> without_palette(const std::vector<std::uint8_t>& png) {
  std::vector<std::uint8_t> grey(png.begin(), png.begin() + png_chunks);
  grey[png_colour_type] = 0;
  const std::uint32_t header_crc = crc(&grey[png_header + 4], &grey[png_header_crc]);
  for (std::size_t i = 0; i < 4; ++i) grey[png_header_crc + i] = static_cast<std::uint8_t>(header_crc >> (24 - 8 * i));
  constexpr std::size_t frame = 12;  // length, type and check of a chunk
  for (std::size_t at = png_chunks; at + frame <= png.size();) {
    const std::size_t size = std::min(frame + big_endian(&png[at]), png.size() - at);
    const std::string type(png.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                           png.begin() + static_cast<std::ptrdiff_t>(at) + 8);
    if (type != "PLTE" && type != "tRNS")
      grey.insert(grey.end(), png.begin() + static_cast<std::ptrdiff_t>(at),
                  png.begin() + static_cast<std::ptrdiff_t>(at + size));
    at += size;
  }
  return grey;
}

}  // namespace

void check_size(const std::filesystem::path& path, const cv::Mat& image, cv::Size size) {
  if (image.size() != size)
    throw FileError(path.string() + ": is " + std::to_string(image.cols) + "x" + std::to_string(image.rows) +
                    ", the camera is " + std::to_string(size.width) + "x" + std::to_string(size.height));
}

cv::Mat read_image(const std::filesystem::path& path) { return decode(path, read_bytes(path)); }

cv::Mat read_image(const std::filesystem::path& path, cv::Size size) {
  cv::Mat image = read_image(path);
  check_size(path, image, size);
  return image;
}

cv::Mat read_indices(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = read_bytes(path);
  const bool palette = has_palette(bytes);
  if (palette && bytes[png_bit_depth] > 8) throw FileError(path.string() + ": not a readable image");
  cv::Mat indices = decode(path, palette ? without_palette(bytes) : bytes);
  if (!palette) return indices;
  // Grey values of less than 8 bits are spread over the whole range.
  const int spread = 255 / ((1 << bytes[png_bit_depth]) - 1);
  if (spread > 1) indices /= spread;
  return indices;
}

cv::Mat read_indices(const std::filesystem::path& path, cv::Size size) {
  cv::Mat indices = read_indices(path);
  check_size(path, indices, size);
  return indices;
}

void write_image(const std::filesystem::path& path, const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", image, bytes);
  OutputFile file(path);
  file.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.finish();
}

}  // namespace runner
