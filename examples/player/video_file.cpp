// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "video_file.hpp"

#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include "sequence/errors.hpp"

#ifdef DOT_EXAMPLE_VIDEO
#include <fstream>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "video_backend.hpp"
#endif

namespace player {
namespace fs = std::filesystem;

#ifdef DOT_EXAMPLE_VIDEO

namespace {

/// While it is not finished; OpenCV chooses the format by the ending.
fs::path unfinished_name(const fs::path& path) {
  return fs::path(path).replace_extension(".partial" + path.extension().string());
}

/// Encoders of H.264 and MPEG-4 want even sizes.
cv::Mat even(const cv::Mat& picture) {
  if (picture.rows % 2 == 0 && picture.cols % 2 == 0) return picture;
  cv::Mat padded;
  cv::copyMakeBorder(picture, padded, 0, picture.rows % 2, 0, picture.cols % 2, cv::BORDER_REPLICATE);
  return padded;
}

}  // namespace

struct VideoFile::Impl {
  fs::path path;
  double fps;
  cv::VideoWriter writer;
  int pictures = 0;
  bool finished = false;

  fs::path unfinished() const { return unfinished_name(path); }
};

VideoFile::VideoFile(fs::path path, double fps) : impl_(std::make_unique<Impl>(Impl{std::move(path), fps, {}})) {
  std::error_code error;
  if (fs::is_directory(impl_->path, error) || !std::ofstream(impl_->unfinished()))
    throw runner::FileError(impl_->path.string() + ": cannot be written");
}

VideoFile::~VideoFile() {
  if (impl_->finished) return;
  impl_->writer.release();
  std::error_code error;
  fs::remove(impl_->unfinished(), error);
}

void VideoFile::add(const cv::Mat& picture) {
  const cv::Mat padded = even(picture);
  for (const char* const code : {"avc1", "mp4v", "MJPG"}) {
    if (impl_->writer.isOpened()) break;
    impl_->writer.open(impl_->unfinished().string(), cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]),
                       impl_->fps, padded.size());
  }
  if (!impl_->writer.isOpened())
    throw runner::FileError(impl_->path.string() + ": OpenCV has no encoder for a video of this kind and size");
  impl_->writer.write(padded);
  ++impl_->pictures;
}

void VideoFile::finish() {
  impl_->writer.release();
  // The writer does not tell of errors, such as a full disk.
  cv::VideoCapture written(impl_->unfinished().string(), video_backend());
  const int kept = impl_->pictures == 0 ? 0 : static_cast<int>(std::lround(written.get(cv::CAP_PROP_FRAME_COUNT)));
  std::error_code error;
  if (kept == impl_->pictures) fs::rename(impl_->unfinished(), impl_->path, error);
  if (kept != impl_->pictures || error)
    throw runner::FileError(impl_->path.string() + ": cannot be written: " + std::to_string(kept) + " of " +
                            std::to_string(impl_->pictures) + " pictures arrived");
  impl_->finished = true;
}

#else

struct VideoFile::Impl {};

VideoFile::VideoFile(fs::path path, double) {
  throw runner::FileError(path.string() +
                          ": cannot be written: this program was built without OpenCV's module videoio");
}
VideoFile::~VideoFile() = default;
void VideoFile::add(const cv::Mat&) {}
void VideoFile::finish() {}

#endif

}  // namespace player
