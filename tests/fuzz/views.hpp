// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "dot/dot.h"
#include "fuzz/input.hpp"
#include "fuzz/scene.hpp"

/// @file
/// Pictures as the structs of dot.h, in blocks of memory that end where the interface says that reading ends: one byte
/// farther is the address sanitizer's finding.

namespace fuzz {

/// Blocks that live as long as one call needs them.
class Arena {
 public:
  unsigned char* take(std::size_t size) {
    blocks_.push_back(std::make_unique<unsigned char[]>(std::max<std::size_t>(size, 1)));
    return blocks_.back().get();
  }
  /// A struct of which a caller with this struct_size has so much.
  template <typename T>
  T* place(T value, std::uint32_t struct_size = sizeof(T)) {
    static_assert(std::is_trivially_copyable_v<T>);
    value.struct_size = struct_size;
    const std::size_t size = std::clamp<std::size_t>(struct_size, sizeof struct_size, sizeof(T));
    return reinterpret_cast<T*>(static_cast<unsigned char*>(std::memcpy(take(size), &value, size)));
  }

 private:
  std::vector<std::unique_ptr<unsigned char[]>> blocks_;
};

/// What is wrong with one struct of a call; nothing where `kind` is 0.
struct Fault {
  int kind = 0, value = 0;

  /// The fault if it is one of those from `first` to `last`, counted from 0; else -1.
  int among(int first, int last) const { return kind >= first && kind <= last ? kind - first : -1; }
};

/// A struct_size that a caller may have by mistake: near the right one, half of it, or anything.
inline std::uint32_t odd_size(std::uint32_t size, int value) {
  if (value < 64) return size - static_cast<std::uint32_t>(value) / 2;
  if (value < 128) return size + static_cast<std::uint32_t>(value) - 64;
  return value < 192 ? static_cast<std::uint32_t>(value - 128) : static_cast<std::uint32_t>(odd_number(value) == 0);
}

inline int bytes_of(std::uint32_t format) {
  switch (format) {
    case DOT_FORMAT_BGR8:
    case DOT_FORMAT_RGB8: return 3;
    case DOT_FORMAT_BGRA8:
    case DOT_FORMAT_DEPTH_F32:
    case DOT_FORMAT_ID32: return 4;
    case DOT_FORMAT_DEPTH_U16:
    case DOT_FORMAT_ID16: return 2;
    default: return 1;
  }
}

constexpr int kImageFaults = 10;

/// An image whose pixel i write(i, pixel) fills in. @param padding bytes behind each row.
/// @param fault 0 to kImageFaults - 1, or -1. None makes a call legal that would read what is not there.
template <typename Write>
dot_image* make_image(Arena& arena, std::uint32_t format, int width, int height, int padding, int fault, int value,
                      Write&& write) {
  const int bytes = bytes_of(format);
  const int align = bytes == 3 ? 1 : bytes;
  const std::int64_t row = static_cast<std::int64_t>(width) * bytes;
  const std::int64_t stride = row + padding / align * align;
  const std::int64_t size = stride * height - (fault < 0 ? stride - row : 0);
  unsigned char* data = arena.take(static_cast<std::size_t>(size) + (fault == 8 ? 1 : 0));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      write(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x),
            data + y * stride + static_cast<std::ptrdiff_t>(x) * bytes);
  dot_image image = DOT_IMAGE_INIT;
  image.format = format;
  image.width = width;
  image.height = height;
  image.stride_bytes = stride;
  image.data = data;
  image.depth_units_per_metre = 1000;
  std::uint32_t struct_size = sizeof image;
  switch (fault) {
    case 0: struct_size = odd_size(struct_size, value); break;
    case 1: image.format = static_cast<std::uint32_t>(value % 12); break;
    case 2: image.stride_bytes = row - 1 - value; break;
    case 3: image.stride_bytes = -stride; break;
    case 4: image.stride_bytes = std::numeric_limits<std::int64_t>::max() - value; break;
    case 5: image.data = nullptr; break;
    case 6: image.width = value < 128 ? width + 1 : value < 192 ? 0 : -width; break;
    case 7: image.height = value < 128 ? height - 1 : value < 192 ? 0 : -height; break;
    case 8: image.data = data + 1; break;
    case 9: image.depth_units_per_metre = odd_number(value); break;
    default: break;
  }
  if (image.height > 1 && image.stride_bytes > stride) image.stride_bytes = std::numeric_limits<std::int64_t>::max();
  // Bytes that are there but belong to no pixel: a format with larger pixels must not reach behind the block.
  if (image.format != format && bytes_of(image.format) * static_cast<std::int64_t>(width) > stride && height == 1)
    image.format = format;
  return arena.place(image, struct_size);
}

inline std::uint8_t to_byte(float grey) { return static_cast<std::uint8_t>(std::clamp(grey, 0.0f, 255.0f)); }

inline dot_image* grey_or_colour(Arena& arena, const Picture& p, std::uint32_t format, int padding, int fault,
                                 int value) {
  const int bytes = bytes_of(format);
  return make_image(arena, format, p.width, p.height, padding, fault, value, [&](std::size_t i, unsigned char* out) {
    std::memset(out, to_byte(p.grey[i]), static_cast<std::size_t>(bytes));
  });
}

inline dot_image* depth_image(Arena& arena, const Picture& p, bool u16, int padding, int fault, int value) {
  return make_image(arena, u16 ? DOT_FORMAT_DEPTH_U16 : DOT_FORMAT_DEPTH_F32, p.width, p.height, padding, fault, value,
                    [&](std::size_t i, unsigned char* out) {
                      const float depth = p.depth[i];
                      const auto units = static_cast<std::uint16_t>(depth > 0 ? std::min(depth * 1000, 65535.0f) : 0);
                      u16 ? std::memcpy(out, &units, sizeof units) : std::memcpy(out, &depth, sizeof depth);
                    });
}

}  // namespace fuzz
