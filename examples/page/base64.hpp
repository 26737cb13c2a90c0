// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace page {

/// Bytes as text (RFC 4648).
std::string base64(const std::vector<std::uint8_t>& bytes);

}  // namespace page
