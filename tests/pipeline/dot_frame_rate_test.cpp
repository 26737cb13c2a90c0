// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// The same seconds give the same answers at any frame rate.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "dot/motion/belief.hpp"
#include "dot/tracker.hpp"
#include "support/film.hpp"

namespace {

using dot::ObjectResult;
using dot::Result;
using dot::State;
using dot::Tracker;
using namespace dot::test;

constexpr std::uint32_t parked = 1, crossing = 2, slow = 3;

/// What is said of a body at some time.
struct Said {
  State state = State::Background;
  double speed = 0;     ///< m/s, fused
  double variance = 0;  ///< (m/s)^2, of the fused velocity between what it is just after a fit and just before the next
};

/// What is said of each body every half second.
std::map<std::uint32_t, std::vector<Said>> said_at(double rate) {
  Film<> film;
  film.interval = 1 / rate;
  film.camera_path = straight({0, 0, 0}, {0, 0, 0.6});
  film.degradation.noise = 1;
  film.degradation.depth_noise = 0.001;
  film.add(parked, straight({2.4, 1.3, 9}));
  film.add(crossing, straight({-3.5, 1.3, 8}, {1.2, 0, 0}));
  film.add(slow, straight({0.7, 1.3, 6}, {0, 0, 1.2}));
  dot::Options options;
  options.depth_noise.source = dot::DepthSource::Stereo;
  Tracker tracker(small_camera(), options);
  std::map<std::uint32_t, std::vector<Said>> out;
  const int frames = static_cast<int>(std::lround(2 * rate)) + 1, half = static_cast<int>(std::lround(0.5 * rate));
  for (int i = 0; i < frames; ++i) {
    const Result& result = film.next(tracker);
    // A frame rate of 5 has no frame at half a second.
    if (i == 0 || i % half != 0 || (rate < 10 && i != frames - 1)) continue;
    for (const std::uint32_t body : {parked, crossing, slow}) {
      Said s;
      if (const ObjectResult* o = object_on(result, film.truth().ids, body)) {
        s.state = o->state;
        s.speed = std::hypot(o->fused_velocity[0], o->fused_velocity[1], o->fused_velocity[2]);
        // What is reported allows for an interval of acceleration since the fit, which depends on the rate.
        const double before = o->fused_covariance[0] + o->fused_covariance[4] + o->fused_covariance[8];
        const double acceleration = options.velocity.usual_acceleration_at(o->range);
        const double change = 3 * acceleration * acceleration * dot::Belief::kAccelerationSeconds / rate;
        s.variance = std::sqrt(before * (before - change));
      }
      out[body].push_back(s);
    }
  }
  return out;
}

TEST(FrameRate, DecisionsAndVelocitiesAreThoseOfTheTime) {
  const auto at_10 = said_at(10);
  for (const double rate : {5.0, 30.0, 60.0}) {
    SCOPED_TRACE(std::to_string(rate) + " Hz");
    for (const auto& [body, said] : said_at(rate)) {
      const std::vector<Said>& expected = at_10.at(body);
      for (std::size_t i = 0; i < said.size(); ++i) {
        const Said& e = rate < 10 ? expected.back() : expected[i];
        SCOPED_TRACE("body " + std::to_string(body) + ", " + std::to_string(0.5 * static_cast<double>(i + 1)) + " s");
        EXPECT_EQ(said[i].state, e.state);
        EXPECT_NEAR(said[i].speed, e.speed, 0.3);
        EXPECT_LT(said[i].variance, 2 * e.variance);
        EXPECT_GT(said[i].variance, e.variance / 2);
      }
    }
  }
}

}  // namespace
