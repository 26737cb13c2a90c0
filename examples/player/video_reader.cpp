// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "video_reader.hpp"

#include <optional>
#include <string>
#include <utility>

#include "sequence/errors.hpp"

#ifdef DOT_EXAMPLE_VIDEO
#include <opencv2/videoio.hpp>

#include "video_backend.hpp"
#endif

namespace player {
namespace fs = std::filesystem;

#ifdef DOT_EXAMPLE_VIDEO

namespace {

class VideoReader : public runner::VideoInput {
 public:
  explicit VideoReader(fs::path path) : path_(std::move(path)) {
    open();
    // What a file says of the number of its frames need not be true, nor are its frames always evenly spaced.
    while (capture_.grab()) {
      double seconds = capture_.get(cv::CAP_PROP_POS_MSEC) / 1000;
      if (!times_.empty() && !(seconds > times_.back())) seconds = times_.back() + step();
      times_.push_back(seconds);
    }
    if (times_.empty()) throw runner::FileError(path_.string() + ": the video has no frames that can be read");
    open();
  }

  const std::vector<double>& times() const override { return times_; }

  cv::Mat read(int index) override {
    if (index < next_) open();
    cv::Mat image;
    for (; next_ < index; ++next_)
      if (!capture_.grab()) fail(next_);
    if (!capture_.read(image) || image.empty()) fail(index);
    ++next_;
    return image.clone();  // the capture keeps its own
  }

 private:
  void open() {
    next_ = 0;
    if (!capture_.open(path_.string(), video_backend()))
      throw runner::FileError(path_.string() + ": not a readable video");
    capture_.set(cv::CAP_PROP_CONVERT_RGB, is_16_bit() ? 0 : 1);
  }

  /// Whether its frames have 16 bits, as those of a depth camera. OpenCV turns these into 8-bit colours, unless it is
  /// told not to convert. Then, however, it may give the planes of a colour video as they are stored.
  bool is_16_bit() {
    if (is_16_bit_) return *is_16_bit_;
    cv::VideoCapture raw(path_.string(), video_backend());
    raw.set(cv::CAP_PROP_CONVERT_RGB, 0);
    cv::Mat image;
    is_16_bit_ = raw.read(image) && image.depth() == CV_16U;
    return *is_16_bit_;
  }

  double step() const {
    const double fps = capture_.get(cv::CAP_PROP_FPS);
    return fps > 0 ? 1 / fps : 1.0 / 30;
  }

  [[noreturn]] void fail(int index) const {
    throw runner::FileError(path_.string() + ": frame " + std::to_string(index) + " cannot be read");
  }

  fs::path path_;
  cv::VideoCapture capture_;
  std::vector<double> times_;
  int next_ = 0;
  std::optional<bool> is_16_bit_;
};

}  // namespace

std::unique_ptr<runner::VideoInput> open_video(const fs::path& path) { return std::make_unique<VideoReader>(path); }

#else

std::unique_ptr<runner::VideoInput> open_video(const fs::path& path) {
  throw runner::FileError(path.string() +
                          ": this program was built without OpenCV's videoio (Debian: libopencv-videoio-dev)");
}

#endif

}  // namespace player
