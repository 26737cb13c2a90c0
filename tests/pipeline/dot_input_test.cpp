// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Bad arguments are refused by name and leave the tracker as it was; odd but good ones are taken.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "dot/frame/validate.hpp"
#include "dot/tracker.hpp"
#include "support/film.hpp"

namespace {

using dot::Frame;
using dot::Image;
using dot::ImageRef;
using dot::Instance;
using dot::Intrinsics;
using dot::Options;
using dot::PixelFormat;
using dot::Result;
using dot::Tracker;
using dot::Vector3;
using namespace dot::test;

const double nan = std::numeric_limits<double>::quiet_NaN();
const double inf = std::numeric_limits<double>::infinity();

Intrinsics tiny_camera() { return {100, 100, 79.5, 59.5, 160, 120, 0.2}; }

Film<> tiny_film() {
  Film<> film{dot::Pinhole(tiny_camera())};
  film.camera_path = straight(Vector3<double>::Zero(), {0, 0, 2});
  film.add(1, straight({-1.2, 1.1, 5}));
  film.add(2, straight({0.8, 1.1, 4.5}, {1, 0, 0}));
  return film;
}

template <typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  } catch (const std::exception& error) {
    return std::string("another exception: ") + error.what();
  }
  return "accepted";
}

/// Everything of a result that does not depend on the clock, as text.
std::string digest(const Result& result) {
  std::string out;
  const auto add = [&](const auto& values) {
    for (const auto& value : values) out += std::to_string(value) + " ";
  };
  for (int y = 0; y < result.labels.height; ++y) {
    out.append(reinterpret_cast<const char*>(result.labels.row(y)), 160);
    out.append(reinterpret_cast<const char*>(result.ids.row(y)), 160 * sizeof(std::uint32_t));
  }
  out += to_string(result.camera.status);
  add(result.camera.T_cur_prev);
  add(result.camera.covariance);
  for (const dot::ObjectResult& o : result.objects) {
    out += std::to_string(o.id) + to_string(o.state) + to_string(o.reason) + std::to_string(o.p_moving) + " ";
    add(o.T_o);
    add(o.velocity_covariance);
    add(o.fused_velocity);
  }
  return out;
}

struct BadFrame {
  const char* name;
  const char* field;                             // that the message must begin with
  std::function<void(Frame&, Instance*)> spoil;  // given the frame's two instances as well
  bool in_first_frame = true;                    // wrong in the first frame, too

  friend std::ostream& operator<<(std::ostream& out, const BadFrame& bad) { return out << bad.name; }
};

std::function<void(Frame&, Instance*)> motion(const std::function<void(dot::CameraMotion&)>& change) {
  return [=](Frame& frame, Instance*) {
    frame.camera_motion = dot::CameraMotion{};
    change(*frame.camera_motion);
  };
}

std::function<void(Frame&, Instance*)> prior(std::size_t element, double value) {
  return [=](Frame& frame, Instance*) {
    frame.camera_prior = dot::CameraMotion{}.T_cur_prev;
    (*frame.camera_prior)[element] = value;
  };
}

const std::vector<BadFrame> bad_frames{
    {"ImageNull", "frame.image", [](Frame& f, Instance*) { f.image.data = nullptr; }},
    {"ImageNoWidth", "frame.image", [](Frame& f, Instance*) { f.image.width = 0; }},
    {"ImageNegativeHeight", "frame.image", [](Frame& f, Instance*) { f.image.height = -120; }},
    {"ImageOtherWidth", "frame.image", [](Frame& f, Instance*) { f.image.width = 159; }},
    {"ImageOtherHeight", "frame.image", [](Frame& f, Instance*) { f.image.height = 60; }},
    {"ImageFormat", "frame.image", [](Frame& f, Instance*) { f.image.format = PixelFormat::DepthU16; }},
    {"ImageUnknownFormat", "frame.image", [](Frame& f, Instance*) { f.image.format = static_cast<PixelFormat>(200); }},
    {"ImageStride", "frame.image", [](Frame& f, Instance*) { f.image.stride = 159; }},
    {"ImageStrideOfColour", "frame.image", [](Frame& f, Instance*) { f.image.format = PixelFormat::Bgr8; }},
    {"ImageNoStride", "frame.image", [](Frame& f, Instance*) { f.image.stride = 0; }},
    {"DepthNull", "frame.depth", [](Frame& f, Instance*) { f.depth = {}; }},
    {"DepthNoHeight", "frame.depth", [](Frame& f, Instance*) { f.depth.height = 0; }},
    {"DepthOtherSize", "frame.depth", [](Frame& f, Instance*) { f.depth.width = 80; }},
    {"DepthFormat", "frame.depth", [](Frame& f, Instance*) { f.depth.format = PixelFormat::Grey8; }},
    {"DepthStride", "frame.depth", [](Frame& f, Instance*) { f.depth.stride = 160; }},
    {"DepthOddStride", "frame.depth: stride", [](Frame& f, Instance*) { f.depth.stride += 2; }},
    {"DepthUnaligned", "frame.depth: data",
     [](Frame& f, Instance*) { f.depth.data = static_cast<const char*>(f.depth.data) + 1; }},
    {"DepthNoUnits", "frame.depth",
     [](Frame& f, Instance*) { f.depth.format = PixelFormat::DepthU16, f.depth.depth_units_per_metre = 0; }},
    {"DepthNegativeUnits", "frame.depth",
     [](Frame& f, Instance*) { f.depth.format = PixelFormat::DepthU16, f.depth.depth_units_per_metre = -256; }},
    {"DepthNanUnits", "frame.depth",
     [](Frame& f, Instance*) { f.depth.format = PixelFormat::DepthU16, f.depth.depth_units_per_metre = nan; }},
    {"TimeNan", "frame.timestamp", [](Frame& f, Instance*) { f.timestamp = nan; }},
    {"TimeInfinite", "frame.timestamp", [](Frame& f, Instance*) { f.timestamp = inf; }},
    {"TimeEqual", "frame.timestamp", [](Frame& f, Instance*) { f.timestamp = 1.7e9 + 0.1; }, false},
    {"TimeBackwards", "frame.timestamp", [](Frame& f, Instance*) { f.timestamp -= 0.15; }, false},
    {"IdsNoWidth", "frame.masks.ids", [](Frame& f, Instance*) { f.masks->ids.width = 0; }},
    {"IdsOtherSize", "frame.masks.ids", [](Frame& f, Instance*) { f.masks->ids.height = 119; }},
    {"IdsFormat", "frame.masks.ids", [](Frame& f, Instance*) { f.masks->ids.format = PixelFormat::DepthF32; }},
    {"IdsStride", "frame.masks.ids", [](Frame& f, Instance*) { f.masks->ids.stride = 639; }},
    {"IdsOddStride", "frame.masks.ids: stride", [](Frame& f, Instance*) { f.masks->ids.stride = 642; }},
    {"IdsUnaligned", "frame.masks.ids: data",
     [](Frame& f, Instance*) { f.masks->ids.data = static_cast<const char*>(f.masks->ids.data) + 2; }},
    {"InstanceWithoutMask", "frame.masks.instances[0]", [](Frame& f, Instance*) { f.masks->ids = {}; }},
    {"InstanceFormat", "frame.masks.instances[1].mask",
     [](Frame&, Instance* i) { i[1].mask.format = PixelFormat::Id16; }},
    {"InstanceStride", "frame.masks.instances[1].mask", [](Frame&, Instance* i) { i[1].mask.stride = 3; }},
    {"InstanceNoSize", "frame.masks.instances[1].mask", [](Frame&, Instance* i) { i[1].mask.height = 0; }},
    {"MotionNan", "frame.camera_motion.T_cur_prev", motion([](dot::CameraMotion& m) { m.T_cur_prev[3] = nan; })},
    {"MotionScaled", "frame.camera_motion.T_cur_prev", motion([](dot::CameraMotion& m) { m.T_cur_prev[0] = 1.01; })},
    {"MotionSheared", "frame.camera_motion.T_cur_prev", motion([](dot::CameraMotion& m) { m.T_cur_prev[1] = 0.01; })},
    {"MotionMirrored", "frame.camera_motion.T_cur_prev", motion([](dot::CameraMotion& m) { m.T_cur_prev[0] = -1; })},
    {"MotionCovariance", "frame.camera_motion.covariance", motion([](dot::CameraMotion& m) { m.covariance[8] = inf; })},
    {"MotionFar", "frame.camera_motion.T_cur_prev", motion([](dot::CameraMotion& m) { m.T_cur_prev[11] = 1e308; })},
    {"CovarianceNegative", "frame.camera_motion.covariance: element (0, 0)",
     motion([](dot::CameraMotion& m) { m.covariance[0] = -1e-3; })},
    {"CovarianceHuge", "frame.camera_motion.covariance: element (2, 2)",
     motion([](dot::CameraMotion& m) { m.covariance[14] = 1e100; })},
    {"CovarianceOfAnyRotation", "frame.camera_motion.covariance: element (4, 4)",
     motion([](dot::CameraMotion& m) { m.covariance[28] = 11; })},
    {"CovarianceAsymmetric", "frame.camera_motion.covariance: must be sym",
     motion([](dot::CameraMotion& m) { m.covariance[0] = m.covariance[7] = 1e-4, m.covariance[1] = 1e-5; })},
    {"CovarianceWithoutVariance", "frame.camera_motion.covariance: must be pos",
     motion([](dot::CameraMotion& m) { m.covariance[1] = m.covariance[6] = 1e-5; })},
    {"CovarianceIndefinite", "frame.camera_motion.covariance: must be pos", motion([](dot::CameraMotion& m) {
       // Each pair of correlations is possible, all three together are not.
       for (std::size_t i = 0; i < 6; ++i) m.covariance[7 * i] = 1e-4;
       m.covariance[1] = m.covariance[6] = m.covariance[2] = m.covariance[12] = 0.9e-4;
       m.covariance[8] = m.covariance[13] = -0.9e-4;
     })},
    {"PriorFar", "frame.camera_prior", prior(3, -1e30)},
    {"PriorNan", "frame.camera_prior", prior(7, nan)},
    {"PriorScaled", "frame.camera_prior", prior(5, 1.01)},
};

class BadFrameTest : public testing::TestWithParam<BadFrame> {};

TEST_P(BadFrameTest, IsRefusedByNameAndChangesNothing) {
  const BadFrame& bad = GetParam();
  Image<std::uint8_t> mask(20, 20);
  mask.fill(1);
  // An id image and a list: one instance of the image, one with a mask of its own.
  std::vector<Instance> list(2);
  list[0].id = 1;
  list[1].id = 50;
  list[1].mask = {mask.row(0), 20, 20, 20, PixelFormat::Grey8};
  Film<> film = tiny_film();
  film.edit = [&](int, Frame& frame) { frame.masks->instances = {list.data(), 2}; };
  Tracker tracker(tiny_camera()), twin(tiny_camera());
  for (int i = 0; i < 4; ++i) {
    const std::string good = digest(film.next(twin));
    if ((i == 0 && bad.in_first_frame) || i == 2) {
      Frame frame = film.frame();
      std::vector<Instance> other = list;
      frame.masks->instances = {other.data(), 2};
      bad.spoil(frame, other.data());
      const std::string message = refusal([&] { tracker.track(frame); });
      EXPECT_EQ(message.rfind(bad.field, 0), 0u) << "frame " << i << ": " << message;
      EXPECT_GT(message.size(), std::strlen(bad.field) + 5) << message;  // and says what is wrong
    }
    ASSERT_TRUE(digest(tracker.track(film.frame())) == good) << "frame " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Input, BadFrameTest, testing::ValuesIn(bad_frames),
                         [](const auto& test) { return std::string(test.param.name); });

// Covariances that are good though no inverse exists, or though they were rounded.
TEST(Input, DegenerateCovariancesAreTaken) {
  std::array<double, 36> planar{}, rounded{}, one_direction{};
  for (const std::size_t i : {0, 2, 4}) planar[7 * i] = 1e-4;
  const std::array<double, 6> along{0.1, -0.2, 0.05, 1e-3, 0, 2e-3};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      one_direction[6 * i + j] = along[i] * along[j];
      rounded[6 * i + j] = static_cast<double>(static_cast<float>(along[i] * along[j])) + (i == j ? 1e-12 : 0);
    }
  for (const auto& covariance : {planar, rounded, one_direction, std::array<double, 36>{}})
    EXPECT_EQ(refusal([&] { dot::validate_covariance("covariance", covariance); }), "accepted");
}

/// A colour image of four or three channels from the frame's grey one, tinted so that the channels differ.
std::vector<std::uint8_t> coloured(const Image<std::uint8_t>& grey, int channels, int stride) {
  std::vector<std::uint8_t> out(static_cast<std::size_t>(stride * grey.height()), 0);
  for (int y = 0; y < grey.height(); ++y)
    for (int x = 0; x < grey.width(); ++x) {
      std::uint8_t* pixel = out.data() + y * stride + channels * x;
      pixel[0] = static_cast<std::uint8_t>(grey(x, y) / 2), pixel[1] = grey(x, y);
      pixel[2] = static_cast<std::uint8_t>(255 - grey(x, y) / 3);
      if (channels == 4) pixel[3] = 255;
    }
  return out;
}

/// Noise in three channels, with rows that are four bytes a pixel apart, or in three of four channels.
std::vector<std::uint8_t> noisy(int channels, double brightest, std::uint8_t alpha = 0) {
  Random random(7);
  std::vector<std::uint8_t> out(std::size_t{4} * 160 * 120);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = channels == 4 && i % 4 == 3 ? alpha : static_cast<std::uint8_t>(random.uniform(0, brightest));
  return out;
}

TEST(Input, FourChannelsSaidToBeThreeAreRefused) {
  Film<> film = tiny_film();
  Tracker tracker(tiny_camera());
  Frame frame = film.advance();
  const std::vector<std::uint8_t> bgra = coloured(film.seen().grey, 4, 4 * 160);
  for (const PixelFormat format : {PixelFormat::Bgr8, PixelFormat::Rgb8}) {
    frame.image = {bgra.data(), 160, 120, 4 * 160, format};
    EXPECT_EQ(refusal([&] { tracker.track(frame); }).rfind("frame.image: ", 0), 0u);
  }
  for (const std::uint8_t alpha : {std::uint8_t{0}, std::uint8_t{255}})
    for (const double brightest : {10.0, 255.0}) {
      const std::vector<std::uint8_t> noise = noisy(4, brightest, alpha);
      frame.image = {noise.data(), 160, 120, 4 * 160, PixelFormat::Bgr8};
      EXPECT_EQ(refusal([&] { tracker.track(frame); }).rfind("frame.image: ", 0), 0u) << +alpha << ", " << brightest;
    }
  frame.image = {bgra.data(), 160, 120, 4 * 160, PixelFormat::Bgra8};
  EXPECT_EQ(refusal([&] { tracker.track(frame); }), "accepted");
}

// Three quarters of a wider image have rows that are four bytes a pixel apart.
TEST(Input, ACropOfThreeChannelsIsTaken) {
  Film<> film = tiny_film();
  Tracker tracker(tiny_camera());
  for (int i = 0; i < 3; ++i) {
    Frame frame = film.advance();
    const std::vector<std::uint8_t> bgr = coloured(film.seen().grey, 3, 4 * 160);
    frame.image = {bgr.data(), 160, 120, 4 * 160, PixelFormat::Bgr8};
    EXPECT_EQ(refusal([&] { tracker.track(frame); }), "accepted");
  }
  // At night, of a white wall, and of noise nothing tells how many channels there are.
  for (const auto& pixels : {std::vector<std::uint8_t>(std::size_t{4} * 160 * 120, 0),
                             std::vector<std::uint8_t>(std::size_t{4} * 160 * 120, 255), noisy(3, 10), noisy(3, 255)}) {
    Frame frame = film.advance();
    frame.image = {pixels.data(), 160, 120, 4 * 160, PixelFormat::Bgr8};
    EXPECT_EQ(refusal([&] { tracker.track(frame); }), "accepted");
  }
}

TEST(Input, TheLastResultOutlivesARefusal) {
  Film<> film = tiny_film();
  Tracker tracker(tiny_camera());
  film.next(tracker);
  const Result& result = film.next(tracker);
  const std::string before = digest(result);
  Frame frame = film.frame();
  EXPECT_NE(refusal([&] { tracker.track(frame); }), "accepted");  // the same time again
  EXPECT_TRUE(digest(result) == before);
}

TEST(Input, EveryOptionMustBeFinite) {
  std::set<std::string> names;
  Options options;
  for_each_option(options, [&](const char* name, auto& value) {
    EXPECT_TRUE(names.insert(name).second) << name << " is listed twice";
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
      const double good = value;
      for (const double bad : {nan, inf, -inf}) {
        value = bad;
        const std::string message = refusal([&] { Tracker(tiny_camera(), options); });
        EXPECT_EQ(message.rfind("options." + std::string(name) + ":", 0), 0u) << name << ": " << message;
      }
      value = good;
    }
  });
  EXPECT_GT(names.size(), 40u);
  EXPECT_EQ(refusal([&] { Tracker(tiny_camera(), options); }), "accepted");
}

TEST(Input, OnlyAnEntropyAndADirectionMayBeNegative) {
  Options options;
  for_each_option(options, [&](const char* name, auto& value) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, bool>) {
      const std::string setting = name;
      const bool may = setting.find("_entropy") != std::string::npos || setting.find(".up_") != std::string::npos;
      const auto good = value;
      value = -1;
      const std::string message = refusal([&] { Tracker(tiny_camera(), options); });
      EXPECT_EQ(message.rfind("options." + setting + ":", 0) == 0, !may) << message;
      value = good;
    }
  });
}

TEST(Input, EveryOptionHasARange) {
  Options options;
  int refused = 0;
  for_each_option_range(options, [&](const char* name, auto& value, dot::OptionRange range) {
    using Value = std::decay_t<decltype(value)>;
    EXPECT_LE(range.low, static_cast<double>(value)) << name;
    EXPECT_GE(range.high, static_cast<double>(value)) << name;
    if constexpr (!std::is_same_v<Value, bool>) {
      const Value good = value;
      const double step = std::is_same_v<Value, int> ? 1 : 1e-6;
      for (const double bad : {range.low - step * std::max(1.0, std::abs(range.low)), range.high * 1.001 + step}) {
        value = static_cast<Value>(bad);
        const std::string message = refusal([&] { Tracker(tiny_camera(), options); });
        EXPECT_EQ(message.rfind("options." + std::string(name) + ":", 0), 0u)
            << name << " = " << bad << ": " << message;
        ++refused;
      }
      value = good;
    }
  });
  EXPECT_GT(refused, 120);
}

// What is in range may be a bad idea, but gives finite numbers.
TEST(Input, EveryOptionWorksAtTheEndsOfItsRange) {
  std::vector<Frame> frames;
  Film<> film = tiny_film();
  film.degradation.noise = 1;
  std::vector<Rendering> seen;
  for (int i = 0; i < 6; ++i) film.advance(), seen.push_back(film.seen());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    Frame frame;
    frame.timestamp = 1.7e9 + 0.1 * static_cast<double>(i);
    frame.image = seen[i].image_ref(), frame.depth = seen[i].depth_ref();
    if (i != 3) frame.masks = dot::Masks{seen[i].ids_ref(), {}};
    frames.push_back(frame);
  }
  const auto all_finite = [](const auto& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  };
  Options options;
  for (const dot::DepthSource source : {dot::DepthSource::Stereo, dot::DepthSource::Unknown}) {
    options.depth_noise.source = source;
    options.discover_unknown = source == dot::DepthSource::Stereo;
    for_each_option_range(options, [&](const char* name, auto& value, dot::OptionRange range) {
      const auto good = value;
      for (const double end : {range.low, range.high}) {
        const bool refuses_the_masks = std::string(name) == "mask.max_instances" && end < 2;
        if (refuses_the_masks || std::string(name) == "threads") continue;
        value = static_cast<std::decay_t<decltype(value)>>(end);
        SCOPED_TRACE(std::string(name) + " = " + std::to_string(end));
        const bool decides = options.velocity.decide > 0.5 && options.velocity.decide < 1;
        if (!decides || options.velocity.keep > options.velocity.decide) continue;  // refused: between the two
        Tracker tracker(tiny_camera(), options);
        for (const Frame& frame : frames) {
          const Result& result = tracker.track(frame);
          EXPECT_TRUE(all_finite(result.camera.T_cur_prev) && all_finite(result.camera.covariance));
          for (const dot::ObjectResult& o : result.objects) {
            EXPECT_TRUE(std::isfinite(o.p_moving) && std::isfinite(o.speed) && std::isfinite(o.entropy));
            EXPECT_TRUE(all_finite(o.velocity) && all_finite(o.angular_velocity) && all_finite(o.velocity_covariance) &&
                        all_finite(o.covariance));
            EXPECT_TRUE(all_finite(o.fused_velocity) && all_finite(o.fused_covariance) && all_finite(o.T_o));
          }
        }
      }
      value = good;
    });
  }
}

TEST(Input, OptionsOutOfRangeAreNamed) {
  struct Bad {
    const char* name;
    double value;
  };
  for (const Bad& bad : {Bad{"selection.background_points", 0},
                         {"selection.background_points", -5},
                         {"selection.object_points", 0},
                         {"object.max_acceleration", 0},
                         {"selection.max_depth", 0},
                         {"selection.max_depth", -1},
                         {"selection.window_radius", 0},
                         {"selection.window_radius", 51},
                         {"align.max_levels", 0},
                         {"align.max_iterations", 0},
                         {"align.huber", 0},
                         {"align.tukey", -4},
                         {"align.min_intensity_sigma", 0},
                         {"depth_noise.stereo_sigma_px", 0},
                         {"depth_noise.unknown_relative", -0.01},
                         {"motion_prior.rotation", 0},
                         {"motion_prior.velocity", 0},
                         {"velocity.v0", 0},
                         {"velocity.v0", -0.5},
                         {"velocity.prior_speed", 0},
                         {"velocity.decide", 0.5},
                         {"velocity.decide", 1},
                         {"velocity.keep", 0.4},
                         {"velocity.keep", 0.99},
                         {"max_gap", 0},
                         {"max_gap", -1},
                         {"threads", 0},
                         {"camera.search_turn", -1e-6},
                         {"velocity.v0", 1e-12},
                         {"velocity.tail_share", 1.5},
                         {"object.min_inlier_share", 2},
                         {"selection.min_gradient", 1e6},
                         {"mask.max_instances", 0},
                         {"mask.late_seconds", -0.1}}) {
    Options options;
    bool found = false;
    for_each_option(options, [&](const char* name, auto& value) {
      if (std::string(name) != bad.name) return;
      found = true;
      value = static_cast<std::decay_t<decltype(value)>>(bad.value);
    });
    EXPECT_TRUE(found) << bad.name;
    const std::string message = refusal([&] { Tracker(tiny_camera(), options); });
    EXPECT_EQ(message.rfind("options." + std::string(bad.name) + ":", 0), 0u)
        << bad.name << " = " << bad.value << ": " << message;
  }
}

TEST(Input, BadIntrinsicsAreNamed) {
  struct Bad {
    const char* field;
    std::function<void(Intrinsics&)> spoil;
  };
  const std::vector<Bad> cases{{"fx", [](Intrinsics& c) { c.fx = 0; }},
                               {"fx", [](Intrinsics& c) { c.fx = nan; }},
                               {"fx", [](Intrinsics& c) { c.fx = 1e-300; }},
                               {"fy", [](Intrinsics& c) { c.fy = 1e300; }},
                               {"cx", [](Intrinsics& c) { c.cx = -1e300; }},
                               {"width", [](Intrinsics& c) { c.width = 1 << 30; }},
                               {"baseline", [](Intrinsics& c) { c.baseline = 1e-300; }},
                               {"fy", [](Intrinsics& c) { c.fy = -100; }},
                               {"fy", [](Intrinsics& c) { c.fy = inf; }},
                               {"cx", [](Intrinsics& c) { c.cx = nan; }},
                               {"cy", [](Intrinsics& c) { c.cy = inf; }},
                               {"width", [](Intrinsics& c) { c.width = 15; }},
                               {"height", [](Intrinsics& c) { c.height = 0; }},
                               {"baseline", [](Intrinsics& c) { c.baseline = -0.1; }},
                               {"baseline", [](Intrinsics& c) { c.baseline = nan; }}};
  for (const Bad& bad : cases) {
    Intrinsics camera = tiny_camera();
    bad.spoil(camera);
    const std::string message = refusal([&] { Tracker tracker(camera); });
    EXPECT_NE(message.find("intrinsics." + std::string(bad.field)), std::string::npos) << bad.field << ": " << message;
  }
}

/// The same pixels with rows that lie apart, upside down if `stride` is negative.
template <typename T>
struct Strided {
  std::vector<unsigned char> bytes;
  ImageRef ref;

  Strided(const ImageRef& in, std::ptrdiff_t stride) : ref(in) {
    const std::size_t row = static_cast<std::size_t>(in.width) * sizeof(T),
                      step = static_cast<std::size_t>(std::abs(stride));
    bytes.assign(step * static_cast<std::size_t>(in.height), 0xee);
    unsigned char* first = bytes.data() + (stride < 0 ? step * static_cast<std::size_t>(in.height - 1) : 0);
    for (int y = 0; y < in.height; ++y)
      std::memcpy(first + y * stride, static_cast<const unsigned char*>(in.data) + y * in.stride, row);
    ref.data = first;
    ref.stride = stride;
  }
};

TEST(Input, AnyStrideGivesTheSame) {
  for (const std::ptrdiff_t sign : {1, -1}) {
    SCOPED_TRACE(sign);
    Film<> film = tiny_film();
    Tracker tracker(tiny_camera()), twin(tiny_camera());
    for (int i = 0; i < 4; ++i) {
      const std::string expected = digest(film.next(twin));
      Frame frame = film.frame();
      const Strided<std::uint8_t> image(frame.image, sign * 192);
      const Strided<float> depth(frame.depth, sign * 700);
      const Strided<std::uint32_t> ids(frame.masks->ids, sign * 704);
      frame.image = image.ref, frame.depth = depth.ref, frame.masks->ids = ids.ref;
      std::string got;
      ASSERT_NO_THROW(got = digest(tracker.track(frame)));
      EXPECT_TRUE(got == expected) << "frame " << i;
    }
  }
}

// An id image and lists of cropped masks are two ways to say one thing; so are the widths of ids.
TEST(Input, MasksMayComeInAnyForm) {
  Film<> film = tiny_film();
  Tracker by_image(tiny_camera()), by_list(tiny_camera()), by_bytes(tiny_camera()), by_words(tiny_camera());
  for (int i = 0; i < 5; ++i) {
    const std::string expected = digest(film.next(by_image));
    const Image<std::uint32_t>& ids = film.seen().ids;
    // The one as a mask of the whole frame, the other as a crop that hangs out of the frame by ten rows.
    Image<std::uint8_t> whole(160, 120), crop(160, 90), bytes(160, 120);
    Image<std::uint16_t> words(160, 120);
    crop.fill(1);
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 160; ++x) {
        const std::uint32_t id = ids(x, y);
        whole(x, y) = id == 1 ? 255 : 0;
        if (y >= 40) crop(x, y - 40) = id == 2 ? 1 : 0;
        ASSERT_TRUE(y >= 40 || id != 2);
        bytes(x, y) = static_cast<std::uint8_t>(id), words(x, y) = static_cast<std::uint16_t>(id);
      }
    std::vector<Instance> list(2);
    list[0].id = 1, list[0].mask = {whole.row(0), 160, 120, 160, PixelFormat::Grey8};
    list[1].id = 2, list[1].mask = {crop.row(0), 160, 90, 160, PixelFormat::Id8}, list[1].y = 40;
    Frame frame = film.frame();
    frame.masks = dot::Masks{{}, {list.data(), list.size()}};
    EXPECT_TRUE(digest(by_list.track(frame)) == expected) << "frame " << i;
    frame.masks = dot::Masks{{bytes.row(0), 160, 120, 160, PixelFormat::Id8}, {}};
    EXPECT_TRUE(digest(by_bytes.track(frame)) == expected) << "frame " << i;
    frame.masks = dot::Masks{{words.row(0), 160, 120, 320, PixelFormat::Id16}, {}};
    EXPECT_TRUE(digest(by_words.track(frame)) == expected) << "frame " << i;
  }
}

// An instance outside the frame, an empty one and one that no id of the image has are no objects.
TEST(Input, InstancesWithoutPixelsAreNoObjects) {
  Film<> film = tiny_film();
  Image<std::uint8_t> full(20, 20), empty(20, 20);
  full.fill(1), empty.fill(0);
  std::vector<Instance> list(3);
  list[0].id = 40, list[0].mask = {full.row(0), 20, 20, 20, PixelFormat::Grey8}, list[0].x = 160, list[0].y = -20;
  list[1].id = 41, list[1].mask = {empty.row(0), 20, 20, 20, PixelFormat::Grey8};
  list[2].id = 42;
  film.edit = [&](int, Frame& frame) { frame.masks->instances = {list.data(), list.size()}; };
  Tracker tracker(tiny_camera());
  for (int i = 0; i < 3; ++i) EXPECT_EQ(film.next(tracker).objects.size, 2u);
}

TEST(Input, AFrameWithoutObjectsIsFine) {
  Film<> film = tiny_film();
  film.edit = [](int i, Frame& frame) {
    frame.masks = dot::Masks{};
    if (i % 2) frame.masks.reset();
  };
  Tracker tracker(tiny_camera());
  for (int i = 0; i < 4; ++i) {
    const Result& result = film.next(tracker);
    EXPECT_TRUE(result.objects.empty());
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 160; ++x) ASSERT_EQ(result.labels(x, y) + result.ids(x, y), 0u);
    if (i > 0) {
      EXPECT_EQ(result.camera.status, dot::CameraStatus::Tracked);
    }
  }
}

}  // namespace
