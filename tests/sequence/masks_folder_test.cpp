// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "sequence/sequence.hpp"
#include "support/recording_folder.hpp"

namespace {

namespace fs = std::filesystem;

/// Two frames with depth; what of masks there is, a test adds.
void write_frames(const RecordingFolder& folder) {
  for (const char* const name : {"000000.png", "000001.png"}) {
    folder.image(std::string("rgb/") + name);
    folder.image(std::string("depth/") + name, CV_16UC1, 512);
  }
  folder.text("intrinsics.txt", "10 10 2.5 1.5 6 4 0.5 10\n");
}

TEST(MasksFolder, NoneIsNoError) {
  const RecordingFolder folder;
  write_frames(folder);
  EXPECT_EQ(folder.complaint(), "");
  EXPECT_TRUE(folder.open().entries[0].masks.empty());
}

TEST(MasksFolder, IsNotLookedAtWhereNoneAreAskedFor) {
  const RecordingFolder folder;
  write_frames(folder);
  folder.text("masks/notes.txt", "no mask of any frame");
  runner::SequenceOptions options = folder.options();
  options.masks = false;
  EXPECT_TRUE(runner::open_recording(options).entries[0].masks.empty());
}

TEST(MasksFolder, AFileInItsPlaceIsAnError) {
  const RecordingFolder folder;
  write_frames(folder);
  folder.text("masks", "not a folder");
  EXPECT_EQ(folder.complaint(), (folder.path() / "masks").string() + ": the folder cannot be read: Not a directory");
}

TEST(MasksFolder, ALinkThatLeadsNowhereIsAnError) {
  const RecordingFolder folder;
  write_frames(folder);
  fs::create_directory_symlink(folder.path() / "none", folder.path() / "masks");
  EXPECT_NE(folder.complaint().find("masks: the folder cannot be read"), std::string::npos) << folder.complaint();
  fs::remove(folder.path() / "masks");
  fs::create_directory_symlink("masks", folder.path() / "masks");
  EXPECT_NE(folder.complaint().find("masks: the folder cannot be read"), std::string::npos) << folder.complaint();
}

TEST(MasksFolder, WithNoMaskOfAnyFrameIsAnError) {
  const RecordingFolder folder;
  write_frames(folder);
  const std::string complaint =
      (folder.path() / "masks").string() + ": holds no masks of these frames, such as 000000.png";
  fs::create_directory(folder.path() / "masks");
  EXPECT_EQ(folder.complaint(), complaint);
  folder.image("masks/mask_0.png", CV_8UC1, 1);
  EXPECT_EQ(folder.complaint(), complaint);
  folder.image("masks/000001.png", CV_8UC1, 1);
  EXPECT_EQ(folder.complaint(), "");
}

TEST(MasksFolder, NamedByTheUserMustBeThere) {
  const RecordingFolder folder;
  write_frames(folder);
  runner::SequenceOptions options = folder.options();
  options.mask_dir = "network";
  EXPECT_THROW(runner::open_recording(options), runner::FileError);
  folder.text("network", "not a folder");
  EXPECT_THROW(runner::open_recording(options), runner::FileError);
}

TEST(MasksFolder, AnImageThatDoesNotDecodeIsAnError) {
  const RecordingFolder folder;
  write_frames(folder);
  folder.text("masks/000001.png", "not an image");
  runner::Sequence sequence(folder.options());
  EXPECT_TRUE(sequence.read(0).ids.empty());
  EXPECT_THROW(sequence.read(1), runner::FileError);
}

}  // namespace
