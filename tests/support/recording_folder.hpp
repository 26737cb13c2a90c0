// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "sequence/errors.hpp"
#include "sequence/layouts.hpp"

/// A folder of a test's own, with the few files that the test puts there; removed at the end.
class RecordingFolder {
 public:
  /// @param name of the recording's folder, which stands in one of the test's.
  explicit RecordingFolder(const std::string& name = "recording") {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    root_ =
        std::filesystem::temp_directory_path() / (std::string("dot_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::remove_all(root_);
    path_ = root_ / name;
    std::filesystem::create_directories(path_);
  }
  ~RecordingFolder() {
    std::error_code error;
    std::filesystem::remove_all(root_, error);
  }
  RecordingFolder(const RecordingFolder&) = delete;
  RecordingFolder& operator=(const RecordingFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  void text(const std::string& name, const std::string& content) const { std::ofstream(place(name)) << content; }

  /// An image of one value.
  void image(const std::string& name, int type = CV_8UC1, double value = 0) const {
    cv::imwrite(place(name).string(), cv::Mat(4, 6, type, cv::Scalar::all(value)));
  }

  runner::SequenceOptions options() const {
    runner::SequenceOptions options;
    options.folder = path_;
    options.truth = true;
    return options;
  }
  runner::Recording open() const { return runner::open_recording(options()); }

  /// What the FileError says that opening the recording throws; empty if it throws none.
  std::string complaint() const {
    try {
      open();
    } catch (const runner::FileError& error) {
      return error.what();
    }
    return {};
  }

 private:
  std::filesystem::path place(const std::string& name) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    return file;
  }

  std::filesystem::path root_;
  std::filesystem::path path_;
};
