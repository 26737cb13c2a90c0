// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "dot/dot.h"
#include "fuzz/input.hpp"
#include "fuzz/scene.hpp"
#include "fuzz/views.hpp"

/// @file
/// Segmentations of a picture: what a network would say, what a poor one would, and what none should.

namespace fuzz {

/// Faults of the masks' structs, counted from 0; then those of the images.
constexpr int kMaskFaults = 8 + kImageFaults;

/// The id of pixel i in an id image. @param pattern 0: the plates'; others are not of this picture.
inline std::uint32_t id_of(const Picture& p, std::size_t i, int pattern, int detail) {
  const int width = p.width;
  const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
  switch (pattern) {
    case 1: return static_cast<std::uint32_t>(x / (detail % 8 + 1) + y / (detail % 5 + 1) * width);  // a grid of ids
    case 2: return static_cast<std::uint32_t>(detail);                                               // all one object
    case 3:
      return (static_cast<std::uint32_t>(i) * 2654435761u >> 7) % static_cast<std::uint32_t>(detail + 1);  // noise
    default: break;
  }
  // The plates whose bit is not set, moved by some pixels; ids may change from frame to frame.
  const int from_x = std::clamp(x - (detail >> 3 & 3), 0, width - 1);
  const int id =
      p.ids[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(from_x)];
  if (id == 0 || (detail >> (id - 1) & 1) != 0) return 0;
  return static_cast<std::uint32_t>(detail >> 5 == 0 ? id : detail >> 5 == 7 ? 250 + id : (id + detail) % 5 + 1);
}

/// Instances with masks of their own around the plates. @param detail as in `id_of`, further: wider, cut off, out of
/// the image.
inline void add_instances(Arena& arena, const Picture& p, int detail, bool ids_too, const Fault& fault,
                          dot_masks& masks) {
  constexpr int count = Scene::kPlates;
  std::uint32_t step = sizeof(dot_instance);
  if (fault.among(2, 2) == 0) step = odd_size(step, fault.value);
  const std::size_t stored = std::clamp<std::size_t>(step, sizeof step, sizeof(dot_instance));
  unsigned char* array = arena.take(stored * count);
  for (int k = 0; k < count; ++k) {
    int box[4] = {p.width, p.height, 0, 0};
    for (int y = 0; y < p.height; ++y)
      for (int x = 0; x < p.width; ++x)
        if (p.ids[static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(x)] ==
            k + 1) {
          box[0] = std::min(box[0], x), box[1] = std::min(box[1], y);
          box[2] = std::max(box[2], x + 1), box[3] = std::max(box[3], y + 1);
        }
    if (box[2] == 0) box[0] = box[1] = 0, box[2] = std::min(8, p.width), box[3] = std::min(8, p.height);
    const int width = box[2] - box[0] + (detail >> 3 & 3), height = box[3] - box[1];
    dot_instance instance = DOT_INSTANCE_INIT;
    instance.struct_size = fault.among(7, 7) == 0 && k == 1 ? odd_size(step, fault.value) : step;
    instance.id = static_cast<std::uint32_t>(k + 1);
    instance.class_id = k;
    instance.score =
        fault.among(3, 3) == 0 ? static_cast<float>(std::clamp(odd_number(fault.value), -3e38, 3e38)) : 0.9f;
    if (k == 2 && (detail & 0x40) != 0) instance.flags = DOT_INSTANCE_ALWAYS_DYNAMIC;
    if (fault.among(4, 4) == 0) instance.flags = static_cast<std::uint32_t>(fault.value);
    if (fault.among(5, 5) == 0) instance.reserved = static_cast<std::uint32_t>(fault.value);
    instance.x = box[0];
    instance.y = box[1];
    if ((detail & 0x80) != 0) instance.x += (k - 1) * p.width / 2;
    if (fault.among(6, 6) == 0) instance.x = odd_integer(fault.value);
    const bool own = !ids_too || k == 1;
    if (own && (detail >> k & 1) == 0)
      instance.mask =
          make_image(arena, (detail & 0x20) != 0 ? DOT_FORMAT_ID8 : DOT_FORMAT_GREY8, width, height, detail & 3,
                     fault.among(8, kMaskFaults - 1), fault.value,
                     [&](std::size_t i, unsigned char* out) { *out = (detail & 0x20) != 0 && i % 7 == 0 ? 0 : 255; });
    else if (!ids_too)
      instance.mask =
          make_image(arena, DOT_FORMAT_GREY8, 1, 1, 0, -1, 0, [](std::size_t, unsigned char* out) { *out = 0; });
    std::memcpy(array + stored * static_cast<std::size_t>(k), &instance, stored);
  }
  masks.instances = reinterpret_cast<dot_instance*>(array);
  masks.instance_count = count;
}

/// @param kind & 7: 0 none, 1 an empty segmentation, 2 to 4 an id image of 1, 2, 4 bytes, 5 instances, 6 both, 7 an id
/// image that has nothing to do with the picture.
inline dot_masks* make_masks(Arena& arena, const Picture& p, int kind, int detail, const Fault& fault) {
  if ((kind & 7) == 0) return nullptr;
  dot_masks masks = DOT_MASKS_INIT;
  const int form = kind & 7;
  if ((form >= 2 && form <= 4) || form >= 6) {
    constexpr std::uint32_t formats[] = {DOT_FORMAT_ID8, DOT_FORMAT_ID16, DOT_FORMAT_ID32};
    const std::uint32_t format = formats[form <= 4 ? form - 2 : (kind >> 3) % 3];
    // Ids strewn over a large picture are legal and slow: each mask may overlap each.
    const int pattern = form == 7 && p.ids.size() <= 2000 ? 1 + (kind >> 5) % 3 : 0;
    masks.ids = make_image(arena, format, p.width, p.height, kind >> 6, fault.among(8, kMaskFaults - 1), fault.value,
                           [&](std::size_t i, unsigned char* out) {
                             const std::uint32_t id = id_of(p, i, pattern, detail);
                             std::memcpy(out, &id, static_cast<std::size_t>(bytes_of(format)));
                           });
  }
  if (form == 5 || form == 6) add_instances(arena, p, detail, form == 6, fault, masks);
  std::uint32_t struct_size = sizeof masks;
  if (fault.among(0, 0) == 0) struct_size = odd_size(struct_size, fault.value);
  if (fault.among(1, 1) == 0) masks.instances = nullptr;
  return arena.place(masks, struct_size);
}

}  // namespace fuzz
