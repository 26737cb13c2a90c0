// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
//
// How large a motion of the camera is found from nothing: pairs of frames of recorded sequences, 1 to 4 frames apart,
// without a prediction, on the static background alone; beside OpenCV's RgbdOdometry. Ours is a tracker that sees two
// frames. The sequences need true poses and instances.
//
//     bench_peer_convergence [--list] [--turn DEGREES] [--exposure GAIN] [--depth-difference METRES] [--witness N]
//                           SEQUENCE...
//
// A pose is right within max(2 cm, 5 %) of the distance and 0.1 degrees; wrong beyond max(10 cm, 15 %) or 0.3 degrees.
// --turn turns the second camera of each pair besides, about another axis each time, --exposure multiplies its image.
// --list writes all pairs as CSV instead of the table; between_m and between_deg are those between the two answers.
// --witness takes the motions of the first N intervals of each sequence from matched features instead of its poses.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "dot/image/opencv.hpp"
#include "dot/kernel/dispatch.hpp"
#include "dot/tracker.hpp"
#include "measure.hpp"
#include "run/run_options.hpp"
#include "street.hpp"
#include "witness.hpp"

namespace {

using namespace dot::bench;

struct Count {
  int pairs = 0, right = 0, ok = 0, wrong_ok = 0;

  void add(bool reported_ok, const dot::SE3d& T, const dot::SE3d& truth) {
    const PoseError e = pose_error(T, truth);
    const double way = truth.t.norm();
    ++pairs;
    ok += reported_ok;
    right += reported_ok && e.metres <= std::max(0.02, 0.05 * way) && e.degrees <= 0.1;
    wrong_ok += reported_ok && (e.metres > std::max(0.1, 0.15 * way) || e.degrees > 0.3);
  }
};

/// Instances as the truth and as the network have them, and a margin.
cv::Mat ids_of_all(const runner::SequenceFrame& frame, const runner::FrameTruth& truth) {
  cv::Mat ids;
  if (truth.instance.empty())
    ids = cv::Mat::zeros(frame.image.size(), CV_32SC1);
  else
    ids = truth.instance.clone();
  if (frame.ids.empty()) return ids;
  cv::Mat network;
  frame.ids.convertTo(network, CV_32S);
  network += 100000;
  network.copyTo(ids, (frame.ids > 0) & (ids == 0));
  return ids;
}
cv::Mat background_of(const cv::Mat& ids) {
  cv::Mat objects = ids > 0;
  cv::dilate(objects, objects, cv::Mat::ones(9, 9, CV_8U));
  return ~objects;
}

/// How the second camera of a pair differs from that of its frame.
struct Change {
  double turn = 0;  ///< degrees
  double exposure = 1;
};

struct Seen {
  runner::SequenceFrame frame;
  PeerImages images;
  cv::Mat ids, background;
  dot::SE3d T_world_camera;
};

/// The same seen by a camera that is turned by R, x_turned = R x, about the same centre.
Seen turned(const Seen& seen, const dot::Matrix3<double>& R, const dot::Intrinsics& camera) {
  const cv::Matx33d K(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  const cv::Matx33d turn(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2));
  const cv::Matx33d H = K * turn * K.inv(), ray = turn.t() * K.inv();
  Seen out = seen;
  out.T_world_camera = seen.T_world_camera * dot::SE3d{R.transpose(), dot::Vector3<double>::Zero()};
  const auto warp = [&](const cv::Mat& from, cv::Mat& to, int interpolation, const cv::Scalar& outside) {
    to = cv::Mat();  // not into the memory that they share
    cv::warpPerspective(from, to, H, from.size(), interpolation, cv::BORDER_CONSTANT, outside);
  };
  warp(seen.frame.image, out.frame.image, cv::INTER_LINEAR, {});
  warp(seen.images.depth, out.images.depth, cv::INTER_NEAREST, std::numeric_limits<float>::quiet_NaN());
  out.images.depth.forEach<float>([&](float& z, const int* at) {  // z of a point changes as that of its ray
    z /= static_cast<float>(ray(2, 0) * at[1] + ray(2, 1) * at[0] + ray(2, 2));
  });
  out.frame.depth = out.images.depth;
  out.images.grey = PeerImages(out.frame).grey;
  cv::Mat ids, ids_turned;
  seen.ids.convertTo(ids, CV_32F);
  warp(ids, ids_turned, cv::INTER_NEAREST, {});
  ids_turned.convertTo(out.ids, CV_32S);
  warp(seen.background, out.background, cv::INTER_NEAREST, {});
  return out;
}
/// The same with another exposure.
Seen exposed(const Seen& seen, double gain) {
  Seen out = seen;
  out.frame.image = cv::Mat();  // not into the memory that they share
  seen.frame.image.convertTo(out.frame.image, -1, gain);
  out.images.grey = PeerImages(out.frame).grey;
  return out;
}
/// Right, left, down, up and about the optical axis in turn.
dot::Matrix3<double> nth_turn(std::size_t n, double degrees) {
  static const dot::Vector3<double> axes[] = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
  return dot::so3::exp(dot::Vector3<double>(axes[n % 5] * (degrees / 57.29578)));
}

/// Replaces the poses of the first intervals by what features tell; those after them keep their motions.
void take_witness(const dot::Intrinsics& camera, int intervals, std::vector<Seen>& all) {
  const Witness witness(camera);
  dot::SE3d T_world_recorded = all.empty() ? dot::SE3d{} : all[0].T_world_camera;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Seen &a = all[i - 1], &b = all[i];
    const dot::SE3d recorded = b.T_world_camera.inverse() * T_world_recorded;
    T_world_recorded = b.T_world_camera;
    const dot::SE3d T_cur_prev =
        static_cast<int>(i) > intervals
            ? recorded
            : witness.motion(a.images.grey, a.images.depth, a.background, b.images.grey, b.background);
    all[i].T_world_camera = a.T_world_camera * T_cur_prev.inverse();
  }
}

std::vector<Seen> read(runner::Sequence& sequence) {
  std::vector<Seen> all;
  for (int i = 0; i < sequence.size(); ++i) {
    const auto& pose = sequence.recording().entries[static_cast<std::size_t>(i)].truth.camera;
    if (!pose) throw std::runtime_error("needs poses.txt");
    runner::SequenceFrame frame = sequence.read(i);
    const cv::Mat ids = ids_of_all(frame, sequence.truth(i));
    const PeerImages images(frame);
    const dot::SE3d T{pose->topLeftCorner<3, 3>(), pose->topRightCorner<3, 1>()};
    all.push_back({std::move(frame), images, ids, background_of(ids), T.normalized()});
  }
  return all;
}

void print(const std::string& name, int gap, const Count& ours, const Count& theirs) {
  const auto percent = [](const Count& c) { return c.pairs ? 100.0 * c.right / c.pairs : 0; };
  std::printf("%-16s %4d %6d   %8.1f %4d %9d   %8.1f %4d %9d\n", name.c_str(), gap, ours.pairs, percent(ours), ours.ok,
              ours.wrong_ok, percent(theirs), theirs.ok, theirs.wrong_ok);
}

void list(const std::string& name, int first, int gap, const dot::SE3d& truth, const dot::CameraResult& c,
          const dot::SE3d& T, bool peer_ok, const dot::SE3d& peer_T) {
  const PoseError e = pose_error(T, truth), p = pose_error(peer_T, truth);
  const PoseError between = pose_error(T, peer_T);
  std::printf("%s,%d,%d,%.4f,%.3f,%s,%.4f,%.4f,%.4f,%d,%d,%.3f,%.2f,%.3f,%d,%.4f,%.4f,%.4f,%.4f\n", name.c_str(), first,
              gap, truth.t.norm(), dot::so3::log(truth.R).norm() * 57.29578, dot::to_string(c.status), e.metres,
              e.degrees, c.phi, c.n_points, c.n_inliers, c.reduced_chi2, c.residual_sigma, c.gain, peer_ok, p.metres,
              p.degrees, between.metres, between.degrees);
}

void run(const std::vector<std::string>& folders, Peer::Limits limits, const Change& change, int witnessed,
         bool listing) {
  Count ours[5], theirs[5];  // [0] of all
  if (listing)
    std::puts(
        "sequence,first,gap,way_m,turn_deg,status,error_m,error_deg,phi,n_points,n_inliers,reduced_chi2,"
        "residual_sigma,gain,peer_ok,peer_error_m,peer_error_deg,between_m,between_deg");
  else
    std::printf("kernels: %s\n\n%30s %24s %24s\n%-16s %4s %6s   %8s %4s %9s   %8s %4s %9s\n", dot::find_kernels()->name,
                "", "ours", "peer", "", "gap", "pairs", "right, %", "ok", "wrong, ok", "right, %", "ok", "wrong, ok");
  for (const std::string& folder : folders) {
    runner::RunOptions run;
    run.sequence.folder = folder;
    run.sequence.truth = true;
    runner::Sequence sequence(run.sequence);
    dot::Tracker tracker(sequence.intrinsics(), runner::tracker_options(run, sequence.depth_source()));
    Peer peer(sequence.intrinsics(), limits);
    std::vector<Seen> seen = read(sequence);
    if (witnessed > 0) take_witness(sequence.intrinsics(), witnessed, seen);
    const std::string name = std::filesystem::path(folder).lexically_normal().filename().string();
    for (std::size_t gap = 1; gap <= 4; ++gap) {
      Count here, peer_here;
      for (std::size_t i = 0; i + gap < seen.size(); ++i) {
        const Seen& a = seen[i];
        Seen b = seen[i + gap];
        if (change.turn != 0) b = turned(b, nth_turn(i, change.turn), sequence.intrinsics());
        if (change.exposure != 1) b = exposed(b, change.exposure);
        const dot::SE3d truth = b.T_world_camera.inverse() * a.T_world_camera;
        tracker.reset();
        dot::Frame frame = a.frame.frame();
        frame.masks = dot::Masks{dot::id_view(a.ids), {}};
        tracker.track(frame);
        frame = b.frame.frame();
        frame.masks.reset();
        const dot::CameraResult camera = tracker.track(frame).camera;
        const dot::SE3d T = dot::SE3d::from_row_major(camera.T_cur_prev);
        here.add(camera.status == dot::CameraStatus::Tracked, T, truth);
        dot::SE3d peer_T;
        const bool peer_ok = peer.align(a.images.grey, a.images.depth, a.background, b.images.grey, b.images.depth,
                                        b.background, peer_T);
        peer_here.add(peer_ok, peer_T, truth);
        if (listing) list(name, a.frame.number, static_cast<int>(gap), truth, camera, T, peer_ok, peer_T);
      }
      for (const auto& [part, sums] : {std::pair{here, ours}, {peer_here, theirs}})
        for (Count* sum : {&sums[0], &sums[gap]}) {
          sum->pairs += part.pairs, sum->right += part.right;
          sum->ok += part.ok, sum->wrong_ok += part.wrong_ok;
        }
      if (!listing) print(name, static_cast<int>(gap), here, peer_here);
    }
  }
  if (listing) return;
  for (int gap = 1; gap <= 4; ++gap) print("all", gap, ours[gap], theirs[gap]);
  print("all", 0, ours[0], theirs[0]);
}

}  // namespace

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  Peer::Limits limits = street_limits();
  bool listing = false;
  Change change;
  int witnessed = 0;
  std::vector<std::string> folders;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--list"))
      listing = true;
    else if (!std::strcmp(argv[i], "--turn") && i + 1 < argc)
      change.turn = std::atof(argv[++i]);
    else if (!std::strcmp(argv[i], "--exposure") && i + 1 < argc)
      change.exposure = std::atof(argv[++i]);
    else if (!std::strcmp(argv[i], "--witness") && i + 1 < argc)
      witnessed = std::atoi(argv[++i]);
    else if (!std::strcmp(argv[i], "--depth-difference") && i + 1 < argc)
      limits.depth_difference = std::atof(argv[++i]);
    else
      folders.push_back(argv[i]);
  }
  try {
    run(folders, limits, change, witnessed, listing);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_peer_convergence: %s\n", error.what());
    return 1;
  }
}
