// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "sequence/image_source.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/recording_folder.hpp"

namespace {

using Names = std::vector<std::string>;

Names names(const std::filesystem::path& source) {
  Names result;
  for (const auto& file : runner::list_source({}, source).files) result.push_back(file.path.filename().string());
  return result;
}

std::string complaint(const std::filesystem::path& source) {
  try {
    runner::list_source({}, source);
  } catch (const runner::FileError& error) {
    return std::string(error.what()).substr(source.string().size());
  }
  return "none";
}

TEST(ImageSource, NumbersInNamesCountAsSuch) {
  EXPECT_TRUE(runner::natural_less("2.png", "10.png"));
  EXPECT_FALSE(runner::natural_less("10.png", "2.png"));
  EXPECT_TRUE(runner::natural_less("a2b10", "a2b11"));
  EXPECT_TRUE(runner::natural_less("9", "a"));
  EXPECT_TRUE(runner::natural_less("01.png", "1.png") != runner::natural_less("1.png", "01.png"));
  EXPECT_FALSE(runner::natural_less("x1", "x1"));
  EXPECT_TRUE(runner::natural_less("1305031102.175304", "1305031102.211214"));
}

TEST(ImageSource, AFolder) {
  const RecordingFolder folder;
  for (const char* const name : {"cam/img10.png", "cam/img9.JPG", "cam/img1.bmp", "cam/notes.txt", "cam/img2"})
    folder.text(name, "");
  EXPECT_EQ(names(folder.path() / "cam"), (Names{"img1.bmp", "img9.JPG", "img10.png"}));
  EXPECT_FALSE(runner::list_source(folder.path(), "cam").numbered);
  folder.text("empty/notes.txt", "");
  EXPECT_EQ(complaint(folder.path() / "empty"), ": holds no images");
  EXPECT_THROW(names(folder.path() / "none"), runner::FileError);
}

TEST(ImageSource, APattern) {
  const RecordingFolder folder;
  for (const char* const name : {"l/left_0002.png", "l/left_0010.png", "l/left_10000.png", "l/left_3.png",
                                 "l/left_00004.png", "l/right_0002.png", "l/left_0002.png.partial", "l/left_.png"})
    folder.text(name, "");
  EXPECT_EQ(names(folder.path() / "l/left_%04d.png"), (Names{"left_0002.png", "left_0010.png", "left_10000.png"}));
  EXPECT_EQ(names(folder.path() / "l/left_%d.png"), (Names{"left_3.png", "left_10000.png"}));
  const runner::ImageSource source = runner::list_source(folder.path(), "l/left_%04d.png");
  EXPECT_TRUE(source.numbered);
  EXPECT_EQ(source.files[1].number, 10);
  EXPECT_EQ(complaint(folder.path() / "l/middle_%04d.png"), ": there are no such files");
  for (const char* const wrong :
       {"l/%s.png", "l/%", "l/%04", "l/%d_%d.png", "l_%d/x.png", "l/%04x.png", "l/%1234d.png"})
    EXPECT_EQ(complaint(folder.path() / wrong), ": a pattern must have one %d, or %06d or alike, in its last part")
        << wrong;
}

}  // namespace
