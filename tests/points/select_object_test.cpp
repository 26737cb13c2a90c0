// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/points/select_object.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "dot/camera/depth_noise.hpp"
#include "support/depth_cameras.hpp"
#include "support/random.hpp"
#include "support/synthetic_scene.hpp"

namespace {

using dot::Box;
using dot::Image;
using dot::ObjectPoints;
using dot::Pinhole;
using dot::PointSet;
using dot::Pyramid;
using dot::SE3d;
using dot::Vector3;
using namespace dot::test;

constexpr std::uint32_t car = 7, pillar = 9;

dot::DepthNoise noise_of(double sigma_px) {
  dot::DepthNoiseSettings s;
  s.source = dot::DepthSource::Stereo;
  s.stereo_sigma_px = sigma_px;
  return {s, small_camera()};  // f b = 40: sigma_px / 40 in inverse depth
}

/// One body's mask as a segmentation gives it: cropped to its bounding box.
struct Crop {
  Box box;
  Image<std::uint8_t> mask;
  int area = 0;

  Crop(const Image<std::uint32_t>& ids, std::uint32_t id) {
    int x0 = ids.width(), y0 = ids.height(), x1 = -1, y1 = -1;
    for (int y = 0; y < ids.height(); ++y)
      for (int x = 0; x < ids.width(); ++x)
        if (ids(x, y) == id) x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    box = {x0, y0, x1 - x0 + 1, y1 - y0 + 1};
    mask.resize(box.width, box.height);
    for (int y = 0; y < box.height; ++y)
      for (int x = 0; x < box.width; ++x) {
        mask(x, y) = ids(x0 + x, y0 + y) == id ? 255 : 0;
        area += mask(x, y) != 0;
      }
  }
};

/// A car before the hopper's back wall, z metres ahead.
Scene street(double z = 3.4) {
  Body body = box(car, {0.6, 0.5, 0.4}, 50, 0.12, 0.8);
  body.T_world_body = {dot::so3::exp(Vector3<double>(0, 0.4, 0)), Vector3<double>(0.3, 0.1, z)};
  return {{hopper(21), body}};
}

/// What the selection sees and gives, with `truth` to judge it by.
struct Selected {
  Rendering truth;
  ObjectPoints summary;
  PointSet points;

  /// @param spoil changes what is seen. @param measured the measurements of depth, if they are far apart.
  Selected(const Scene& scene, const Degradation& degradation, double sigma_px = 0.1, int budget = 600,
           const std::function<void(Rendering&)>& spoil = {}, const dot::DepthMeasurements& measured = {}) {
    const Pinhole camera(small_camera());
    truth = scene.render(camera, SE3d{});
    Rendering seen = degraded(truth, degradation);
    if (spoil) spoil(seen);
    Pyramid pyramid;
    pyramid.build(seen.grey.view(), 3);
    const Image<float> q = seen.inverse_depth();
    const dot::DepthNoise noise = noise_of(sigma_px);
    dot::SelectionSettings settings;
    settings.object_points = budget;
    dot::SelectionWorkspace workspace;
    const dot::Selector<Pinhole, dot::DepthNoise> selector{
        camera, noise, pyramid, q.view(), settings, workspace, dot::portable_kernels(), nullptr, &measured};
    const Crop crop(seen.ids, car);
    summary = select_object(selector, crop.box, crop.mask.view(), crop.area, points);
  }
  int x(std::size_t i) const { return static_cast<int>(points.u[i]); }
  int y(std::size_t i) const { return static_cast<int>(points.v[i]); }
  /// Whether a pixel of `id` is at most `reach` columns and rows away.
  bool near(std::size_t i, std::uint32_t id, int reach) const {
    for (int v = y(i) - reach; v <= y(i) + reach; ++v)
      for (int u = x(i) - reach; u <= x(i) + reach; ++u)
        if (truth.ids.contains(u, v) && truth.ids(u, v) == id) return true;
    return false;
  }
};

TEST(SelectObject, TakesTheObjectInsideItsBorder) {
  const Selected s(street(), {});
  EXPECT_GT(s.points.size(), 200);
  EXPECT_LT(s.points.size(), 900);
  for (std::size_t i = 0; i < s.points.u.size(); ++i) EXPECT_FALSE(s.near(i, 0, 1)) << s.x(i) << ", " << s.y(i);
  ASSERT_EQ(s.points.levels, 3);
  for (std::size_t l = 0; l < 3; ++l) EXPECT_EQ(s.points.intensity[l].size(), s.points.u.size());
}

/// Measurements of an object: `count` pixels about the middle of its mask, all of one inverse depth.
dot::DepthMeasurements measured_on_car(const Scene& scene, int count, float q) {
  const Crop crop(scene.render(Pinhole(small_camera()), SE3d{}).ids, car);
  Image<float> sparse(small_camera().width, small_camera().height);
  sparse.fill(0);
  for (int i = 0; i < count; ++i)
    sparse(crop.box.x + crop.box.width / 2 + i - count / 2, crop.box.y + crop.box.height / 2) = q;
  dot::DepthMeasurements measured;
  measured.list(sparse);
  return measured;
}

// The depth in its mask may be that of measurements beside it.
TEST(SelectObject, GivesNoPointsWithoutMeasurementsOfItsOwn) {
  const float q = Selected(street(), {}).summary.median_q;
  EXPECT_EQ(Selected(street(), {}, 0.1, 600, {}, measured_on_car(street(), 5, q)).points.size(), 0);
  EXPECT_GT(Selected(street(), {}, 0.1, 600, {}, measured_on_car(street(), 6, q)).points.size(), 200);
}

TEST(SelectObject, SaysHowMuchItSaw) {
  const Selected s(street(), {});
  const Crop crop(s.truth.ids, car);
  EXPECT_NEAR(s.summary.pixels_with_depth, crop.area, 0.05 * crop.area);
  EXPECT_NEAR(1 / s.summary.median_q, 3.0, 0.3);  // its front
}

TEST(SelectObject, DoesNotSelectLeakedBackground) {
  Degradation leaking;
  leaking.leak = 4;
  const Selected s(street(), leaking);
  EXPECT_GT(s.points.size(), 200);
  int wrong = 0;
  for (std::size_t i = 0; i < s.points.u.size(); ++i) wrong += s.truth.ids(s.x(i), s.y(i)) != car;
  EXPECT_EQ(wrong, 0);
  for (const float q : s.points.q) EXPECT_GT(q, 1 / 4.2f);  // the wall is 5 to 6 m away, the car 2.8 to 4
  EXPECT_NEAR(1 / s.summary.median_q, 3.0, 0.3);
}

TEST(SelectObject, KeepsAwayFromTheObjectsEdgeInAMaskThatIsTooLarge) {
  Degradation leaking;
  leaking.leak = 10;
  const Selected s(street(4.4), leaking);  // the wall, 5 to 6 m away, is within the depths that such an object may have
  EXPECT_GT(s.points.size(), 200);
  int behind = 0;
  for (std::size_t i = 0; i < s.points.u.size(); ++i) {
    if (s.truth.ids(s.x(i), s.y(i)) == car) continue;
    ++behind;
    // Blocks of 2x2 pixels may reach one pixel less far.
    EXPECT_FALSE(s.near(i, car, 3)) << s.x(i) << ", " << s.y(i);
  }
  EXPECT_GT(behind, 5);
}

TEST(SelectObject, KeepsAwayFromAnOccluder) {
  Scene scene = street();
  Body post = box(pillar, {0.1, 2, 0.1}, 80, 0.1, 0.6);
  post.T_world_body.t = {0.25, 0, 1.8};
  scene.bodies.push_back(post);
  const Selected s(scene, {});
  EXPECT_GT(s.points.size(), 100);
  int left = 0, right = 0;
  for (std::size_t i = 0; i < s.points.u.size(); ++i) {
    EXPECT_FALSE(s.near(i, pillar, 4)) << s.x(i) << ", " << s.y(i);
    (s.points.x[i] * 1.8f < 0.25f ? left : right) += 1;
  }
  EXPECT_GT(left, 20);
  EXPECT_GT(right, 20);
}

/// Points with a depth that no surface within three pixels has: beyond five of their own sigma and 3 cm. A contour
/// moves with what is nearer, so beside it that depth is right.
int depths_of_nothing(const Selected& s) {
  int found = 0;
  for (std::size_t i = 0; i < s.points.u.size(); ++i) {
    bool right = false;
    for (int y = s.y(i) - 3; y <= s.y(i) + 3; ++y)
      for (int x = s.x(i) - 3; x <= s.x(i) + 3; ++x) {
        const float z = s.truth.depth(x, y), error = std::abs(s.points.q[i] - 1 / z);
        right |= error <= 5 * s.points.sigma_q[i] || error * z * z <= 0.03f;
      }
    found += !right;
  }
  return found;
}

// A mask that is too large contains the edge of the object, which has the strongest gradients. There a time-of-flight
// camera measures depths between both surfaces, and a structured-light camera the object's, beyond its border.
TEST(SelectObject, TakesNoDepthBetweenTwoSurfaces) {
  Degradation leaking;
  leaking.leak = 3;
  for (const double z : {3.4, 4.4})
    for (const int reach : {1, 2}) {
      Random random(11);
      const Selected s(street(z), leaking, 0.1, 600, [&](Rendering& r) { see_by_time_of_flight(r, random, reach); });
      EXPECT_GT(s.points.size(), 200);
      EXPECT_LT(depths_of_nothing(s), 0.02 * s.points.size()) << z << ", " << reach;
    }
}

TEST(SelectObject, TakesNoPointBesideAFattenedEdge) {
  Scene scene = street();
  Body post = box(pillar, {0.1, 2, 0.1}, 80, 0.1, 0.6);
  post.T_world_body.t = {0.25, 0, 1.8};
  scene.bodies.push_back(post);
  for (const unsigned seed : {1u, 2u, 3u}) {
    Random random(seed);
    const Selected s(scene, {}, 0.1, 600, [&](Rendering& r) { see_by_structured_light(r, random, 200 * 0.075); });
    EXPECT_GT(s.points.size(), 100);
    EXPECT_EQ(depths_of_nothing(s), 0) << seed;
    for (std::size_t i = 0; i < s.points.u.size(); ++i) EXPECT_FALSE(s.near(i, pillar, 4)) << s.x(i) << ", " << s.y(i);
  }
}

TEST(SelectObject, KeepsTheReliefOfANearObject) {
  Degradation noisy;
  noisy.depth_noise = 0.1 / 40;
  const Selected s(street(), noisy);
  ASSERT_GT(s.points.size(), 200);
  double squared = 0;
  std::set<float> depths;
  for (std::size_t i = 0; i < s.points.u.size(); ++i) {
    const double error = s.points.q[i] - 1 / s.truth.depth(s.x(i), s.y(i));
    squared += error * error;
    depths.insert(s.points.q[i]);
  }
  EXPECT_GT(static_cast<int>(depths.size()), s.points.size() / 2);
  EXPECT_LT(std::sqrt(squared / s.points.size()), noisy.depth_noise);
}

TEST(SelectObject, GivesAFarFlatObjectOneDepth) {
  // 4 x 3 m at 40 m: with a disparity noise of 0.05 px, its 2 m of relief are one sigma.
  Body body = box(car, {2, 1.5, 1}, 50, 1.5, 6);
  body.T_world_body = {dot::so3::exp(Vector3<double>(0, 0.5, 0)), Vector3<double>(2, -1, 40)};
  Degradation noisy;
  noisy.depth_noise = 0.05 / 40;
  const Selected s({{body}}, noisy, 0.05, 200);
  ASSERT_GT(s.points.size(), 30);
  for (const float q : s.points.q) EXPECT_EQ(q, s.points.q[0]);
  // The median of some 300 pixels: a tenth of a sigma, and the relief.
  EXPECT_NEAR(s.points.q[0], 1 / 39.3, 0.5 * noisy.depth_noise);
}

/// Root mean square of the points' errors, over that of one depth for all.
double error_of_tilt(const Selected& s) {
  double squared = 0, level = 0, mean = 0;
  for (const float q : s.points.q) mean += static_cast<double>(q) / s.points.size();
  for (std::size_t i = 0; i < s.points.u.size(); ++i) {
    const double truth = 1 / s.truth.depth(s.x(i), s.y(i)), q = static_cast<double>(s.points.q[i]);
    squared += (q - truth) * (q - truth), level += (mean - truth) * (mean - truth);
  }
  return std::sqrt(squared / level);
}

// A van seen at an angle, at 2.9 to 4 pixels of disparity with half a pixel of noise. Its relief is within the noise
// of one pixel, but not within that of all together.
TEST(SelectObject, GivesAFarObjectTheTiltThatItsPixelsShowTogether) {
  Body body;
  body.id = car;
  const Texture texture(50, 0.5, 3);
  body.quads.push_back({Vector3<double>::Zero(), Vector3<double>(2.5, 0, 0), Vector3<double>(0, 1.5, 0), texture});
  body.T_world_body = {dot::so3::exp(Vector3<double>(0, 0.9, 0)), Vector3<double>(1, 0, 12)};
  Degradation noisy;
  noisy.depth_noise = 0.5 / 40;
  const Selected s({{body}}, noisy, 0.5, 300);
  ASSERT_GT(s.points.size(), 30);
  EXPECT_LT(error_of_tilt(s), 0.6);
  const double plane = noisy.depth_noise * noisy.depth_noise * 45 / s.summary.pixels_with_depth;
  EXPECT_GT(s.summary.slope_variance, 2.5 * plane);
  EXPECT_LT(std::sqrt(s.summary.slope_variance), 0.01) << "an eighth of its inverse depth";
}

TEST(SelectObject, GivesAFarObjectSquareToTheViewHardlyATilt) {
  Body body;
  body.id = car;
  const Texture texture(50, 0.5, 3);
  body.quads.push_back({Vector3<double>::Zero(), Vector3<double>(1.6, 0, 0), Vector3<double>(0, 1.5, 0), texture});
  body.T_world_body.t = Vector3<double>(1, 0, 20);
  Degradation noisy;
  noisy.depth_noise = 0.5 / 40;
  double squared = 0;
  for (noisy.seed = 1; noisy.seed <= 10; ++noisy.seed) {
    const Selected s({{body}}, noisy, 0.5, 300);
    const auto [low, high] = std::minmax_element(s.points.q.begin(), s.points.q.end());
    squared += static_cast<double>((*high - *low) * (*high - *low)) / 10;
    EXPECT_GT(s.summary.slope_variance, 0);
  }
  EXPECT_LT(std::sqrt(squared), 0.002) << "from border to border; of independent pixels it would be 0.003";
}

TEST(SelectObject, KnowsTheShapeOfANearObject) { EXPECT_EQ(Selected(street(), {}).summary.slope_variance, 0); }

TEST(SelectObject, FindsNothingWithoutDepth) {
  Degradation blind;
  blind.missing_depth = 1;
  const Selected s(street(), blind);
  EXPECT_EQ(s.points.size(), 0);
  EXPECT_EQ(s.summary.pixels_with_depth, 0);
  EXPECT_EQ(s.summary.median_q, 0);
}

TEST(SelectObject, CopesWithThirtyPercentMissingDepth) {
  Degradation holes;
  holes.missing_depth = 0.3;
  holes.leak = 3;
  const Selected s(street(), holes);
  EXPECT_GT(s.points.size(), 150);
  for (std::size_t i = 0; i < s.points.u.size(); ++i) EXPECT_EQ(s.truth.ids(s.x(i), s.y(i)), car);
}

/// Takes the depth of the car's pixels away, except in columns that hold this share of them, from the left.
std::function<void(Rendering&)> measured_on_the_left(double share) {
  return [=](Rendering& seen) {
    const Crop crop(seen.ids, car);
    int left = 0;
    for (int x = 0; x < crop.box.width; ++x)
      for (int y = 0; y < crop.box.height; ++y) {
        if (!crop.mask(x, y)) continue;
        if (left++ >= share * crop.area) seen.depth(crop.box.x + x, crop.box.y + y) = 0;
      }
  };
}

/// How many points lie where a depth was measured, and how many where none was.
struct Where {
  int measured = 0, elsewhere = 0;

  Where(const Selected& s, const std::function<void(Rendering&)>& spoil) {
    Rendering seen = s.truth;
    spoil(seen);
    for (std::size_t i = 0; i < s.points.u.size(); ++i) (seen.depth(s.x(i), s.y(i)) > 0 ? measured : elsewhere) += 1;
  }
};

/// Takes the depth of the car's pixels away, but for this share of them.
std::function<void(Rendering&)> measured_here_and_there(double share) {
  return [=](Rendering& seen) {
    Random random(5);
    for (int y = 0; y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == car && random.uniform() > share) seen.depth(x, y) = 0;
  };
}

// Near the camera an object's own relief moves its parts by much more than a pixel against each other. One level for
// all of it will not do, but a window of a large object still has enough depths for a plane.
TEST(SelectObject, WithDepthInLessThanAQuarterTakesPlanesOfWhatIsNear) {
  const Selected full(street(1.5), {});
  for (const auto& spoil : {measured_on_the_left(0.22), measured_here_and_there(0.2)}) {
    const Selected s(street(1.5), {}, 0.1, 600, spoil);
    EXPECT_TRUE(s.summary.shape_known);
    EXPECT_GT(s.points.size(), 100);
    EXPECT_EQ(Where(s, spoil).elsewhere, 0);
    for (std::size_t i = 0; i < s.points.u.size(); ++i)
      EXPECT_LT(std::abs(s.points.q[i] - 1 / s.truth.depth(s.x(i), s.y(i))), 4 * s.points.sigma_q[i]);
  }
}

TEST(SelectObject, WithTooFewDepthsForPlanesTakesNothingOfWhatIsNear) {
  const Selected s(street(1.5), {}, 0.1, 600, measured_here_and_there(0.08));
  EXPECT_FALSE(s.summary.shape_known);
  EXPECT_EQ(s.points.size(), 0);
  EXPECT_TRUE(Selected(street(5), {}, 0.1, 600, measured_here_and_there(0.08)).summary.shape_known);
}

// Stereo near its least distance: few depths, and half of them wrong.
TEST(SelectObject, WithFewDepthsOfMoreThanOneThingTakesNothingOfWhatIsNear) {
  const auto spoil = [](Rendering& seen) {
    measured_here_and_there(0.2)(seen);
    Random random(6);
    for (int y = 0; y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == car && random.uniform() < 0.5) seen.depth(x, y) *= 4;
  };
  const Selected s(street(1.5), {}, 0.1, 600, spoil);
  EXPECT_FALSE(s.summary.shape_known);
  EXPECT_EQ(s.points.size(), 0);
}

// The images say how it moves; where it is, a few depths say as well as many, and a plane through them says no more.
TEST(SelectObject, WithDepthInLessThanAQuarterTakesTheWholeMaskAtOneLevel) {
  const auto spoil = measured_on_the_left(0.22);
  const Selected full(street(5), {});
  const Selected s(street(5), {}, 0.1, 600, spoil);
  const Crop crop(s.truth.ids, car);
  const Where where(s, spoil);
  EXPECT_NEAR(s.summary.pixels_with_depth, 0.22 * crop.area, 0.03 * crop.area);
  EXPECT_GT(s.points.size(), 0.8 * full.points.size());
  EXPECT_GT(where.measured, s.points.size() / 10);
  // Points in each part of the mask, as many as if all were measured.
  for (int part = 0; part < 6; ++part) {
    const auto in_part = [&](const Selected& of) {
      int n = 0;
      for (std::size_t i = 0; i < of.points.u.size(); ++i)
        n += (of.x(i) - crop.box.x) * 3 / crop.box.width == part % 3 &&
             (of.y(i) - crop.box.y) * 2 / crop.box.height == part / 3;
      return n;
    };
    EXPECT_GT(in_part(s), 0.6 * in_part(full)) << part;
  }
  // The level is that of the measured pixels, and each point says how far its own depth may be from it.
  float least = 1e9f, most = 0;
  Rendering seen = s.truth;
  spoil(seen);
  for (int y = 0; y < seen.ids.height(); ++y)
    for (int x = 0; x < seen.ids.width(); ++x)
      if (seen.ids(x, y) == car && seen.depth(x, y) > 0)
        least = std::min(least, 1 / seen.depth(x, y)), most = std::max(most, 1 / seen.depth(x, y));
  EXPECT_GT(s.summary.median_q, least);
  EXPECT_LT(s.summary.median_q, most);
  for (std::size_t i = 0; i < s.points.u.size(); ++i) {
    EXPECT_EQ(s.points.q[i], s.summary.median_q);
    EXPECT_LT(std::abs(s.points.q[i] - 1 / s.truth.depth(s.x(i), s.y(i))), 3 * s.points.sigma_q[i]);
  }
}

TEST(SelectObject, WithDepthInMoreThanAQuarterTakesOnlyWhatIsMeasured) {
  const auto spoil = measured_on_the_left(0.3);
  const Selected s(street(), {}, 0.1, 600, spoil);
  const Where where(s, spoil);
  EXPECT_GT(where.measured, 100);
  EXPECT_EQ(where.elsewhere, 0);
}

// A window, as it were, in the middle of one that has depth everywhere else.
TEST(SelectObject, TakesNothingFromAHoleInItsDepth) {
  const auto spoil = [](Rendering& seen) {
    const Crop crop(seen.ids, car);
    for (int y = crop.box.height / 3; y < 2 * crop.box.height / 3; ++y)
      for (int x = crop.box.width / 3; x < 2 * crop.box.width / 3; ++x) seen.depth(crop.box.x + x, crop.box.y + y) = 0;
  };
  const Selected s(street(), {}, 0.1, 600, spoil);
  const Where where(s, spoil);
  EXPECT_GT(where.measured, 150);
  EXPECT_EQ(where.elsewhere, 0);
}

}  // namespace
