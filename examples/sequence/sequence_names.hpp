// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace runner {

/// Names of sequences: those of their folders, with as many of the folders above as make them differ, "Scene01-clone".
/// @throws UsageError when a folder is given twice.
std::vector<std::string> sequence_names(const std::vector<std::filesystem::path>& folders);

}  // namespace runner
