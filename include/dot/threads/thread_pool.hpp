// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace dot {

/// A host's threads, lent to the library: calls job(0) ... job(count - 1), each once, in any order or at the same time,
/// and returns when all have ended. An exception of a job should come out of it.
using ThreadPool = std::function<void(int count, const std::function<void(int)>& job)>;

}  // namespace dot
