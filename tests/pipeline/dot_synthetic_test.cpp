// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// What Dot<> measures on scenes of which everything is known: motions, their covariances, and its statuses when the
// input is poor.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <vector>

#include "dot/camera/radtan.hpp"
#include "dot/dot.hpp"
#include "support/film.hpp"

namespace {

using dot::CameraStatus;
using dot::Dot;
using dot::ObjectResult;
using dot::Options;
using dot::Pinhole;
using dot::Reason;
using dot::Result;
using dot::SE3d;
using dot::State;
using dot::Vector3;
using dot::Vector6;
using namespace dot::test;

constexpr std::uint32_t parked = 1, mover = 2;
const double degree = 3.14159265358979323846 / 180;

/// Starts at a place and goes on with a constant twist rate in its own axes.
Path twisting(const Vector3<double>& translation_rate, const Vector3<double>& rotation_rate) {
  Vector6<double> rate;
  rate << translation_rate, rotation_rate;
  return [=](double t) { return SE3d::exp(Vector6<double>(rate * t)); };
}

/// exp(x) of what is estimated against what is true, as a left twist.
Vector6<double> error_of(const std::array<double, 12>& estimate, const SE3d& truth) {
  return (SE3d::from_row_major(estimate) * truth.inverse()).log();
}

/// A yard with a parked car and one that crosses, 6 to 8 m away.
template <typename Camera = Pinhole>
Film<Camera> street(const Camera& camera = Camera(small_camera())) {
  Film<Camera> film(camera);
  film.add(parked, straight({1.6, 1.3, 7}));
  film.add(mover, straight({-2.5, 1.3, 6.5}, {2, 0, 0}));
  return film;
}

Dot<> make_dot(const Options& options = {}) { return Dot<>(Pinhole(small_camera()), options); }

struct CameraCase {
  const char* name;
  Vector3<double> velocity;  // m/s
  Vector3<double> rotation;  // degrees per second
  double gain_per_frame, offset_per_frame, noise;
  double max_cm, max_degrees;

  friend std::ostream& operator<<(std::ostream& out, const CameraCase& c) { return out << c.name; }
};

class CameraMotion : public testing::TestWithParam<CameraCase> {};

// Bounds: 2000 points of a gradient of about 4 grey values a pixel. Without noise the error is that of interpolation, a
// hundredth of a pixel or 0.4 mm at 8 m, and a few times that along the line of sight. With 4 grey values of noise a
// point knows its place to a pixel, all of them to 0.02 px, 0.8 mm, if the six directions were independent; shifts and
// turns are not, so again several times that.
TEST_P(CameraMotion, IsRecovered) {
  const CameraCase& c = GetParam();
  Film<> film = street();
  film.camera_path = twisting(c.velocity, degree * c.rotation);
  film.degradation.noise = c.noise;
  Dot<> dot = make_dot();
  double chi2 = 0;
  for (int i = 0; i < 8; ++i) {
    film.degradation.gain = std::pow(c.gain_per_frame, i);
    film.degradation.offset = c.offset_per_frame * i;
    const Result& result = film.next(dot);
    SCOPED_TRACE(i);
    if (i == 0) {
      EXPECT_EQ(result.camera.status, CameraStatus::FirstFrame);
      EXPECT_EQ(result.interval, 0);
      continue;
    }
    ASSERT_EQ(result.camera.status, CameraStatus::Tracked);
    EXPECT_NEAR(result.interval, 0.1, kClockError);
    const Vector6<double> e = error_of(result.camera.T_cur_prev, film.T_c());
    EXPECT_LT(100 * e.head<3>().norm(), c.max_cm);
    EXPECT_LT(e.tail<3>().norm() / degree, c.max_degrees);
    EXPECT_NEAR(result.camera.gain, c.gain_per_frame, 0.01);
    // Grey values are brighter by offset after the gain of this frame: I_i = g I_(i-1) + (b_i - g b_(i-1)).
    const double offset = c.offset_per_frame * (i - c.gain_per_frame * (i - 1));
    EXPECT_NEAR(result.camera.offset + 128 * (result.camera.gain - c.gain_per_frame), offset, 0.5);
    EXPECT_GT(result.camera.phi, 0.9);
    EXPECT_GT(result.camera.n_inliers, result.camera.n_points / 2);
    const Eigen::Map<const dot::Matrix6<double>> C(result.camera.covariance.data());
    chi2 += e.dot(C.ldlt().solve(e)) / 7;
  }
  EXPECT_LT(chi2, 6);  // six when the covariance is honest
}

INSTANTIATE_TEST_SUITE_P(Dot, CameraMotion,
                         testing::Values(CameraCase{"Standing", {0, 0, 0}, {0, 0, 0}, 1, 0, 0, 0.1, 0.02},
                                         CameraCase{"Forward", {0, 0, 3}, {0, 0, 0}, 1, 0, 0, 0.3, 0.03},
                                         CameraCase{"Sideways", {1.5, 0.2, 0}, {0, 0, 0}, 1, 0, 0, 0.3, 0.03},
                                         CameraCase{"Rotation", {0, 0, 0}, {4, 20, 3}, 1, 0, 0, 0.3, 0.03},
                                         CameraCase{"Both", {1, 0, 2}, {2, 10, 2}, 1, 0, 0, 0.3, 0.03},
                                         CameraCase{"GainDrift", {0.5, 0, 2}, {0, 5, 0}, 0.96, 3, 0, 0.3, 0.03},
                                         CameraCase{"Noise", {0.5, 0, 2}, {0, 5, 0}, 1, 0, 4, 0.8, 0.05}),
                         [](const auto& test) { return std::string(test.param.name); });

#ifndef DOT_TEST_DEFAULT_POLICIES
TEST(Camera, IsRecoveredThroughALensWithDistortion) {
  const dot::RadTan lens(small_camera(), {-0.2, 0.05, 1e-3, -5e-4, 0});
  Film<dot::RadTan> film = street(lens);
  film.camera_path = twisting({0.5, 0, 2}, {0, 0.1, 0});
  Dot<dot::RadTan> dot(lens);
  for (int i = 0; i < 6; ++i) {
    const Result& result = film.next(dot);
    if (i == 0) continue;
    SCOPED_TRACE(i);
    ASSERT_EQ(result.camera.status, CameraStatus::Tracked);
    const Vector6<double> e = error_of(result.camera.T_cur_prev, film.T_c());
    EXPECT_LT(e.head<3>().norm(), 0.005);
    EXPECT_LT(e.tail<3>().norm(), 0.05 * degree);
  }
}
#endif

/// Error of T_o where the body's origin was.
Vector3<double> shift_error(const ObjectResult& o, const SE3d& truth, const Vector3<double>& X) {
  return SE3d::from_row_major(o.T_o) * X - truth * X;
}

TEST(Object, MotionIsRecovered) {
  Film<> film = street();
  film.camera_path = twisting({0, 0, 2}, {0, 0.05, 0});
  Dot<> dot = make_dot();
  for (int i = 0; i < 8; ++i) {
    const Result& result = film.next(dot);
    if (i < 2) continue;
    for (const std::uint32_t id : {parked, mover}) {
      const ObjectResult* o = object_on(result, film.truth().ids, id);
      SCOPED_TRACE(std::to_string(i) + " body " + std::to_string(id) + ": " + describe(o));
      ASSERT_TRUE(o && o->reason == Reason::None);
      // A fiftieth of a pixel at 7 m is 0.7 mm sideways; along the ray a car 50 px wide scales by that for 6 mm.
      EXPECT_LT(shift_error(*o, film.T_o(id), film.before(id)).norm(), 0.01);
      const Vector3<double> w =
          dot::so3::log(dot::Matrix3<double>(film.T_o(id).R.transpose() * SE3d::from_row_major(o->T_o).R));
      EXPECT_LT(w.norm(), 1.5 * degree);
      EXPECT_NEAR(o->speed, id == mover ? 2 : 0, 0.2);
      EXPECT_NEAR(o->range, film.before(id).z(), 1.0);
      EXPECT_NEAR(o->interval, 0.1, kClockError);
      EXPECT_GE(o->n_points, o->n_inliers);
      EXPECT_GT(o->phi, 0.8);
      if (id == mover) {
        // 0.2 m at 6 m and less: at least 6 px.
        EXPECT_GT(o->disparity_px, 5);
        const SE3d T_c = film.T_c();
        const Vector3<double> v(T_c.R * (film.T_o(id) * film.before(id) - film.before(id)) / 0.1);
        EXPECT_LT((Eigen::Map<const Vector3<double>>(o->fused_velocity.data()) - v).norm(), 0.3);
      } else {
        EXPECT_LT(o->disparity_px, 0.5);
      }
    }
  }
}

// Stated sigmas hold what comes: image noise, and depth noise of the size that the options state, 1 % of each pixel and
// 0.5 % shared by the object.
TEST(Object, VelocityIsWithinItsSigma) {
  double chi2 = 0, largest_sigma = 0;
  int n = 0;
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    Film<> film = street();
    film.camera_path = straight(Vector3<double>::Zero(), {0, 0, 2});
    film.degradation.noise = 2;
    film.degradation.depth_noise = 0.01 / 7;
    film.degradation.seed = seed;
    Random random(seed);
    film.degradation.depth_bias = {{parked, random.normal(0.005 / 7)}, {mover, random.normal(0.005 / 7)}};
    Dot<> dot = make_dot();
    for (int i = 0; i < 6; ++i) {
      const Result& result = film.next(dot);
      if (i < 1) continue;
      for (const std::uint32_t id : {parked, mover}) {
        const ObjectResult* o = object_on(result, film.truth().ids, id);
        SCOPED_TRACE(std::to_string(i) + " body " + std::to_string(id) + ": " + describe(o));
        ASSERT_TRUE(o != nullptr);
        if (o->reason != Reason::None) continue;
        const Vector3<double> v(film.T_o(id) * film.before(id) - film.before(id));
        const Vector3<double> e(Eigen::Map<const Vector3<double>>(o->velocity.data()) - v / 0.1);
        const Eigen::Map<const dot::Matrix3<double>> V(o->velocity_covariance.data());
        EXPECT_LT((V - V.transpose()).norm(), 1e-9);
        chi2 += e.dot(V.ldlt().solve(e));
        largest_sigma = std::max(largest_sigma, std::sqrt(V.eigenvalues().real().maxCoeff()));
        ++n;
      }
    }
  }
  ASSERT_GE(n, 32);  // of 40
  // Three when honest. Sigma_x is inflated by 3, so less is expected; below a tenth it would tell nothing.
  EXPECT_LT(chi2 / n, 6);
  EXPECT_GT(chi2 / n, 0.1);
  EXPECT_LT(largest_sigma, 2);  // m/s
}

TEST(Camera, OfTheHostIsUsed) {
  Film<> film = street();
  film.camera_path = twisting({0, 0, 2}, {0, 0.1, 0});
  dot::CameraMotion motion;
  for (int k = 0; k < 6; ++k) motion.covariance[static_cast<std::size_t>(7 * k)] = k < 3 ? 1e-6 : 1e-8;
  film.edit = [&](int i, dot::Frame& frame) {
    if (i == 0) return;
    motion.T_cur_prev = film.T_c().row_major();
    frame.camera_motion = motion;
  };
  // The background tells nothing here: it has no texture at all.
  film.spoil = [](int, Rendering& seen) {
    for (int y = 0; y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == 0) seen.grey(x, y) = 90;
  };
  Dot<> dot = make_dot();
  for (int i = 0; i < 8; ++i) {
    const Result& result = film.next(dot);
    if (i == 0) continue;
    SCOPED_TRACE(i);
    ASSERT_EQ(result.camera.status, CameraStatus::FromHost);
    EXPECT_LT(error_of(result.camera.T_cur_prev, film.T_c()).norm(), 1e-9);
    EXPECT_EQ(result.camera.covariance, motion.covariance);
    if (i < 5) continue;
    const ObjectResult *still = object_on(result, film.truth().ids, parked),
                       *moves = object_on(result, film.truth().ids, mover);
    EXPECT_TRUE(still && still->state == State::Static) << describe(still);
    EXPECT_TRUE(moves && moves->state == State::Moving) << describe(moves);
  }
}

TEST(Camera, OfTheHostLeavesGainAndOffsetToUs) {
  Film<> film = street();
  film.camera_path = twisting({0, 0, 2}, {0, 0.1, 0});
  dot::CameraMotion motion;
  film.edit = [&](int i, dot::Frame& frame) {
    if (i == 0) return;
    motion.T_cur_prev = film.T_c().row_major();
    frame.camera_motion = motion;
  };
  Dot<> dot = make_dot();
  for (int i = 0; i < 5; ++i) film.next(dot);
  film.degradation.gain = 0.6;
  const Result& result = film.next(dot);
  EXPECT_NEAR(result.camera.gain, 0.6, 0.02);
  for (const int car : {parked, mover}) {
    const ObjectResult* object = object_on(result, film.truth().ids, car);
    EXPECT_TRUE(object && object->reason == Reason::None) << describe(object);
  }
}

/// Takes all depth away from the frames first to last, in the ways in which a frame may have none.
void blind(Film<>& film, int first, int last) {
  film.spoil = [=](int i, Rendering& seen) {
    if (i < first || i > last) return;
    seen.depth.fill((i - first) % 2 ? std::numeric_limits<float>::quiet_NaN() : 0.f);
  };
}

TEST(Depth, WithoutAnySoFarThereIsNoCameraMotion) {
  Film<> film = street();
  film.camera_path = twisting({0, 0, 2}, {0, 0, 0});
  blind(film, 0, 2);
  Dot<> dot = make_dot();
  for (int i = 0; i < 9; ++i) {
    const Result& result = film.next(dot);
    SCOPED_TRACE(i);
    // Depth is that of the reference: frame 3 has none before it.
    EXPECT_EQ(result.camera.status, i == 0  ? CameraStatus::FirstFrame
                                    : i < 4 ? CameraStatus::TooLittleDepth
                                            : CameraStatus::Tracked);
    EXPECT_EQ(result.too_little_depth, i < 3);
    if (i >= 4) {
      EXPECT_LT(error_of(result.camera.T_cur_prev, film.T_c()).norm(), 0.005);
    }
    for (const std::uint32_t id : {parked, mover}) {
      const ObjectResult* o = object_on(result, film.truth().ids, id);
      SCOPED_TRACE(describe(o));
      ASSERT_TRUE(o);
      EXPECT_EQ(o->id, id);  // ids of instances that are new in one frame are given in their order
      if (i < 4) {
        EXPECT_EQ(o->state, State::NotObservable);
      }
      if (i > 0 && i < 4) {
        EXPECT_EQ(o->reason, Reason::CameraLost);
      }
      if (i >= 4) {
        EXPECT_EQ(o->reason, Reason::None);
      }
      if (i >= 7) {
        EXPECT_EQ(o->state, id == mover ? State::Moving : State::Static);
      }
    }
  }
}

TEST(Depth, WithoutAnyForAWhileNothingIsForgotten) {
  Film<> film = street();
  film.camera_path = twisting({0, 0, 2}, {0, 0, 0});
  blind(film, 5, 6);
  Dot<> dot = make_dot();
  for (int i = 0; i < 12; ++i) {
    const Result& result = film.next(dot);
    SCOPED_TRACE(i);
    EXPECT_EQ(result.too_little_depth, i == 5 || i == 6);
    if (i == 0) continue;
    ASSERT_EQ(result.camera.status, CameraStatus::Tracked);
    EXPECT_LT(error_of(result.camera.T_cur_prev, film.T_c()).norm(), 0.005);
    for (const std::uint32_t id : {parked, mover}) {
      const ObjectResult* o = object_on(result, film.truth().ids, id);
      SCOPED_TRACE(describe(o));
      ASSERT_TRUE(o);
      EXPECT_EQ(o->id, id);
      if (i >= 5) {
        EXPECT_EQ(o->state, id == mover ? State::Moving : State::Static);
      }
      if (i >= 8 || i <= 5) {
        EXPECT_EQ(o->reason, Reason::None);
      }
    }
  }
}

// Glass and black paint: one car never has depth, all else has. It cannot be decided, but it is one car.
TEST(Depth, WithoutAnyOnAnObjectItKeepsItsId) {
  Film<> film = street();
  film.camera_path = twisting({0, 0, 2}, {0, 0, 0});
  film.spoil = [](int, Rendering& seen) {
    for (int y = 0; y < seen.ids.height(); ++y)
      for (int x = 0; x < seen.ids.width(); ++x)
        if (seen.ids(x, y) == parked) seen.depth(x, y) = 0;
  };
  Dot<> dot = make_dot();
  for (int i = 0; i < 7; ++i) {
    const Result& result = film.next(dot);
    SCOPED_TRACE(i);
    const ObjectResult *blind = object_on(result, film.truth().ids, parked),
                       *other = object_on(result, film.truth().ids, mover);
    ASSERT_TRUE(blind && other);
    EXPECT_EQ(blind->id, parked);
    EXPECT_EQ(blind->state, State::NotObservable);
    EXPECT_EQ(blind->reason, i == 0 ? Reason::New : Reason::TooLittleDepth) << describe(blind);
    EXPECT_EQ(other->id, mover);
    if (i >= 5) {
      EXPECT_EQ(other->state, State::Moving) << describe(other);
    }
  }
}

TEST(Depth, PixelsThatAreNoMeasurementAreAllAlike) {
  const float bad[] = {std::numeric_limits<float>::quiet_NaN(),
                       std::numeric_limits<float>::infinity(),
                       -std::numeric_limits<float>::infinity(),
                       -3.f,
                       std::numeric_limits<float>::max(),
                       std::numeric_limits<float>::denorm_min(),
                       -0.f};
  Film<> film = street();
  film.camera_path = twisting({0, 0, 2}, {0, 0, 0});
  film.degradation.missing_depth = 0.1;
  Dot<> dot = make_dot(), twin = make_dot();
  for (int i = 0; i < 5; ++i) {
    const Result& zeros = film.next(twin);
    Rendering other = film.seen();
    int n = 0;
    for (int y = 0; y < other.depth.height(); ++y)
      for (int x = 0; x < other.depth.width(); ++x)
        if (other.depth(x, y) == 0) other.depth(x, y) = bad[++n % 7];
    dot::Frame frame = film.frame();
    frame.depth = other.depth_ref();
    const Result& result = dot.track(frame);
    ASSERT_GT(n, 1000);
    EXPECT_EQ(result.camera.T_cur_prev, zeros.camera.T_cur_prev);
    ASSERT_EQ(result.objects.size, zeros.objects.size);
    for (std::size_t k = 0; k < result.objects.size; ++k) {
      EXPECT_EQ(result.objects[k].T_o, zeros.objects[k].T_o);
      EXPECT_EQ(result.objects[k].state, zeros.objects[k].state);
      EXPECT_EQ(result.objects[k].p_moving, zeros.objects[k].p_moving);
    }
  }
}

TEST(Time, AGapDropsReferencesAndKeepsIds) {
  Film<> film = street();
  double shift = 0;
  film.edit = [&](int, dot::Frame& frame) { frame.timestamp += shift; };
  Dot<> dot = make_dot();
  for (int i = 0; i < 12; ++i) {
    if (i == 6) shift = 1.05;  // with the regular interval more than a second
    const Result& result = film.next(dot);
    SCOPED_TRACE(i);
    EXPECT_EQ(result.camera.status, i == 0 || i == 6 ? CameraStatus::FirstFrame : CameraStatus::Tracked);
    EXPECT_NEAR(result.interval, i == 0 || i == 6 ? 0 : 0.1, kClockError);
    for (const std::uint32_t id : {parked, mover}) {
      const ObjectResult* o = object_on(result, film.truth().ids, id);
      SCOPED_TRACE(describe(o));
      ASSERT_TRUE(o);
      EXPECT_EQ(o->id, id);
      if (i == 6) {
        EXPECT_EQ(o->reason, Reason::NoReference);
      }
      if (i == 7) {
        EXPECT_EQ(o->reason, Reason::None);
      }
      if (i >= 4) {
        EXPECT_EQ(o->state, id == mover ? State::Moving : State::Static);
      }
    }
  }
}

}  // namespace
