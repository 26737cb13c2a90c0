// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace dot {

/// A host's threads, lent to the library. The function calls job(0) ... job(count - 1), each once, in any order or in
/// parallel, and returns when all have ended. A job does not throw.
using ThreadPool = std::function<void(int count, const std::function<void(int)>& job)>;

}  // namespace dot
