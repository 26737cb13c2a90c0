// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dot/motion/settings.hpp"

namespace runner {

struct Arguments {
  std::filesystem::path sequence;
  std::filesystem::path out;
  int mask_every = 1;  ///< use the masks of frames 0, K, 2K, ... only
  std::string depth_dir = "depth";
  std::string mask_dir = "masks";
  bool stereo = false;  ///< depth from rgb/ and right/ even where there is a depth folder
  bool overlay = false;
  int threads = 1;
  std::filesystem::path config;
  std::filesystem::path camera;  ///< camera-to-world poses to use instead of estimating the motion
  std::filesystem::path masks_out;
  std::vector<std::string> always_dynamic;  ///< classes of masks/*.csv
  std::optional<dot::ClassifierKind> classifier;
  bool help = false;
};

/// What `--help` prints.
extern const char* const usage;

/// @throws UsageError naming the option.
Arguments parse_arguments(int count, const char* const* values);

/// Classifier by the name used on the command line and in configuration files.
std::optional<dot::ClassifierKind> classifier_by_name(const std::string& name);

}  // namespace runner
