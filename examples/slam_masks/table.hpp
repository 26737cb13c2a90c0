// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "experiment.hpp"

namespace slam {

/// The table of the results on standard output, a row as each sequence is done.
class Table {
 public:
  /// Prints the heading. @param seeds runs of each configuration.
  explicit Table(int seeds);

  void add(const Experiment& experiment);

  /// Prints the means over the sequences.
  void finish() const;

 private:
  int rows_ = 0;
  PerMasks<double> over_best_{};  ///< sum over the rows of ATE / the best of the row
  PerMasks<double> over_dot_{};   ///< sum over the rows of ATE / that with DOT masks
};

}  // namespace slam
