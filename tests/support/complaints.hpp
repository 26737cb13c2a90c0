// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <string>

#include "recording_folder.hpp"

/// A file with nonsense in it, and what its reader must say of it.
struct Nonsense {
  const char* name;  ///< of the case
  std::string content;
  std::string complaint;  ///< after the path, ":3: what is wrong"; empty if it is harmless
};

/// Each of the contents in the place of a file of a recording that is otherwise good.
inline void expect_complaints(const RecordingFolder& folder, const std::string& file,
                              std::initializer_list<Nonsense> cases) {
  ASSERT_EQ(folder.complaint(), "") << "otherwise the cases prove nothing";
  const std::string name = std::filesystem::path(file).filename().string();
  for (const Nonsense& bad : cases) {
    folder.text(file, bad.content);
    const std::string said = folder.complaint(), expected = bad.complaint.empty() ? "" : name + bad.complaint;
    const std::size_t length = std::min(said.size(), bad.complaint.empty() ? said.size() : expected.size());
    EXPECT_EQ(said.substr(said.size() - length), expected) << bad.name << ": '" << said << "'";
  }
}
