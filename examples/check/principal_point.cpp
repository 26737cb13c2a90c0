// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <string>

#include "measures.hpp"
#include "words.hpp"

/// @file
/// The principal point against the image's size. It shows intrinsics of another resolution, and those that were left
/// out, where the depth cannot: its steps fit a focal length that is wrong by a power of two.

namespace check {
namespace {

/// As a share of the image's width and height.
struct Place {
  double x = 0, y = 0;

  bool within(double low, double high) const { return low <= x && x <= high && low <= y && y <= high; }
};

struct Scale {
  double factor;      ///< by which the intrinsics would have to be multiplied
  const char* words;  ///< the size of image that they are for
};
constexpr std::array<Scale, 4> scales{{{2, "half"}, {0.5, "twice"}, {4, "a quarter of"}, {0.25, "four times"}}};

/// Whether it would be where a lens has it if the intrinsics were scaled so.
bool central_if_scaled(const Place& place, double factor) {
  constexpr double low = 0.4, high = 0.6;
  return Place{factor * place.x, factor * place.y}.within(low, high);
}

}  // namespace

Findings check_principal_point(const Samples& samples) {
  constexpr double low = 0.3, high = 0.7;  // a lens that was shifted, or a crop, may have it anywhere
  constexpr double inside = 0.01;          // of the size: nearer to the border it is taken for one that is not set
  const char* const name = "principal-point";
  const dot::Intrinsics& camera = samples.recording.intrinsics;
  const Place place{camera.cx / camera.width, camera.cy / camera.height};
  // The worse of the two.
  const double figure = 100 * (std::abs(place.x - 0.5) > std::abs(place.y - 0.5) ? place.x : place.y);
  const std::string said = "The principal point (" + number(camera.cx, 1) + ", " + number(camera.cy, 1) + ") lies at " +
                           number(100 * place.x, 0) + " % of the width and " + number(100 * place.y, 0) +
                           " % of the height";
  if (place.within(low, high)) return {fine(name, figure, "% of the size", said + ".")};
  for (const Scale& scale : scales)
    if (central_if_scaled(place, scale.factor))
      return {faulty(name, figure, "% of the size",
                     said + ", as if the intrinsics were those of an image of " + scale.words + " the size.",
                     "Give fx, fy, cx and cy in pixels of these images, " + size_text({camera.width, camera.height}) +
                         ": multiply them by " + number(scale.factor, 2) +
                         " if the images were scaled so since the calibration.")};
  const char* const advice =
      "Give cx and cy in pixels of these images; look whether they are missing or swapped, and whether the images were "
      "scaled or cropped since the calibration. Where the principal point is wrong, so are all directions.";
  if (!place.within(inside, 1 - inside))
    return {faulty(name, figure, "% of the size", said + ": at the border of the image, or outside.", advice)};
  return {
      hint(name, figure, "% of the size", said + ", right only where a crop or a shifted lens explains it.", advice)};
}

}  // namespace check
