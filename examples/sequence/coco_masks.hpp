// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "run/segmentation.hpp"

namespace runner {

/// Instance masks in a JSON file of COCO's format: "images" with id, file_name and, if given, width and height,
/// "annotations" with image_id, category_id and segmentation (polygons, or run lengths, compressed or not) and, if they
/// are a network's, score; and "categories" with id and name. Crowds (iscrowd) are left out: they are no instances.
class CocoMasks {
 public:
  /// Reads and checks all but the shapes.
  /// @throws FileError naming the file and what of it is missing or wrong.
  explicit CocoMasks(std::filesystem::path path);

  /// Whether the file has an image of this name; folders do not count, nor does the ending, or else the name is that of
  /// another image.
  bool has(const std::string& file_name) const { return images_.count(key(file_name)) > 0; }

  /// The masks of an image that the file has. Where two overlap, the one with the higher score is on top, or that which
  /// comes later.
  /// @param always_dynamic names or numbers of categories whose instances are flagged so.
  /// @throws FileError naming the image and what is wrong.
  Segmentation read(const std::string& file_name, cv::Size size, const std::vector<std::string>& always_dynamic) const;

 private:
  struct Annotation {
    std::int64_t id = 0;
    std::int32_t category = -1;
    float score = 1;
    std::vector<std::vector<double>> polygons;
    std::vector<std::int64_t> runs;  ///< of an image of `size`
    std::string compressed_runs;     ///< likewise
    cv::Size size;
  };

  struct Image {
    cv::Size size;  ///< empty: the file does not say it
    std::vector<Annotation> annotations;
  };

  static std::string key(const std::string& file_name) { return std::filesystem::path(file_name).stem().string(); }
  static void paint(const Annotation& annotation, std::uint16_t id, cv::Mat& ids);

  std::filesystem::path path_;
  std::map<std::string, Image> images_;  ///< by file name without folder and ending
  std::map<std::int32_t, std::string> categories_;
};

}  // namespace runner
