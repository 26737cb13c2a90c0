// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "sequence/coco_masks.hpp"
#include "sequence/coco_shapes.hpp"
#include "sequence/sequence.hpp"
#include "support/recording_folder.hpp"

namespace {

using std::string_literals::operator""s;
using Lengths = std::vector<std::int64_t>;

/// Rows of an image, a digit a pixel.
std::string picture(const cv::Mat& ids) {
  std::string text;
  for (int y = 0; y < ids.rows; ++y) {
    for (int x = 0; x < ids.cols; ++x) text += std::to_string(ids.at<std::uint16_t>(y, x));
    text += '/';
  }
  return text;
}

cv::Mat blank() { return cv::Mat::zeros(4, 6, CV_16UC1); }

TEST(CocoRuns, CountDownTheColumns) {
  // Five pixels outside are the first column of four and the first pixel of the second; then three inside, and so on.
  cv::Mat ids = blank();
  runner::paint_runs({5, 3, 1, 2, 13}, 7, ids);
  EXPECT_EQ(picture(ids), "000000/077000/077000/070000/");
}

TEST(CocoRuns, Compressed) {
  // By hand from the format. 5 is one group, '5'. 3: '3'. 1: '1'. From the fourth on differences to the one before the
  // last: 2 - 3 = -1 is the group 31, character 79, 'O'; 13 - 1 = 12: '<'.
  EXPECT_EQ(runner::decode_run_lengths("531O<"), (Lengths{5, 3, 1, 2, 13}));
  // 16 needs a second group, or its own highest bit would be its sign: 16 + more, 0. 100 = 3 * 32 + 4. 15 does not.
  EXPECT_EQ(runner::decode_run_lengths("`0"), (Lengths{16}));
  EXPECT_EQ(runner::decode_run_lengths("T3"), (Lengths{100}));
  EXPECT_EQ(runner::decode_run_lengths("?"), (Lengths{15}));
  // -17 = -32 + 15: the groups 15 + more and 31.
  EXPECT_EQ(runner::decode_run_lengths("0T30_O"), (Lengths{0, 100, 0, 83}));
  EXPECT_EQ(runner::decode_run_lengths(""), Lengths{});
}

TEST(CocoRuns, DamagedOnesAreRefused) {
  for (const char* const wrong : {"T", "5 3", "\x7F", "ooooooooo0"})
    EXPECT_THROW(runner::decode_run_lengths(wrong), std::invalid_argument) << wrong;
  cv::Mat ids = blank();
  for (const Lengths& wrong :
       {Lengths{}, Lengths{23}, Lengths{25}, Lengths{-1, 25}, Lengths{24, 1}, Lengths{1LL << 60, 3}})
    EXPECT_THROW(runner::paint_runs(wrong, 1, ids), std::invalid_argument);
  EXPECT_EQ(cv::countNonZero(ids), 0) << "what is refused leaves nothing";
}

TEST(CocoPolygon, CoversTheCentresOfItsPixels) {
  cv::Mat square = blank();
  runner::paint_polygon({1, 1, 4, 1, 4, 3, 1, 3}, 1, square);
  EXPECT_EQ(picture(square), "000000/011100/011100/000000/");
  cv::Mat triangle = blank();
  runner::paint_polygon({0, 0, 4, 0, 0, 4}, 2, triangle);
  EXPECT_EQ(picture(triangle), "222000/220000/200000/000000/") << "centres on the slanting edge do not count";
  cv::Mat half = blank();
  runner::paint_polygon({0.4, 0.4, 1.6, 0.4, 1.6, 1.6, 0.4, 1.6}, 3, half);
  EXPECT_EQ(picture(half), "330000/330000/000000/000000/");
}

TEST(CocoPolygon, MayLeaveTheImage) {
  cv::Mat ids = blank();
  runner::paint_polygon({-10, -10, 2, -10, 2, 100, -10, 100}, 1, ids);
  EXPECT_EQ(picture(ids), "110000/110000/110000/110000/");
  runner::paint_polygon({1e30, 0, 2e30, 0, 2e30, 4}, 2, ids);
  EXPECT_EQ(picture(ids), "110000/110000/110000/110000/");
  EXPECT_THROW(runner::paint_polygon({0, 0, 1, 1}, 1, ids), std::invalid_argument);
  EXPECT_THROW(runner::paint_polygon({0, 0, 1, 1, 2, 2, 3}, 1, ids), std::invalid_argument);
}

const std::string images =
    R"("images": [{"id": 10, "file_name": "rgb/000000.jpg"}, {"id": 11, "file_name": "000001.png"}])";
const std::string categories = R"("categories": [{"id": 1, "name": "person"}, {"id": 3, "name": "car"}])";

std::string document(const std::string& annotations) {
  return "{" + images + ", " + categories + ", \"annotations\": [" + annotations + "]}";
}

const std::string square =
    R"({"id": 5, "image_id": 11, "category_id": 3, "segmentation": [[0, 0, 3, 0, 3, 2, 0, 2], [5, 3, 6, 3, 6, 4, 5, 4]]})";
const std::string runs =
    R"({"id": 6, "image_id": 11, "category_id": 1, "score": 0.5, "segmentation": {"size": [4, 6], "counts": [8, 2, 14]}})";
const std::string compressed =
    R"({"image_id": 11, "category_id": 1, "score": 0.75, "iscrowd": 0, "segmentation": {"size": [4, 6], "counts": "531O<"}})";

TEST(CocoMasks, OfOneImage) {
  const RecordingFolder folder;
  folder.text("coco.json", document(square + ", " + compressed + ", " + runs));
  const runner::CocoMasks coco(folder.path() / "coco.json");
  EXPECT_TRUE(coco.has("000000.png"));
  EXPECT_TRUE(coco.has("000001.png"));
  EXPECT_FALSE(coco.has("000002.png"));
  const runner::Segmentation masks = coco.read("000001.png", {6, 4}, {"person", "7"});
  // By score: the runs (1), the compressed ones (2), the square (3), whose score is that of an annotation, 1.
  EXPECT_EQ(picture(masks.ids), "333000/333000/022000/020003/");
  ASSERT_EQ(masks.instances.size(), 3U);
  EXPECT_EQ(masks.instances[0].class_id, 1);
  EXPECT_FLOAT_EQ(masks.instances[0].score, 0.5F);
  EXPECT_TRUE(masks.instances[0].always_dynamic);
  EXPECT_EQ(masks.instances[2].class_id, 3);
  EXPECT_FALSE(masks.instances[2].always_dynamic);
  EXPECT_TRUE(coco.read("000001.png", {6, 4}, {"3"}).instances[2].always_dynamic);
  // An image without annotations was segmented, and nothing was found.
  EXPECT_EQ(cv::countNonZero(coco.read("000000.png", {6, 4}, {}).ids), 0);
}

TEST(CocoMasks, CrowdsAreNoInstances) {
  const RecordingFolder folder;
  folder.text("coco.json",
              document(R"({"image_id": 10, "iscrowd": 1, "segmentation": {"size": [4, 6], "counts": [0, 24]}})"));
  EXPECT_TRUE(runner::CocoMasks(folder.path() / "coco.json").read("000000.png", {6, 4}, {}).instances.empty());
}

TEST(CocoMasks, WhatIsWrongIsNamed) {
  const RecordingFolder folder;
  const auto complaint = [&](const std::string& text) {
    folder.text("coco.json", text);
    try {
      runner::CocoMasks(folder.path() / "coco.json").read("000001.png", {6, 4}, {});
    } catch (const runner::FileError& error) {
      return std::string(error.what()).substr((folder.path() / "coco.json").string().size());
    }
    return "none"s;
  };
  ASSERT_EQ(complaint(document(square)), "none");
  EXPECT_EQ(complaint("[]"), ": is not an object with images and annotations, as COCO's format has them");
  EXPECT_EQ(complaint("{}"), ": has no list 'images': COCO's format has images, annotations, categories");
  EXPECT_EQ(complaint("{" + images + "}"),
            ": has no list 'annotations': COCO's format has images, annotations, categories");
  EXPECT_EQ(complaint(R"({"images": [{"id": 1, "file_name": "a.png"}, {"id": 2, "file_name": "b/a.jpg"}]})"),
            ": images[1]: 'b/a.jpg' is named as another image");
  EXPECT_EQ(complaint(R"({"images": [{"id": 1, "file_name": "a.png"}, {"id": 1, "file_name": "b.png"}]})"),
            ": images[1]: has the id of another image");
  EXPECT_EQ(complaint(R"({"images": [{"id": "x", "file_name": "a.png"}]})"), ": images[0]: id is of a wrong type");
  EXPECT_EQ(complaint(document(R"({"image_id": 12})")), ": annotations[0]: image_id is that of no image");
  EXPECT_EQ(complaint(document(R"({"image_id": 11})")), ": annotations[0]: has no segmentation");
  EXPECT_EQ(complaint(document(R"({"image_id": 11, "segmentation": {"counts": [24]}})")),
            ": annotations[0]: segmentation has no size [height, width]");
  EXPECT_EQ(complaint(document(R"({"image_id": 11, "segmentation": {"size": [4, 6]}})")),
            ": annotations[0]: segmentation has no counts");
  EXPECT_EQ(complaint(document(R"({"image_id": 11, "segmentation": {"size": [4, 6], "counts": [1.5]}})")),
            ": annotations[0]: segmentation has counts that are no numbers of pixels");
  EXPECT_EQ(complaint(document(R"({"image_id": 11, "segmentation": [["a"]]})")),
            ": annotations[0]: segmentation has what is not a number");
  EXPECT_EQ(complaint(document(
                R"({"image_id": 11, "segmentation": [[1e200, 1e308, 300, 1e308, 300, -1e308], [0, 0, 1, 0, 0, 1]]})")),
            ": annotations[0]: segmentation has a corner over 1e6 pixels away");
  EXPECT_EQ(complaint(document(R"({"id": 8, "image_id": 11, "segmentation": [[1, 2]]})")),
            ": annotation 8 of 000001.png: a polygon needs x and y of three corners or more");
  EXPECT_EQ(complaint(document(R"({"id": 8, "image_id": 11, "segmentation": {"size": [6, 4], "counts": [24]}})")),
            ": annotation 8 of 000001.png: is of an image of 4x6, the camera is 6x4");
  EXPECT_EQ(complaint(document(R"({"id": 8, "image_id": 11, "segmentation": {"size": [4, 6], "counts": "53"}})")),
            ": annotation 8 of 000001.png: the run lengths do not fill the image");
}

TEST(CocoMasks, OfAnotherSizeAreRefused) {
  const RecordingFolder folder;
  const auto read = [&](const std::string& size) {
    folder.text("coco.json", R"({"images": [{"id": 11, "file_name": "000001.png", )" + size + "}], \"annotations\": [" +
                                 square + "]}");
    return runner::CocoMasks(folder.path() / "coco.json").read("000001.png", {6, 4}, {}).instances.size();
  };
  EXPECT_EQ(read(R"("width": 6, "height": 4)"), 1U);
  EXPECT_EQ(read(R"("width": 6)"), 1U) << "half a size says nothing";
  for (const char* const other :
       {R"("width": 12, "height": 8)", R"("width": 0, "height": 0.5)", R"("width": 1, "height": "4")"})
    EXPECT_THROW(read(other), runner::FileError) << other;
  try {
    read(R"("width": 12, "height": 8)");
  } catch (const runner::FileError& error) {
    EXPECT_NE(std::string(error.what()).find("coco.json: 000001.png is an image of 12x8, the camera is 6x4"),
              std::string::npos)
        << error.what();
  }
}

TEST(CocoMasks, InARecording) {
  const RecordingFolder folder;
  for (const char* const name : {"000000.png", "000001.png", "000002.png"}) {
    folder.image("rgb/"s + name);
    folder.image("depth/"s + name, CV_16UC1, 512);
  }
  folder.text("intrinsics.txt", "36 36 2.5 1.5 6 4 0.5 10\n");
  folder.text("coco.json", document(square));
  runner::SequenceOptions options = folder.options();
  options.mask_dir = "coco.json";
  runner::Sequence sequence(options);
  const runner::SequenceFrame first = sequence.read(0), second = sequence.read(1), third = sequence.read(2);
  EXPECT_FALSE(first.ids.empty());
  EXPECT_EQ(cv::countNonZero(first.ids), 0);
  EXPECT_EQ(picture(second.ids), "111000/111000/000000/000001/");
  EXPECT_EQ(second.instances.size(), 1U);
  EXPECT_TRUE(third.ids.empty()) << "was not segmented";

  folder.text("coco.json", R"({"images": [{"id": 1, "file_name": "a.png"}], "annotations": []})");
  try {
    runner::Sequence{options};
    ADD_FAILURE() << "a file without these frames is taken";
  } catch (const runner::FileError& error) {
    EXPECT_NE(std::string(error.what()).find("has no image of these frames, such as 000000.png"), std::string::npos);
  }
}

}  // namespace
