// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "network/tensor.hpp"

/// @file
/// The outputs of the networks that make_models.py makes.

namespace network::test {

/// Boxes, a row each of x, y, width, height; scores of car, person, tree; coefficients. A column is a candidate.
inline std::vector<Tensor> yolo_v8() {
  return {{"output0", {1, 9, 6}, {6,     7,     11,   6,      8,      3,      //
                                  8,     8,     8,    8,      8,      6,      //
                                  8,     8,     10,   8,      4,      4,      //
                                  8,     8,     4,    8,      4,      4,      //
                                  .875F, .625F, 0,    .25F,   0,      .125F,  //
                                  0,     .5F,   .75F, .6875F, 0,      0,      //
                                  0,     0,     0,    0,      .9375F, 0,      //
                                  1,     1,     0,    -1,     1,      1,      //
                                  0,     0,     1,    0,      1,      0}},
          {"output1", {1, 2, 4, 4}, {1, 1, -1, -1, 1, 1, -1, -1, 1,  1,  -1, -1, 1,  1,  -1, -1,  //
                                     1, 1, 1,  1,  1, 1, 1,  1,  -1, -1, -1, -1, -1, -1, -1, -1}}};
}

/// The same detections as YOLOv5 has them: a row is a candidate, with an objectness after the box.
inline std::vector<Tensor> yolo_v5() {
  return {{"output0", {1, 6, 10}, {6,  8, 8,  8, 1,     .875F, 0,      0,      1,  0,  //
                                   7,  8, 8,  8, 1,     .625F, .5F,    0,      1,  0,  //
                                   11, 8, 10, 4, .75F,  0,     1,      0,      0,  1,  //
                                   6,  8, 8,  8, 1,     .25F,  .6875F, 0,      -1, 0,  //
                                   8,  8, 4,  4, 1,     0,     0,      .9375F, 1,  1,  //
                                   3,  6, 4,  4, .125F, 1,     0,      0,      1,  0}},
          yolo_v8()[1]};
}

inline std::vector<Tensor> torchvision() {
  Tensor masks{"masks", {4, 1, 4, 8}, {.5F,  .75F, .75F, 0, 0, 0, 0, 0,  //
                                       .75F, .75F, .75F, 0, 0, 0, 0, 0,  //
                                       .75F, .75F, .75F, 0, 0, 0, 0, 0,  //
                                       .75F, .75F, .75F, 0, 0, 0, 0, 0,  //
                                       0,    0,    0,    0, 0, 0, 0, 0,  //
                                       0,    0,    1,    1, 1, 1, 0, 0,  //
                                       0,    0,    1,    1, 1, 1, 0, 0,  //
                                       0,    0,    0,    0, 0, 0, 0, 0}};
  masks.values.resize(128, 1);  // the last two are 1 everywhere
  return {{"boxes", {4, 4}, {0, 0, 4, 4, 3, 1, 8, 3, 0, 0, 8, 4, 0, 0, 8, 4}},
          {"labels", {4}, {3, 1, 10, 3}},
          {"scores", {4}, {.75F, .875F, .9375F, .25F}},
          masks};
}

inline std::vector<Tensor> detectron2() {
  return {{"pred_boxes", {2, 4}, {0, 0, 4, 4, 4, 0, 8, 4}},
          {"pred_classes", {2}, {2, 0}},
          {"pred_masks", {2, 1, 2, 2}, {1, 0, 0, 0, 1, 1, 1, 1}},
          {"scores", {2}, {.75F, .875F}},
          {"image_size", {2}, {4, 8}}};
}

inline std::vector<Tensor> ids() { return {{"ids", {1, 1, 2, 4}, {0, 1, 300, 0, 2, 1, 0, 0}}}; }

}  // namespace network::test
