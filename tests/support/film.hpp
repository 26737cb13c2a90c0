// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "dot/frame/frame.hpp"
#include "dot/pipeline/result.hpp"
#include "support/synthetic_scene.hpp"

/// @file
/// Synthetic scenes over time, fed to a pipeline frame by frame, and what its answers are worth against the truth.

namespace dot::test {

/// By how much an interval between two timestamps of a Unix clock may be off, seconds: a double resolves 0.24 us there.
constexpr double kClockError = 1e-6;

/// Where something is at a time in seconds.
using Path = std::function<SE3d(double)>;

/// A path at constant velocity, m/s, from a place; the axes of world and thing agree.
inline Path straight(const Vector3<double>& from, const Vector3<double>& velocity = Vector3<double>::Zero()) {
  return [=](double t) { return SE3d::translation(Vector3<double>(from + velocity * t)); };
}

/// A path that stands until `start`, then accelerates to `speed`, m/s, along x.
inline Path departing(const Vector3<double>& from, double start, double acceleration, double speed) {
  return [=](double t) {
    const double since = std::max(0.0, t - start), ramp = std::min(since, std::abs(speed) / acceleration);
    const double way = 0.5 * acceleration * ramp * ramp + std::abs(speed) * (since - ramp);
    return SE3d::translation(Vector3<double>(from + Vector3<double>(speed < 0 ? -way : way, 0, 0)));
  };
}

/// Ground 2 m below the origin and a wall 13 m ahead of it. Wavelengths that a 200 px camera does not alias.
inline Body yard(unsigned seed) {
  using V = Vector3<double>;
  Body body;
  body.quads.push_back({V(0, 2, 8), V(60, 0, 0), V(0, 0, 30), Texture(seed, 1.2, 6)});
  body.quads.push_back({V(0, -8, 13), V(60, 0, 0), V(0, 20, 0), Texture(seed + 1, 0.6, 4)});
  return body;
}

/// A box of the size of a small car, 1.8 m wide; stands on the yard's ground when its origin is at y = 1.3.
inline Body car(std::uint32_t id, unsigned seed) { return box(id, {0.9, 0.7, 0.7}, seed, 0.25, 1.2); }

/// A scene over time. `next` renders a frame, hands it to a pipeline and keeps it, so that others may see it as well.
template <typename Camera = Pinhole>
class Film {
 public:
  explicit Film(const Camera& camera = Camera(small_camera())) : camera_(camera) { scene_.bodies.push_back(yard(100)); }

  Path camera_path = straight(Vector3<double>::Zero());
  Degradation degradation;  ///< its seed is advanced with each frame
  double interval = 0.1;    ///< seconds between frames
  double epoch = 1.7e9;     ///< seconds, timestamp of frame 0: a Unix clock, as most hosts have
  double readout = 0;  ///< seconds from the first to the last row of a rolling shutter; 0: global. Without `direct`

  std::function<void(int, Scene&)> direct;     ///< changes the scene of a frame before it is rendered
  std::function<void(int, Rendering&)> spoil;  ///< changes the pixels of a frame
  std::function<void(int, Frame&)> edit;       ///< changes the fields of a frame

  /// Adds a car of this id on its path.
  void add(std::uint32_t id, Path path) { add(car(id, 1000 * id), std::move(path)); }
  void add(Body body, Path path) {
    paths_[body.id] = std::move(path);
    scene_.bodies.push_back(std::move(body));
  }

  /// Renders the next frame. Masks are given as an id image; `edit` may take them away.
  const Frame& advance() {
    ++index_;
    place(time(index_));
    if (direct) direct(index_, scene_);
    truth_ = scene_.render(camera_, T_world_camera());
    if (readout > 0) roll();
    Degradation d = degradation;
    d.seed += static_cast<unsigned>(1000 * index_);
    seen_ = degraded(truth_, d);
    if (spoil) spoil(index_, seen_);
    frame_ = {};
    frame_.id = static_cast<std::uint64_t>(index_);
    frame_.timestamp = epoch + time(index_);
    frame_.image = seen_.image_ref();
    frame_.depth = seen_.depth_ref();
    frame_.masks = Masks{};
    frame_.masks->ids = seen_.ids_ref();
    if (edit) edit(index_, frame_);
    return frame_;
  }

  /// The next frame's result.
  template <typename Pipeline>
  const Result& next(Pipeline& pipeline) {
    return pipeline.track(advance());
  }

  int index() const { return index_; }  ///< of the current frame, -1 before the first
  const Frame& frame() const { return frame_; }
  const Rendering& truth() const { return truth_; }
  const Rendering& seen() const { return seen_; }

  SE3d T_world_camera() const { return camera_path(time(index_)); }
  /// T_cur_prev of the current frame.
  SE3d T_c() const { return T_world_camera().inverse() * camera_path(time(index_ - 1)); }
  /// T_o of the current frame.
  SE3d T_o(std::uint32_t id) const {
    const Path& path = paths_.at(id);
    return object_motion(camera_path(time(index_ - 1)), path(time(index_ - 1)), path(time(index_)));
  }
  /// The origin of a body in the camera before the current interval.
  Vector3<double> before(std::uint32_t id) const {
    return camera_path(time(index_ - 1)).inverse() * paths_.at(id)(time(index_ - 1)).t;
  }

 private:
  double time(int index) const { return interval * index; }
  void place(double t) {
    for (Body& body : scene_.bodies)
      if (body.id != 0) body.T_world_body = paths_.at(body.id)(t);
  }
  /// Renders the rows anew, some at a time, as a rolling shutter sees them. The frame's time is that of the middle row.
  void roll() {
    constexpr int kTogether = 12;
    const int height = truth_.grey.height();
    for (int y = 0; y < height; y += kTogether) {
      const double t = time(index_) + ((y + 0.5 * kTogether) / height - 0.5) * readout;
      place(t);
      const Rendering rows = scene_.render(camera_, camera_path(t));
      for (int v = y; v < std::min(height, y + kTogether); ++v) {
        std::copy_n(rows.intensity.row(v), rows.intensity.width(), truth_.intensity.row(v));
        std::copy_n(rows.depth.row(v), rows.depth.width(), truth_.depth.row(v));
        std::copy_n(rows.ids.row(v), rows.ids.width(), truth_.ids.row(v));
      }
    }
    truth_.round();
    place(time(index_));
  }

  Camera camera_;
  Scene scene_;
  std::map<std::uint32_t, Path> paths_;
  int index_ = -1;
  Rendering truth_, seen_;
  Frame frame_;
};

/// Pixels of two id images in common, and of each.
struct Overlap {
  int both = 0, truth = 0, answer = 0;
  double iou() const { return truth + answer > both ? static_cast<double>(both) / (truth + answer - both) : 0; }
};

inline Overlap overlap(const Image<std::uint32_t>& truth, std::uint32_t body, const ImageView<const std::uint32_t>& ids,
                       std::uint32_t track) {
  Overlap o;
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x) {
      const bool a = truth(x, y) == body, b = ids(x, y) == track;
      o.both += a && b, o.truth += a, o.answer += b;
    }
  return o;
}

/// The track that covers most of a body, and at least a quarter; null when there is none.
inline const ObjectResult* object_on(const Result& result, const Image<std::uint32_t>& truth, std::uint32_t body) {
  std::map<std::uint32_t, int> pixels;
  int area = 0;
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x)
      if (truth(x, y) == body) ++area, ++pixels[result.ids(x, y)];
  std::uint32_t best = 0;
  for (const auto& [id, n] : pixels)
    if (id != 0 && 4 * n >= area && (best == 0 || n > pixels[best])) best = id;
  return best == 0 ? nullptr : result.find(best);
}

/// What a pipeline says of a body in one frame: one line for the message of a failed assertion.
inline std::string describe(const ObjectResult* o) {
  if (!o) return "no track";
  return "track " + std::to_string(o->id) + " " + to_string(o->state) + " p " + std::to_string(o->p_moving) + " v (" +
         std::to_string(o->velocity[0]) + ", " + std::to_string(o->velocity[1]) + ", " +
         std::to_string(o->velocity[2]) + ") " + to_string(o->reason);
}

}  // namespace dot::test
