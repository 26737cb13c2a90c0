// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "player/player.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "support/recording_folder.hpp"
#include "wall.hpp"

namespace player {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

RunInfo info(const std::string& name = "street") { return {name, camera, {}}; }

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++found;
  return found;
}

/// The bytes of the first picture in a page.
std::vector<std::uint8_t> first_picture(const std::string& page) {
  const std::string begin = "<script type=\"text/plain\" class=\"jpeg\">";
  const std::size_t from = page.find(begin) + begin.size();
  const std::string text = page.substr(from, page.find('<', from) - from);
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    group = group << 6 | static_cast<std::uint32_t>(digits.find(c));
    bits += 6;
    if (bits >= 8) bytes.push_back(static_cast<std::uint8_t>(group >> (bits -= 8) & 255U));
  }
  return bytes;
}

TEST(Player, HasItsNameWhenItIsFinished) {
  const RecordingFolder folder;
  const fs::path path = folder.path() / "run.html";
  Player player(path, info());
  const HandMadeResult nothing(frame_size);
  player.add(wall(0), nothing.result(), 1);
  EXPECT_FALSE(fs::exists(path));
  player.finish();
  EXPECT_TRUE(fs::exists(path));
  EXPECT_FALSE(fs::exists(runner::partial_name(path)));
}

TEST(Player, StoppedInTheMiddleLeavesNothing) {
  const RecordingFolder folder;
  const fs::path path = folder.path() / "run.html";
  folder.text("run.html", "of an earlier run");
  {
    Player player(path, info());
    player.add(wall(0), HandMadeResult(frame_size).result(), 1);
  }
  EXPECT_EQ(content(path), "of an earlier run");
  EXPECT_FALSE(fs::exists(runner::partial_name(path)));
}

TEST(Player, SaysWhatCannotBeWritten) {
  const RecordingFolder folder;
  EXPECT_THROW(Player(folder.path() / "none" / "run.html", info()), runner::FileError);
  fs::create_directory(folder.path() / "folder.html");
  EXPECT_THROW(Player(folder.path() / "folder.html", info()), runner::FileError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "nothing is left";
}

TEST(Player, IsOnePageThatLoadsNothing) {
  const RecordingFolder folder;
  const fs::path path = folder.path() / "run.html";
  Player player(path, info());
  for (int i = 0; i < 3; ++i) player.add(wall(i), HandMadeResult(frame_size).result(), 1);
  player.finish();
  const std::string page = content(path);
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
  EXPECT_EQ(count(page, "class=\"frame\""), 3);
  EXPECT_EQ(count(page, "class=\"jpeg\""), 3);
  EXPECT_EQ(count(page, "http"), 2) << "http-equiv, and the name of SVG's namespace, which is not loaded";
  EXPECT_EQ(count(page, "http://www.w3.org/2000/svg"), 1);
  for (const char* marker : {"<!-- title -->", "/* style */", "<!-- frames -->", "/* script */"})
    EXPECT_EQ(count(page, marker), 0) << marker;
}

TEST(Player, ThePictureIsTheFrame) {
  const RecordingFolder folder;
  const fs::path path = folder.path() / "run.html";
  Player player(path, info());
  runner::SequenceFrame frame = wall(0);
  frame.image = cv::Mat(frame_size, CV_8UC4, cv::Scalar(200, 100, 30, 255));
  player.add(frame, HandMadeResult(frame_size).result(), 1);
  player.finish();
  const cv::Mat picture = cv::imdecode(first_picture(content(path)), cv::IMREAD_COLOR);
  ASSERT_EQ(picture.size(), frame_size);
  const cv::Scalar mean = cv::mean(picture);
  EXPECT_NEAR(mean[0], 200, 3);
  EXPECT_NEAR(mean[1], 100, 3);
  EXPECT_NEAR(mean[2], 30, 3);
}

TEST(Player, WithoutFrames) {
  const RecordingFolder folder;
  Player player(folder.path() / "run.html", info());
  player.finish();
  EXPECT_EQ(count(content(folder.path() / "run.html"), "class=\"frame\""), 0);
}

TEST(Player, NamesAreEscaped) {
  const RecordingFolder folder;
  Player player(folder.path() / "run.html", info("</title></script><script>alert(1)</script>"));
  player.finish();
  const std::string page = content(folder.path() / "run.html");
  EXPECT_EQ(count(page, "<script>alert"), 0);
  EXPECT_EQ(count(page, "<title>&lt;/title&gt;"), 1);
  EXPECT_EQ(count(page, "{\"sequence\":\"\\u003c/title>"), 1);
}

TEST(Player, HasTheNamesOfTheClasses) {
  const RecordingFolder folder;
  const fs::path path = folder.path() / "run.html";
  RunInfo with_names = info();
  with_names.class_names = {"person", "<car>"};
  Player player(path, with_names);
  player.finish();
  EXPECT_EQ(count(content(path), R"("classNames":["person","\u003ccar>"])"), 1);
}

TEST(Player, LargePicturesAreMadeSmaller) {
  const RecordingFolder folder;
  dot::Intrinsics large = camera;
  large.width = 2560;
  large.height = 64;
  Player player(folder.path() / "run.html", {"large", large, {}});
  runner::SequenceFrame frame = wall(0);
  cv::resize(frame.image, frame.image, {2560, 64});
  cv::resize(frame.depth, frame.depth, {2560, 64});
  player.add(frame, HandMadeResult({2560, 64}).result(), 1);
  player.finish();
  EXPECT_EQ(cv::imdecode(first_picture(content(folder.path() / "run.html")), cv::IMREAD_COLOR).size(),
            cv::Size(1280, 32));
}

}  // namespace
}  // namespace player
