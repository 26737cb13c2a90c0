// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dot/frame/frame.hpp"

namespace runner {

/// Reads a list of instances, id,class,score a line, with or without a header.
/// @param always_dynamic classes whose instances are flagged so.
/// @throws FileError naming the line that is wrong.
std::vector<dot::Instance> read_instances(const std::filesystem::path& path,
                                          const std::vector<std::string>& always_dynamic);

}  // namespace runner
