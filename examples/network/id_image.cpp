// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "id_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace network {

runner::Segmentation decode_id_image(const std::vector<Tensor>& outputs, const Placement& p) {
  const Tensor& image = outputs[0];
  const std::size_t rank = image.shape.size();
  if (outputs.size() != 1 || rank < 2 || rank > 4 ||
      std::any_of(image.shape.begin(), image.shape.end() - 2, [](int length) { return length != 1; }))
    bad_shape(image,
              "HxW, 1xHxW or 1x1xHxW, and no other output (an image of ids; ArgMax, where there are classes, "
              "belongs into the network)");
  const int height = image.shape[rank - 2], width = image.shape[rank - 1];
  const auto id_at = [&](int x, int y) {
    const float value =
        image.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    if (!(value >= 0 && value <= 65535) || value != std::floor(value))
      throw NetworkError("output '" + image.name + "' is " + to_text(value) + " at " + std::to_string(x) + ", " +
                         std::to_string(y) + ", expected whole numbers from 0 to 65535");
    return static_cast<std::uint16_t>(value);
  };
  const auto cell = [](double at, int length, int most) {
    return std::min(static_cast<int>(at * most / length), most - 1);
  };

  runner::Segmentation segmentation;
  segmentation.ids = cv::Mat(p.image, CV_16UC1);
  for (int y = 0; y < p.image.height; ++y)
    for (int x = 0; x < p.image.width; ++x)
      segmentation.ids.at<std::uint16_t>(y, x) =
          id_at(cell(p.scale_x * (x + 0.5) + p.offset_x, p.input.width, width),
                cell(p.scale_y * (y + 0.5) + p.offset_y, p.input.height, height));
  return segmentation;
}

}  // namespace network
