// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "evaluate.hpp"
#include "pool.hpp"

namespace eval {

/// Columns of cells, each as wide as its widest; the first is left-aligned.
class Table {
 public:
  explicit Table(std::vector<std::string> header) { add(std::move(header)); }

  /// @param row with fewer cells than the header it is a remark, which makes no column wider.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// `pattern` filled in; a dash where the value is not finite.
std::string number(const char* pattern, double value);

/// A line for each run whose path is long enough for errors over stretches of 100 m.
std::string stretch_lines(const std::vector<RunScore>& runs);

/// The tables for a terminal: a row for each run, the pooled figures of each rate, latencies and times.
std::string text_table(const std::vector<RunScore>& runs, const std::vector<Pooled>& pooled);

}  // namespace eval
