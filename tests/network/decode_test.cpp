// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "known_tensors.hpp"
#include "network/id_image.hpp"
#include "network/mask_rcnn.hpp"
#include "network/yolo_seg.hpp"
#include "pictures.hpp"

// The decoders of each format on known tensors; what they must find was worked out by hand.

namespace network::test {
namespace {

const std::vector<Class> three = {{"car"}, {"person", Role::Dynamic}, {"tree", Role::Ignored}};

/// An image of 16x8 lies in rows 4 to 11 of the 16x16 input. The prototypes' cells are 4x4 pixels; the first one
/// changes its sign between columns 7 and 8 of the image, the second between rows 3 and 4.
/// - car, .875: columns 2 to 9, all rows, the left half of the image: columns 2 to 7;
/// - car, .625, nearly the same box: suppressed;
/// - person, .75: columns 6 to 15, rows 2 to 5, of them the upper half; the car has columns 6 and 7;
/// - person, .6875, the box of the car: not suppressed, another class; columns 8 and 9, less what the other person has;
/// - tree: ignored; car, .125: under the threshold.
const Picture yolo_ids = {"..11111133......",  //
                          "..11111133......",  //
                          "..11111122222222",  //
                          "..11111122222222",  //
                          "..11111133......",  //
                          "..11111133......",  //
                          "..11111133......",  //
                          "..11111133......"};

const Placement yolo_placement = place({16, 8}, {16, 16}, true);

void expect_yolo(const std::vector<Detection>& detections) {
  const runner::Segmentation s = to_segmentation(detections, three, {16, 8});
  EXPECT_EQ(picture(s.ids), yolo_ids);
  ASSERT_EQ(s.instances.size(), 3U);
  const int class_ids[] = {0, 1, 1};
  const float scores[] = {.875F, .75F, .6875F};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(s.instances[i].id, i + 1);
    EXPECT_EQ(s.instances[i].class_id, class_ids[i]);
    EXPECT_EQ(s.instances[i].score, scores[i]);
    EXPECT_EQ(s.instances[i].always_dynamic, class_ids[i] == 1);
  }
}

/// What decoding `outputs` throws.
template <typename Decode>
std::string complaint(Decode&& decode) {
  try {
    decode();
  } catch (const NetworkError& error) {
    return error.what();
  }
  return "";
}

TEST(YoloSeg, Version8) { expect_yolo(decode_yolo_seg(yolo_v8(), 3, yolo_placement, {})); }

TEST(YoloSeg, Version5MultipliesByTheObjectness) { expect_yolo(decode_yolo_seg(yolo_v5(), 3, yolo_placement, {})); }

TEST(YoloSeg, TheOrderOfTheOutputsAndOtherOnesDoNotMatter) {
  std::vector<Tensor> outputs = yolo_v8();
  std::swap(outputs[0], outputs[1]);
  outputs.push_back({"head", {1, 3, 2, 2, 12}, std::vector<float>(144)});
  expect_yolo(decode_yolo_seg(outputs, 3, yolo_placement, {}));
}

TEST(YoloSeg, WhatIsNoNumberIsNoDetection) {
  std::vector<Tensor> outputs = yolo_v8();
  for (float& value : outputs[0].values) value = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(decode_yolo_seg(outputs, 3, yolo_placement, {}).empty());
}

TEST(YoloSeg, ABoxBesideTheImageIsNoDetection) {
  std::vector<Tensor> outputs = yolo_v8();
  for (int i = 0; i < 6; ++i) outputs[0].values[static_cast<std::size_t>(6 + i)] = -50;  // y
  EXPECT_TRUE(decode_yolo_seg(outputs, 3, yolo_placement, {}).empty());
}

/// `count` equal candidates of the only class on one object, and a weaker one elsewhere.
std::vector<Tensor> crowd(int count) {
  Tensor candidates{"output0", {1, 6, count + 1}, {}};
  const float object[] = {8, 8, 8, 8, .875F, 1}, other[] = {24, 24, 8, 8, .5F, 1};
  for (std::size_t row = 0; row < 6; ++row) {
    candidates.values.insert(candidates.values.end(), static_cast<std::size_t>(count), object[row]);
    candidates.values.push_back(other[row]);
  }
  return {candidates, {"output1", {1, 1, 8, 8}, std::vector<float>(64, 1)}};
}

TEST(YoloSeg, ManyCandidatesOnOneObjectLeaveRoomForOthers) {
  const std::vector<Detection> detections = decode_yolo_seg(crowd(400), 1, place({32, 32}, {32, 32}, true), {});
  ASSERT_EQ(detections.size(), 2U);
  EXPECT_EQ(detections[0].region, cv::Rect(4, 4, 8, 8));
  EXPECT_EQ(detections[1].region, cv::Rect(20, 20, 8, 8));
}

TEST(YoloSeg, TheSurestInstancesCount) {
  const std::vector<Detection> detections =
      decode_yolo_seg(crowd(3), 1, place({32, 32}, {32, 32}, true), {.25F, .45F, 1});
  ASSERT_EQ(detections.size(), 1U);
  EXPECT_EQ(detections[0].score, .875F);
}

TEST(YoloSeg, WrongShapesAreNamed) {
  EXPECT_EQ(complaint([] { decode_yolo_seg(yolo_v8(), 80, yolo_placement, {}); }),
            "output 'output0' has shape 1x9x6, expected 1x86xN (YOLOv8, YOLO11) or 1xNx87 (YOLOv5), with 80 classes "
            "and 2 mask coefficients");
  EXPECT_EQ(complaint([] { decode_yolo_seg({yolo_v8()[0]}, 3, yolo_placement, {}); }),
            "has no output of shape 1xKxHxW (the masks' prototypes), only 'output0' 1x9x6");
  EXPECT_EQ(complaint([] { decode_yolo_seg({yolo_v8()[1]}, 3, yolo_placement, {}); }),
            "has no output of shape 1xMxN (boxes, scores and coefficients), only 'output1' 1x2x4x4");
}

TEST(YoloSeg, AMaskIsThatOfThePrototypesAroundItsBoxAlone) {
  const Placement placement = place({32, 32}, {32, 32}, true);
  Tensor prototypes{"output1", {1, 1, 8, 8}, {}};
  cv::Mat values(8, 8, CV_32F);
  cv::RNG random(3);
  random.fill(values, cv::RNG::UNIFORM, -1, 1);
  prototypes.values.assign(values.ptr<float>(), values.ptr<float>() + 64);
  // One candidate: x, y, width, height, the score of the only class, a coefficient of 1.
  const Tensor candidate{"output0", {1, 6, 1}, {18, 21, 9.5F, 13.5F, 1, 1}};
  const std::vector<Detection> detections = decode_yolo_seg({candidate, prototypes}, 1, placement, {});
  ASSERT_EQ(detections.size(), 1U);
  EXPECT_EQ(detections[0].region, cv::Rect(13, 14, 10, 14));
  const cv::Mat expected = sample({values, 0, .25, 0, .25}, detections[0].region, 0);
  EXPECT_EQ(cv::countNonZero(detections[0].mask != expected), 0);
  EXPECT_GT(cv::countNonZero(expected), 0);
}

TEST(Detections, ABoxHasThePixelsWhoseCentreIsInIt) {
  EXPECT_EQ(pixels_in({0, 0, 4, 2}), cv::Rect(0, 0, 4, 2));
  EXPECT_EQ(pixels_in({.4, .6, 3, 2}), cv::Rect(0, 1, 3, 2));
  EXPECT_EQ(pixels_in({.5, .5, 1, 1}), cv::Rect(0, 0, 1, 1));
  EXPECT_TRUE(pixels_in({.6, .6, .3, .3}).empty());
}

TEST(MaskRcnn, Torchvision) {
  // The car's mask without the pixel that is 0.5; the person's inside its box, columns 3 to 7. Below 0.5 and ignored
  // classes do not show. COCO's category 3 is the car, the third of the list.
  const auto detections =
      decode_mask_rcnn(torchvision(), MaskRcnnKind::Torchvision, 90, place({8, 4}, {8, 4}, false), {.5F, .45F, 300});
  const runner::Segmentation s = to_segmentation(detections, coco_categories(), {8, 4});
  EXPECT_EQ(picture(s.ids), (Picture{".22.....", "222111..", "222111..", "222....."}));
  ASSERT_EQ(s.instances.size(), 2U);
  EXPECT_EQ(coco_categories()[static_cast<std::size_t>(s.instances[0].class_id)].name, "person");
  EXPECT_EQ(coco_categories()[static_cast<std::size_t>(s.instances[1].class_id)].name, "car");
  EXPECT_TRUE(s.instances[0].always_dynamic);
  EXPECT_FALSE(s.instances[1].always_dynamic);
}

TEST(MaskRcnn, Detectron2PastesTheMaskIntoTheBox) {
  // Cells of 2x2 pixels. Along each axis the pixels' centres get .75, .75, .25, 0 of the one cell that is 1; over 0.5
  // is the product of the first two. Four cells of 1 give .75, 1, 1, .75, whose product is over 0.5 everywhere.
  const auto detections =
      decode_mask_rcnn(detectron2(), MaskRcnnKind::Detectron2, 80, place({8, 4}, {8, 4}, false), {.5F, .45F, 300});
  const runner::Segmentation s = to_segmentation(detections, coco_classes(), {8, 4});
  EXPECT_EQ(picture(s.ids), (Picture{"22..1111", "22..1111", "....1111", "....1111"}));
  ASSERT_EQ(s.instances.size(), 2U);
  EXPECT_EQ(coco_classes()[static_cast<std::size_t>(s.instances[0].class_id)].name, "person");
  EXPECT_EQ(coco_classes()[static_cast<std::size_t>(s.instances[1].class_id)].name, "car");
}

TEST(MaskRcnn, BoxesAreThoseOfTheInput) {
  // The same network on an image of twice the input's size.
  const auto detections =
      decode_mask_rcnn(detectron2(), MaskRcnnKind::Detectron2, 80, place({16, 8}, {8, 4}, false), {.5F, .45F, 300});
  ASSERT_EQ(detections.size(), 2U);
  EXPECT_EQ(detections[1].region, cv::Rect(8, 0, 8, 8));
  EXPECT_EQ(detections[0].region, cv::Rect(0, 0, 8, 8));
}

TEST(MaskRcnn, NothingFound) {
  std::vector<Tensor> outputs = torchvision();
  for (Tensor& output : outputs) output.shape[0] = 0, output.values.clear();
  EXPECT_TRUE(
      decode_mask_rcnn(outputs, MaskRcnnKind::Torchvision, 90, place({8, 4}, {8, 4}, false), {.5F, .45F, 300}).empty());
}

TEST(MaskRcnn, ABoxWithoutEndIsNoDetection) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const MaskRcnnKind kind : {MaskRcnnKind::Torchvision, MaskRcnnKind::Detectron2})
    for (std::size_t edge = 0; edge < 4; ++edge) {
      std::vector<Tensor> outputs = kind == MaskRcnnKind::Torchvision ? torchvision() : detectron2();
      const auto count = [&] {
        return decode_mask_rcnn(outputs, kind, 90, place({8, 4}, {8, 4}, false), {.5F, .45F, 300}).size();
      };
      const std::size_t before = count();
      outputs[0].values[edge] = edge < 2 ? -infinity : infinity;
      EXPECT_EQ(count(), before - 1) << edge;
    }
}

TEST(MaskRcnn, WrongShapesAreNamed) {
  const auto said = [](std::size_t output, const std::vector<int>& shape, MaskRcnnKind kind) {
    std::vector<Tensor> outputs = kind == MaskRcnnKind::Torchvision ? torchvision() : detectron2();
    outputs[output].shape = shape;
    return complaint([&] { decode_mask_rcnn(outputs, kind, 90, place({8, 4}, {8, 4}, false), {}); });
  };
  EXPECT_EQ(said(0, {4, 5}, MaskRcnnKind::Torchvision), "output 'boxes' has shape 4x5, expected Nx4 (boxes)");
  EXPECT_EQ(said(1, {3}, MaskRcnnKind::Torchvision), "output 'labels' has shape 3, expected 4 (classes)");
  EXPECT_EQ(said(2, {4, 2}, MaskRcnnKind::Torchvision), "output 'scores' has shape 4x2, expected 4 (scores)");
  EXPECT_EQ(said(3, {4, 1, 28, 28}, MaskRcnnKind::Torchvision),
            "output 'masks' has shape 4x1x28x28, expected 4x1x4x8 (torchvision's masks, of the input's size)");
  EXPECT_EQ(said(2, {2, 4}, MaskRcnnKind::Detectron2),
            "output 'pred_masks' has shape 2x4, expected 2x1xhxw (Detectron2's masks of the boxes)");
  EXPECT_EQ(complaint([] { mask_rcnn_kind(3); }),
            "has 3 outputs, expected 4 (torchvision: boxes, labels, scores, masks) or 5 (Detectron2: pred_boxes, "
            "pred_classes, pred_masks, scores, image_size)");
}

TEST(MaskRcnn, AClassBeyondTheListIsNamed) {
  EXPECT_EQ(complaint([] {
              decode_mask_rcnn(torchvision(), MaskRcnnKind::Torchvision, 2, place({8, 4}, {8, 4}, false), {});
            }),
            "output 'labels' has the class 3, expected whole numbers from 1 to 2");
}

TEST(IdImage, CoversTheImageInAnyResolution) {
  const runner::Segmentation s = decode_id_image(ids(), place({8, 4}, {8, 4}, false));
  const cv::Mat expected = (cv::Mat_<std::uint16_t>(4, 8) << 0, 0, 1, 1, 300, 300, 0, 0,  //
                            0, 0, 1, 1, 300, 300, 0, 0,                                   //
                            2, 2, 1, 1, 0, 0, 0, 0,                                       //
                            2, 2, 1, 1, 0, 0, 0, 0);
  EXPECT_EQ(cv::countNonZero(s.ids != expected), 0);
  EXPECT_TRUE(s.instances.empty());
}

TEST(IdImage, WhatIsNoIdIsNamed) {
  const Placement placement = place({8, 4}, {8, 4}, false);
  const auto said = [&](std::vector<Tensor> outputs) {
    return complaint([&] { decode_id_image(outputs, placement); });
  };
  std::vector<Tensor> outputs = ids();
  outputs[0].values[6] = .5F;
  EXPECT_EQ(said(outputs), "output 'ids' is 0.5 at 2, 1, expected whole numbers from 0 to 65535");
  outputs[0].values[6] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(said(outputs), "output 'ids' is nan at 2, 1, expected whole numbers from 0 to 65535");
  outputs = ids();
  outputs[0].shape = {1, 2, 2, 2};
  EXPECT_EQ(said(outputs),
            "output 'ids' has shape 1x2x2x2, expected HxW, 1xHxW or 1x1xHxW, and no other output (an image of ids; "
            "ArgMax, where there are classes, belongs into the network)");
}

TEST(Input, LetterboxKeepsProportions) {
  cv::Mat image(2, 4, CV_8UC3, cv::Scalar(10, 20, 30));
  const Placement p = place(image.size(), {8, 8}, true);
  const Tensor input = make_input(image, p, {true, true, 1});
  ASSERT_EQ(input.shape, (std::vector<int>{1, 3, 8, 8}));
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        EXPECT_EQ(input.values[static_cast<std::size_t>(64 * c + 8 * y + x)],
                  y < 2 || y >= 6 ? 114 : 30 - 10 * c)  // red first
            << c << ' ' << y << ' ' << x;
  EXPECT_EQ(p.to_image(0, 2, 8, 6), cv::Rect2d(0, 0, 4, 2));
  EXPECT_EQ(p.to_image(-9, 3, 4, 99), cv::Rect2d(0, .5, 2, 1.5));
}

TEST(Input, EachValueIsScaledInSinglePrecision) {
  cv::Mat image(16, 16, CV_8UC3);
  for (int i = 0; i < 256; ++i) image.at<cv::Vec3b>(i / 16, i % 16) = cv::Vec3b::all(static_cast<std::uint8_t>(i));
  const Tensor input = make_input(image, place(image.size(), image.size(), false), {});
  // To a few units of the last place: from release to release OpenCV rounds differently.
  for (std::size_t i = 0; i < 3 * 256; ++i)
    EXPECT_FLOAT_EQ(input.values[i], static_cast<float>(i % 256) * static_cast<float>(1 / 255.)) << i;
}

TEST(Input, WithoutLetterboxTheImageFillsIt) {
  const cv::Mat image(2, 4, CV_8UC1, cv::Scalar(51));
  const Tensor input = make_input(image, place(image.size(), {3, 3}, false), {false, false, 1 / 255.});
  ASSERT_EQ(input.shape, (std::vector<int>{1, 3, 3, 3}));
  for (const float value : input.values) EXPECT_FLOAT_EQ(value, .2F);
}

}  // namespace
}  // namespace network::test
