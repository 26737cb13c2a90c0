// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "dot/camera/pinhole.hpp"
#include "dot/image/image.hpp"
#include "dot/lie/se3.hpp"
#include "support/random.hpp"

/// @file
/// Scenes whose images, depth and motion are known exactly: textured rectangles, ray-traced without approximation.
/// `Scene::render` gives the ideal view of a pose, `degraded` what a real sensor and a real network make of it. The
/// same seed gives the same pixels everywhere: nothing here depends on a library's random distributions.

namespace dot::test {

/// Grey values as an analytic, band-limited function of a point of a surface: 128 plus sines of random directions and
/// phases, of wavelengths from `shortest` to `longest` metres. Keep the shortest above about six pixels in the image,
/// where bilinear interpolation is good to a grey value.
class Texture {
 public:
  /// @param contrast RMS, grey values; up to 30 the sum stays within 0..255.
  Texture(unsigned seed, double shortest, double longest, double contrast = 30) {
    Random random(seed);
    const double count = static_cast<double>(waves_.size());
    for (std::size_t i = 0; i < waves_.size(); ++i) {
      const double share = (static_cast<double>(i) + random.uniform()) / count;
      const double k = 6.283185307179586 / (shortest * std::pow(longest / shortest, share));
      const double direction = random.uniform(0, 6.283185307179586);
      waves_[i] = {k * std::cos(direction), k * std::sin(direction), random.uniform(0, 6.283185307179586)};
    }
    amplitude_ = contrast * std::sqrt(2 / count);
  }
  /// @param s, t metres along the two edges of the rectangle.
  double operator()(double s, double t) const {
    double sum = 0;
    for (const Wave& w : waves_) sum += std::sin(w.s * s + w.t * t + w.phase);
    return 128 + amplitude_ * sum;
  }

 private:
  struct Wave {
    double s, t, phase;
  };
  std::array<Wave, 10> waves_{};
  double amplitude_ = 0;
};

/// A flat rectangle, centre + s a + t b with |s|, |t| <= 1; a and b orthogonal, metres, axes of its body.
struct Quad {
  Vector3<double> centre, a, b;
  Texture texture;
};

/// A rigid thing. Its motion is its pose in the world, set anew for every frame.
struct Body {
  std::uint32_t id = 0;  ///< in the id image; 0 = background
  std::vector<Quad> quads;
  SE3d T_world_body;
};

/// A box about the origin of its body, each face with a texture of its own.
inline Body box(std::uint32_t id, const Vector3<double>& half, unsigned seed, double shortest, double longest,
                double contrast = 30) {
  Body body;
  body.id = id;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto edge = [&](int i) { return Vector3<double>(half[i % 3] * Vector3<double>::Unit(i % 3)); };
      body.quads.push_back({side * edge(axis), edge(axis + 1), edge(axis + 2), {++seed, shortest, longest, contrast}});
    }
  return body;
}

/// The inside of a hopper seen from its mouth: a back wall 6 m ahead of the world's origin and four slanted walls that
/// come towards it; convex, so without edges of depth. Fills the view of `small_camera` near the origin at 3 to 6 m.
inline Body hopper(unsigned seed, double shortest = 0.35, double longest = 2.5, double contrast = 30) {
  using V = Vector3<double>;
  const auto texture = [&] { return Texture(++seed, shortest, longest, contrast); };
  const V along = V(1, 0, -1.5).normalized(), down = V(0, 1, -1.5).normalized();
  Body body;
  body.quads.push_back({V(0, 0, 6), V(20, 0, 0), V(0, 20, 0), texture()});
  for (const double side : {-1.0, 1.0}) {
    body.quads.push_back({V(side * 1.2, 0, 6), 20 * V(side * along.x(), 0, along.z()), V(0, 20, 0), texture()});
    body.quads.push_back({V(0, side * 0.9, 6), V(20, 0, 0), 20 * V(0, side * down.y(), down.z()), texture()});
  }
  return body;
}

/// A camera for small images: 77 degrees wide, stereo baseline 0.2 m.
inline Intrinsics small_camera() { return {200, 200, 159.5, 119.5, 320, 240, 0.2}; }

/// What a camera sees, each image of its size.
struct Rendering {
  Image<float> intensity;    ///< grey values, exact
  Image<std::uint8_t> grey;  ///< the same, rounded
  Image<float> depth;        ///< metres along the optical axis, 0 = none
  Image<std::uint32_t> ids;  ///< of the bodies, 0 = background

  /// Fields of a Frame; they borrow this rendering's memory.
  ImageRef image_ref() const { return ref(grey, PixelFormat::Grey8); }
  ImageRef depth_ref() const { return ref(depth, PixelFormat::DepthF32); }
  ImageRef ids_ref() const { return ref(ids, PixelFormat::Id32); }

  /// 1/m, 0 = none.
  Image<float> inverse_depth() const {
    Image<float> q(depth.width(), depth.height());
    for (int y = 0; y < q.height(); ++y)
      std::transform(depth.row(y), depth.row(y) + q.width(), q.row(y), [](float z) { return z > 0 ? 1 / z : 0; });
    return q;
  }

  /// Makes `grey` follow `intensity`.
  void round() {
    grey.resize(intensity.width(), intensity.height());
    for (int y = 0; y < grey.height(); ++y)
      std::transform(intensity.row(y), intensity.row(y) + grey.width(), grey.row(y),
                     [](float value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.f, 255.f))); });
  }

 private:
  template <typename T>
  static ImageRef ref(const Image<T>& image, PixelFormat format) {
    return {image.row(0), image.width(), image.height(), image.view().stride, format};
  }
};

struct Scene {
  std::vector<Body> bodies;

  /// The ideal view from a pose of the camera, sampled at the pixel centres.
  template <typename Camera>
  Rendering render(const Camera& camera, const SE3d& T_world_camera) const {
    struct Placed {
      const Quad* quad;
      std::uint32_t id;
      Vector3<double> centre, normal, a, b;  // in camera axes; a and b over their squared length
      double a_length, b_length;
    };
    std::vector<Placed> placed;
    for (const Body& body : bodies) {
      const SE3d T = T_world_camera.inverse() * body.T_world_body;
      for (const Quad& quad : body.quads) {
        const Vector3<double> a = T.R * quad.a, b = T.R * quad.b;
        placed.push_back({&quad, body.id, T * quad.centre, a.cross(b), a / a.squaredNorm(), b / b.squaredNorm(),
                          a.norm(), b.norm()});
      }
    }
    Rendering out;
    out.intensity.resize(camera.width(), camera.height());
    out.depth.resize(camera.width(), camera.height());
    out.ids.resize(camera.width(), camera.height());
    for (int v = 0; v < camera.height(); ++v)
      for (int u = 0; u < camera.width(); ++u) {
        const Vector3<double> ray = camera.unproject(Vector2<double>(u, v));
        double nearest = std::numeric_limits<double>::infinity(), s = 0, t = 0;
        const Placed* hit = nullptr;
        for (const Placed& p : placed) {
          const double z = p.normal.dot(p.centre) / p.normal.dot(ray);  // the ray's own z is 1
          if (!(z > 1e-3 && z < nearest)) continue;
          const Vector3<double> on_quad = z * ray - p.centre;
          const double along_a = p.a.dot(on_quad), along_b = p.b.dot(on_quad);
          if (std::abs(along_a) > 1 || std::abs(along_b) > 1) continue;
          nearest = z, s = along_a, t = along_b, hit = &p;
        }
        out.intensity(u, v) = hit ? static_cast<float>(hit->quad->texture(s * hit->a_length, t * hit->b_length)) : 0.f;
        out.depth(u, v) = hit ? static_cast<float>(nearest) : 0.f;
        out.ids(u, v) = hit ? hit->id : 0;
      }
    out.round();
    return out;
  }
};

/// T_o of a body between two frames, in the axes of the reference camera: its point at X is at T_o X afterwards.
inline SE3d object_motion(const SE3d& T_world_reference, const SE3d& T_world_body_before,
                          const SE3d& T_world_body_after) {
  return T_world_reference.inverse() * T_world_body_after * T_world_body_before.inverse() * T_world_reference;
}

/// What is wrong with a view.
struct Degradation {
  double gain = 1;                             ///< of the exposure: gain I + offset
  double offset = 0;                           ///< grey values
  double noise = 0;                            ///< grey values, 1 sigma of each pixel
  double depth_noise = 0;                      ///< 1/m, 1 sigma of each pixel's inverse depth
  double missing_depth = 0;                    ///< share of the pixels
  std::map<std::uint32_t, double> depth_bias;  ///< 1/m, on the inverse depth of all pixels of an id
  int leak = 0;  ///< pixels by which the masks spread over the background around them (square)
  unsigned seed = 1;
};

inline Rendering degraded(const Rendering& exact, const Degradation& d) {
  Rendering out = exact;
  Random random(d.seed);
  const auto bias_of = [&](std::uint32_t id) {
    const auto found = d.depth_bias.find(id);
    return found == d.depth_bias.end() ? 0.0 : found->second;
  };
  for (int y = 0; y < out.ids.height(); ++y)
    for (int x = 0; x < out.ids.width(); ++x) {
      out.intensity(x, y) = static_cast<float>(d.gain * static_cast<double>(exact.intensity(x, y)) + d.offset);
      if (d.noise > 0) out.intensity(x, y) += static_cast<float>(random.normal(d.noise));
      float& z = out.depth(x, y);
      const bool off = d.depth_noise > 0 || !d.depth_bias.empty();
      if (z > 0 && off) {
        double q = 1 / static_cast<double>(z) + bias_of(exact.ids(x, y));
        if (d.depth_noise > 0) q += random.normal(d.depth_noise);
        z = q > 0 ? static_cast<float>(1 / q) : 0.f;
      }
      if (d.missing_depth > 0 && random.uniform() < d.missing_depth) z = 0;
      for (int j = y - d.leak; j <= y + d.leak && exact.ids(x, y) == 0; ++j)
        for (int i = x - d.leak; i <= x + d.leak; ++i)
          if (exact.ids.contains(i, j) && exact.ids(i, j) != 0) out.ids(x, y) = exact.ids(i, j);
    }
  out.round();
  return out;
}

}  // namespace dot::test
