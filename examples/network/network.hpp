// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "run/segmentation.hpp"

/// @file
/// A segmentation network from an ONNX file, with the decoding of what the common ones give; see docs/network.md.

namespace network {

enum class Format {
  YoloSeg,   ///< yolo_seg.hpp
  MaskRcnn,  ///< mask_rcnn.hpp
  Ids,       ///< id_image.hpp
};

enum class BackendChoice { Default, OpenCv, OnnxRuntime };

struct NetworkOptions {
  std::filesystem::path model;
  std::optional<Format> format;             ///< absent: by the outputs of the file
  std::filesystem::path classes;            ///< empty: those of COCO
  std::optional<cv::Size> size;             ///< of the input; absent: as the file says, or as the format has it
  std::optional<float> score;               ///< least; absent: 0.25 for YOLO, 0.5 for Mask R-CNN
  std::vector<std::string> always_dynamic;  ///< further classes that count as moving
  BackendChoice backend = BackendChoice::Default;
};

/// A network that is loaded. One thread at a time may call `segment`.
struct Network {
  runner::Segmenter segment;             ///< throws runner::FileError that begins with the file's name
  std::string description;               ///< format, input and backend, for the summary
  std::vector<std::string> class_names;  ///< by Instance::class_id; empty: it tells no classes
};

/// @param image size of the images that will come.
/// @throws runner::FileError naming the file that is wrong and what was expected, runner::UsageError naming an option
/// that does not fit, or telling that the program was built without networks.
Network open_network(const NetworkOptions& options, cv::Size image);

}  // namespace network
