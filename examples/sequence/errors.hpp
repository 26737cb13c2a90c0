// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace runner {

/// The command line is wrong; the program ends with status 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file cannot be read, understood or written; the message begins with its path. The program ends with status 1.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace runner
