// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "record.hpp"
#include "sequence_list.hpp"

namespace dataset {

/// What has become of a sequence.
enum class Status { Complete, Failed, Interrupted };

struct Outcome {
  Item item;
  Status status = Status::Interrupted;  ///< or not begun
  Figures figures;                      ///< where it is complete
  std::string reason;                   ///< where it is not
};

const char* to_string(Status status);

/// A table with a line for each sequence; fields that are not known are empty.
std::string summary_csv(const std::vector<Outcome>& outcomes);

}  // namespace dataset
