// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// A feature-based front-end as a SLAM system has it, before and after it learns what moves: how many of its features
/// lie on moving cars, how many on parked ones. What a host adds are the lines of `exclusion_of`. usage: example_host
/// SEQUENCE [PICTURE.png]      (try examples/data/mini)

#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "dot/opencv.hpp"
#include "sequence/sequence.hpp"
#include "slam_masks/features.hpp"

namespace {

constexpr int budget = 1000;  // features a frame

/// The ten lines: a frame goes in, what no feature may be taken from comes out.
cv::Mat exclusion_of(dot::Tracker& tracker, const runner::SequenceFrame& in) {
  dot::Frame frame = dot::make_frame(static_cast<std::uint64_t>(in.number), in.timestamp, in.image, in.depth,
                                     in.depth_units_per_metre);
  if (!in.ids.empty()) frame.masks = dot::Masks{dot::id_view(in.ids), {}};  // as often as the network is done
  const dot::Result& result = tracker.track(frame);
  if (dot::masked_share(result) > 0.5) std::fprintf(stderr, "frame %d: half of the image is masked\n", in.number);
  return dot::exclusion_mask(result);
}

/// Where features lie, by what the recording knows to be true.
struct Count {
  int all = 0;
  int on_movers = 0;
  int on_parked = 0;
};

Count count(const slam::Features& features, const cv::Mat& instances,
            const std::map<int, runner::TrueObject>& objects) {
  Count out;
  for (const cv::Point2f& pixel : features.pixels) {
    ++out.all;
    const auto object = objects.find(instances.at<int>(cv::Point(pixel)));
    if (object != objects.end()) ++(object->second.moving ? out.on_movers : out.on_parked);
  }
  return out;
}

void add(Count& sum, const Count& frame) {
  sum.all += frame.all;
  sum.on_movers += frame.on_movers;
  sum.on_parked += frame.on_parked;
}

/// The frame with what is excluded in red, features that went with it as crosses, and those that are used in green.
cv::Mat draw(const cv::Mat& image, const cv::Mat& exclude, const slam::Features& before, const slam::Features& after) {
  constexpr int zoom = 2;
  cv::Mat picture, area;
  cv::resize(image, picture, {}, zoom, zoom, cv::INTER_CUBIC);
  cv::resize(exclude, area, {}, zoom, zoom, cv::INTER_NEAREST);
  cv::Mat red(picture.size(), picture.type(), cv::Scalar(40, 40, 230)), tinted;
  cv::addWeighted(picture, 0.6, red, 0.4, 0, tinted);
  tinted.copyTo(picture, area);
  for (const cv::Point2f& pixel : after.pixels) cv::circle(picture, pixel * zoom, 2, {80, 230, 80}, 1, cv::LINE_AA);
  for (const cv::Point2f& pixel : before.pixels)
    if (exclude.at<std::uint8_t>(cv::Point(pixel)) != 0)
      cv::drawMarker(picture, pixel * zoom, {255, 255, 255}, cv::MARKER_TILTED_CROSS, 6, 1, cv::LINE_AA);
  return picture;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2 || argc > 3) return std::fprintf(stderr, "usage: %s SEQUENCE [PICTURE.png]\n", argv[0]), 2;
  runner::SequenceOptions where;
  where.folder = argv[1];
  where.truth = true;  // for the counts alone
  runner::Sequence sequence(where);

  dot::Options options;
  options.depth_noise.source = sequence.depth_source();
  dot::Tracker tracker(sequence.intrinsics(), options);
  slam::FeatureExtractor extractor(budget);
  Count without, with;
  int most_on_movers = -1;
  cv::Mat picture;

  for (int i = 0; i < sequence.size(); ++i) {
    const runner::SequenceFrame frame = sequence.read(i);
    const cv::Mat exclude = exclusion_of(tracker, frame);

    cv::Mat metres;
    frame.depth.convertTo(metres, CV_32F, frame.depth.type() == CV_32FC1 ? 1 : 1 / frame.depth_units_per_metre);
    extractor.set_frame(frame.image, metres);
    const slam::Features before = extractor.outside(cv::Mat::zeros(exclude.size(), CV_8UC1));
    const slam::Features after = extractor.outside(exclude);  // the same number, spread over what is left

    const cv::Mat instances = sequence.truth(i).instance;
    if (instances.empty()) return std::fprintf(stderr, "%s: has no true instances\n", argv[1]), 1;
    const auto& objects = sequence.recording().entries[static_cast<std::size_t>(i)].truth.objects;
    const Count b = count(before, instances, objects);
    const Count a = count(after, instances, objects);
    std::printf("frame %3d  without masks %4d: %3d on movers, %3d on parked cars  with masks %4d: %3d, %3d\n",
                frame.number, b.all, b.on_movers, b.on_parked, a.all, a.on_movers, a.on_parked);
    if (b.on_movers > most_on_movers) {  // the frame to show
      most_on_movers = b.on_movers;
      picture = draw(frame.image, exclude, before, after);
    }
    add(without, b);
    add(with, a);
  }
  if (argc == 3 && !cv::imwrite(argv[2], picture)) return std::fprintf(stderr, "cannot write %s\n", argv[2]), 1;
  std::printf("features on movers: %d without masks, %d with them\n", without.on_movers, with.on_movers);
  std::printf("features on parked cars: %d without masks, %d with them\n", without.on_parked, with.on_parked);
  std::printf("features in all: %d without masks, %d with them\n", without.all, with.all);
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
