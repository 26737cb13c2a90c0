// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// What becomes of a frame's sparse depth: the interpolated depth, and the points that the camera's motion is measured
// with, chosen in it and, to compare, in the measurements alone. For bench/sparse/pictures.py.
//
//     bench_sparse_points SEQUENCE FRAME OUT    writes OUT/depth.png (16 bit, 1/256 m), OUT/points.csv and
//                                               OUT/points_measured.csv (column, row, depth in metres)
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "dot/dot.hpp"
#include "dot/frame/frame_store.hpp"
#include "run/run_options.hpp"
#include "sequence/sequence.hpp"

namespace {

void write_depth(const std::filesystem::path& path, const dot::Image<float>& inverse_depth) {
  cv::Mat depth(inverse_depth.height(), inverse_depth.width(), CV_16U, cv::Scalar(0));
  for (int y = 0; y < depth.rows; ++y)
    for (int x = 0; x < depth.cols; ++x)
      if (const float q = inverse_depth(x, y); q > 0) depth.at<ushort>(y, x) = cv::saturate_cast<ushort>(256 / q);
  if (!cv::imwrite(path, depth)) throw std::runtime_error("cannot write " + path.string());
}

/// Chooses the background's points as the pipeline does, objects included.
void write_points(const std::filesystem::path& path, const dot::FrameData& frame,
                  const dot::Image<float>& inverse_depth, const dot::Pinhole& camera, const dot::DepthNoise& noise,
                  const dot::SelectionSettings& settings) {
  dot::SelectionWorkspace workspace;
  const dot::Selector<dot::Pinhole, dot::DepthNoise> select{camera,   noise,    frame.pyramid, inverse_depth.view(),
                                                            settings, workspace};
  dot::PointSet points;
  select({{0, 0, camera.width(), camera.height()},
          {},
          inverse_depth.view(),
          settings.background_points,
          settings.window_radius,
          settings.min_gradient},
         points);
  std::ofstream file(path);
  for (std::size_t i = 0; i < points.u.size(); ++i)
    file << points.u[i] << ',' << points.v[i] << ',' << 1 / points.q[i] << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

void run(const char* folder, const char* number, const std::filesystem::path& out) {
  runner::RunOptions run;
  run.sequence.folder = folder;
  runner::Sequence sequence(run.sequence);
  const dot::Options options = runner::tracker_options(run, sequence.depth_source());
  const dot::Pinhole camera(sequence.intrinsics());
  const dot::DepthNoise noise(options.depth_noise, sequence.intrinsics());
  char* end = nullptr;
  const long index = std::strtol(number, &end, 10);
  if (end == number || *end != 0 || index < 0 || index >= sequence.size())
    throw std::invalid_argument("FRAME must be 0 to " + std::to_string(sequence.size() - 1));
  const runner::SequenceFrame read = sequence.read(static_cast<int>(index));
  const dot::Frame frame = read.frame();
  const dot::FrameStore::Settings settings{options.align.max_levels, options.selection.max_depth};
  const dot::kernel::Kernels& kernels = dot::portable_kernels();

  dot::FrameStore store;
  const dot::FramePtr data = store.add(frame, {}, noise, settings, kernels, dot::Threads{});
  dot::Image<float> measured(camera.width(), camera.height());
  dot::InverseDepthRows rows(frame.depth, settings.max_depth, kernels);
  for (int y = 0; y < camera.height(); ++y) rows(y, measured.row(y));

  std::filesystem::create_directories(out);
  write_depth(out / "depth.png", data->inverse_depth());
  write_points(out / "points.csv", *data, data->inverse_depth(), camera, noise, options.selection);
  write_points(out / "points_measured.csv", *data, measured, camera, noise, options.selection);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: bench_sparse_points SEQUENCE FRAME OUT\n");
    return 1;
  }
  try {
    run(argv[1], argv[2], argv[3]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_sparse_points: %s\n", error.what());
    return 1;
  }
}
