// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "arguments.hpp"

namespace slam {

/// What the features are kept off: nothing, what moves, whatever could move.
enum class Masks { None, Dot, All, Count };

/// A value of each.
template <typename T>
using PerMasks = std::array<T, static_cast<std::size_t>(Masks::Count)>;

/// What came out for one sequence.
struct Experiment {
  std::string name;
  int frames = 0;
  double path = 0;                    ///< metres, of the true poses
  PerMasks<std::vector<double>> ate;  ///< metres, of each seed, ascending
  PerMasks<std::vector<int>> lost;    ///< frames without a pose, of each seed, ascending
  PerMasks<double> excluded{};        ///< mean share of the pixels
};

/// @throws FileError naming the file that cannot be read, or that has no true poses.
Experiment run_experiment(const Arguments& arguments, const std::filesystem::path& folder);

}  // namespace slam
