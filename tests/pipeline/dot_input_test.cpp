// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Bad arguments are refused by name and leave the tracker as it was; odd but good ones are taken.

#include <gtest/gtest.h>

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
    {"DepthNoUnits", "frame.depth",
     [](Frame& f, Instance*) { f.depth.format = PixelFormat::DepthU16, f.depth.depth_units_per_metre = 0; }},
    {"DepthNegativeUnits", "frame.depth",
     [](Frame& f, Instance*) { f.depth.format = PixelFormat::DepthU16, f.depth.depth_units_per_metre = -256; }},
    {"DepthNanUnits", "frame.depth",
     [](Frame& f, Instance*) { f.depth.format = PixelFormat::DepthU16, f.depth.depth_units_per_metre = nan; }},
    {"TimeNan", "frame.timestamp", [](Frame& f, Instance*) { f.timestamp = nan; }},
    {"TimeInfinite", "frame.timestamp", [](Frame& f, Instance*) { f.timestamp = inf; }},
    {"TimeEqual", "frame.timestamp", [](Frame& f, Instance*) { f.timestamp = 0.1; }, false},
    {"TimeBackwards", "frame.timestamp", [](Frame& f, Instance*) { f.timestamp = 0.05; }, false},
    {"IdsNoWidth", "frame.masks.ids", [](Frame& f, Instance*) { f.masks->ids.width = 0; }},
    {"IdsOtherSize", "frame.masks.ids", [](Frame& f, Instance*) { f.masks->ids.height = 119; }},
    {"IdsFormat", "frame.masks.ids", [](Frame& f, Instance*) { f.masks->ids.format = PixelFormat::DepthF32; }},
    {"IdsStride", "frame.masks.ids", [](Frame& f, Instance*) { f.masks->ids.stride = 639; }},
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

TEST(Input, OnlyEntropiesAndADirectionMayBeNegative) {
  Options options;
  for_each_option(options, [&](const char* name, auto& value) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, bool>) {
      const std::string setting = name, room = setting.substr(0, setting.find('.') + 1);
      const bool may = room == "entropy." || setting.find(".up_") != std::string::npos;
      const auto good = value;
      value = -1;
      const std::string message = refusal([&] { Tracker(tiny_camera(), options); });
      EXPECT_EQ(message.rfind("options." + setting + ":", 0) == 0, !may) << message;
      value = good;
    }
  });
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
