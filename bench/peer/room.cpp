// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// The whole alignment of a new frame, from the images to the pose, beside OpenCV's RgbdOdometry: same pairs of views of
// a textured room, same process, one thread, in turn. Time and pose error by the budget of points and by whose
// gradients are taken.
//
//     bench_peer_room [PAIRS [REPEATS]]    20 and 15 by default; figures are medians over all of them
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "dot/image/opencv.hpp"
#include "dot/kernel/dispatch.hpp"
#include "dot/pipeline/options.hpp"
#include "measure.hpp"
#include "peer.hpp"
#include "room.hpp"
#include "whole_alignment.hpp"

namespace {

using namespace dot::bench;

/// Of one method over all pairs and repeats.
struct Score {
  std::vector<double> ms, mm, degrees;
  int failed = 0;

  void add(double time, const dot::SE3d& T, const dot::SE3d& truth) {
    const PoseError e = pose_error(T, truth);
    ms.push_back(time), mm.push_back(1000 * e.metres), degrees.push_back(e.degrees);
  }
};

/// One way of ours.
struct Way {
  std::string name;
  int points;
  dot::GradientSource gradient;
  int window_radius;
  bool finish;
  Score score;
};

std::vector<Way> ways() {
  using dot::GradientSource;
  const dot::Options defaults;
  std::vector<Way> all;
  const auto add = [&](const char* name, int points, GradientSource gradient, int radius, bool finish) {
    all.push_back({name, points, gradient, radius, finish, {}});
  };
  const int radius = defaults.selection.window_radius;
  add("as the pipeline", defaults.selection.background_points, defaults.align.gradient, radius, true);
  for (const auto& [name, gradient] : {std::pair{"forward", GradientSource::Image},
                                       {"reference", GradientSource::Reference},
                                       {"mean (ESM)", GradientSource::Mean}})
    for (const int points : {150, 300, 450, 600, 1200, 2400, 4800, 9600}) add(name, points, gradient, radius, false);
  for (const int points : {300, 450, 600, 1200, 2400}) add("forward, narrow", points, GradientSource::Image, 2, false);
  return all;
}

cv::Mat mat(const dot::Image<float>& image) { return dot::mat(image.view()); }
cv::Mat mat(const dot::Image<std::uint8_t>& image) { return dot::mat(image.view()); }

void print(const Way& way, const Score& peer) {
  std::printf("%-19s %5d %4d %8.3f %7.1f %8.3f %8.4f %8.3f\n", way.name.c_str(), way.points, 2 * way.window_radius + 1,
              median(way.score.ms), median(peer.ms) / median(way.score.ms), median(way.score.mm),
              median(way.score.degrees), quantile(way.score.mm, 0.9));
}

void run(unsigned pairs, int repeats) {
  const dot::Pinhole camera = camera_of(640, 480);
  dot::DepthNoiseSettings prior;
  prior.source = dot::DepthSource::Rgbd;
  const dot::DepthNoise noise(prior, camera.intrinsics());
  std::vector<Way> all = ways();
  struct Rival {
    const char* name;
    Peer peer;
    Score score;
  };
  const auto rival = [&](const char* name, double pixels) -> Rival {
    return {name, Peer(camera.intrinsics(), {10, 0.07, 0.15, 15, pixels}), {}};
  };
  Rival rivals[] = {rival("peer, 7 % (default)", 0.07), rival("peer, 2 %", 0.02), rival("peer, 20 %", 0.2)};
  Peer& peer = rivals[0].peer;
  Score &whole = rivals[0].score, cached;
  std::vector<double> build, select, align;  // of the first way
  for (unsigned seed = 1; seed <= pairs; ++seed) {
    const Pair pair = room_pair(seed, camera);
    const cv::Mat images[] = {mat(pair.reference.grey), mat(pair.current.grey)};
    const cv::Mat depths[] = {mat(pair.reference.depth), mat(pair.current.depth)};
    for (int repeat = 0; repeat < repeats; ++repeat) {
      dot::SE3d T;
      bool ok = false;
      double time = 0;
      for (Rival& r : rivals) {
        time = milliseconds([&] { ok = r.peer.align(images[0], depths[0], {}, images[1], depths[1], {}, T); });
        ok ? r.score.add(time, T, pair.T_cur_ref) : void(++r.score.failed);
      }
      Peer::Frame before = peer.prepare(images[0], depths[0]);
      time = milliseconds([&] {
        Peer::Frame now = peer.prepare(images[1], depths[1]);
        ok = peer.align(before, now, T);
      });
      ok ? cached.add(time, T, pair.T_cur_ref) : void(++cached.failed);
      for (Way& way : all) {
        WholeAlignment ours(camera, noise);
        ours.selection.background_points = way.points;
        ours.selection.window_radius = way.window_radius;
        ours.aligner.settings.gradient = way.gradient;
        ours.finish = way.finish;
        ours.prepare(pair.current.image_ref(), pair.current.depth_ref());  // takes the buffers, as a frame before had
        ours.prepare(pair.reference.image_ref(), pair.reference.depth_ref());
        ours.prepare(pair.reference.image_ref(), pair.reference.depth_ref());
        dot::Alignment a;
        time = milliseconds([&] {
          ours.prepare(pair.current.image_ref(), pair.current.depth_ref());
          a = ours.align();
        });
        way.score.add(time, a.state.T, pair.T_cur_ref);
        if (&way == &all.front()) {
          build.push_back(milliseconds([&] { ours.build(pair.current.image_ref(), pair.current.depth_ref()); }));
          select.push_back(milliseconds([&] { ours.select(); }));
          align.push_back(milliseconds([&] { ours.align(); }));
        }
      }
    }
  }
  std::printf("640x480, %u pairs, %d repeats, one thread, kernels: %s\n\n", pairs, repeats, dot::find_kernels()->name);
  std::printf("%-19s %5s %4s %8s %7s %8s %8s %8s\n", "", "pts", "win", "ms", "ratio", "mm", "deg", "mm, 90%");
  const auto print_rival = [&](const char* name, const Score& score) {
    std::printf("%-30s %8.3f %7.1f %8.3f %8.4f %8.3f  failed %d\n", name, median(score.ms),
                median(whole.ms) / median(score.ms), median(score.mm), median(score.degrees), quantile(score.mm, 0.9),
                score.failed);
  };
  for (const Rival& r : rivals) print_rival(r.name, r.score);
  print_rival("peer, reference prepared", cached);
  for (const Way& way : all) print(way, whole);
  std::printf("\nof the first: pyramid and inverse depth %.3f ms, points %.3f ms, alignment %.3f ms\n", median(build),
              median(select), median(align));

  const Way *fast = nullptr, *third = nullptr;  // the least time at the peer's error, and at a third of it
  const auto faster = [](const Way& way, const Way* best) {
    return !best || median(way.score.ms) < median(best->score.ms);
  };
  for (const Way& way : all) {
    const double mm = median(way.score.mm) / median(whole.mm), deg = median(way.score.degrees) / median(whole.degrees);
    if (mm <= 1 && deg <= 1 && faster(way, fast)) fast = &way;
    if (mm <= 1.0 / 3 && deg <= 1.0 / 3 && faster(way, third)) third = &way;
  }
  std::printf("\nleast time with no larger error, and with a third of it:\n");
  for (const Way* way : {fast, third}) way ? print(*way, whole) : void(std::printf("none\n"));
}

}  // namespace

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  run(argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 20, argc > 2 ? std::atoi(argv[2]) : 15);
}
