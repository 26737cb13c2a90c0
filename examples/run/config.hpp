// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "dot/pipeline/options.hpp"

namespace runner {

/// Reads `name = value` lines into `options`; the names are those of dot::for_each_option, besides `classifier` and
/// `depth_noise.source`. A `#` starts a comment.
/// @throws FileError naming the line whose name or value is wrong, or which sets again what was set.
void read_config(const std::filesystem::path& path, dot::Options& options);

/// Classifier by the name used on the command line and in configuration files.
std::optional<dot::ClassifierKind> classifier_by_name(const std::string& name);

}  // namespace runner
