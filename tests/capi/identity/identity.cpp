// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// identity SEQUENCE: labels and track ids of dot::Tracker and of the C library are the same to the last pixel.

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "dot/opencv.hpp"
#include "through_c.h"

namespace {

namespace fs = std::filesystem;

constexpr int frames = 24;     // the whole sample
constexpr int mask_every = 2;  // so that masks are carried on, too
constexpr double units = 256;

cv::Mat read(const fs::path& path, int type) {
  cv::Mat image = cv::imread(path.string(), cv::IMREAD_UNCHANGED);
  if (image.empty() || image.type() != type || !image.isContinuous())
    throw std::runtime_error(path.string() + " is missing or of another type");
  return image;
}

int run(const fs::path& sequence) {
  dot::Intrinsics camera;
  double fps = 0;
  std::ifstream intrinsics(sequence / "intrinsics.txt");
  intrinsics >> camera.fx >> camera.fy >> camera.cx >> camera.cy >> camera.width >> camera.height >> camera.baseline >>
      fps;
  if (!intrinsics) throw std::runtime_error("cannot read " + (sequence / "intrinsics.txt").string());
  dot::Options options;
  options.depth_noise.source = dot::DepthSource::Stereo;
  dot::Tracker tracker(camera, options);

  dot_camera c_camera = DOT_CAMERA_INIT;
  c_camera.width = camera.width;
  c_camera.height = camera.height;
  c_camera.fx = camera.fx;
  c_camera.fy = camera.fy;
  c_camera.cx = camera.cx;
  c_camera.cy = camera.cy;
  c_camera.baseline = camera.baseline;
  dot_options c_options = DOT_OPTIONS_INIT;
  c_options.depth_source = DOT_DEPTH_STEREO;
  dot_tracker* made = nullptr;
  if (dot_create(&c_camera, &c_options, &made) != DOT_OK) throw std::runtime_error(dot_create_error());
  const std::unique_ptr<dot_tracker, void (*)(dot_tracker*)> c_tracker(made, dot_destroy);

  const auto pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  std::vector<std::uint8_t> labels(pixels);
  std::vector<std::uint32_t> ids(pixels);
  int moving = 0, differing = 0;
  for (int i = 0; i < frames; ++i) {
    char name[16];
    std::snprintf(name, sizeof name, "%06d.png", i);
    const cv::Mat image = read(sequence / "rgb" / name, CV_8UC3);
    const cv::Mat depth = read(sequence / "depth" / name, CV_16UC1);
    const cv::Mat masks = read(sequence / "masks" / name, CV_8UC1);
    const bool segmented = i % mask_every == 0;

    dot::Frame frame = dot::make_frame(static_cast<std::uint64_t>(i), i / fps, image, depth, units);
    if (segmented) frame.masks = dot::Masks{dot::id_view(masks), {}};
    const dot::Result& result = tracker.track(frame);
    const cv::Mat cpp_labels = dot::to_mat(result.labels).clone();
    const cv::Mat cpp_ids = dot::to_mat(result.ids).clone();

    if (track_through_c(c_tracker.get(), &c_camera, frame.id, frame.timestamp, image.data,
                        reinterpret_cast<const std::uint16_t*>(depth.data), segmented ? masks.data : nullptr,
                        labels.data(), ids.data()) != 0)
      return 1;
    differing += std::memcmp(cpp_labels.data, labels.data(), pixels) != 0;
    differing += std::memcmp(cpp_ids.data, ids.data(), 4 * pixels) != 0;
    moving += cv::countNonZero(cpp_labels == DOT_STATE_MOVING);
  }
  std::printf("%d frames, %d pixels moving, %d images differ between C++ and C\n", frames, moving, differing);
  return moving > 0 && differing == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: identity SEQUENCE\n"), 2;
  try {
    return run(argv[1]);
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 1;
  }
}
