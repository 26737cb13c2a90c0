// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/late_masks/late_masks.hpp"

#include <gtest/gtest.h>

#include <iterator>

#include "support/iou.hpp"
#include "support/stage_street.hpp"

// Masks of a past frame, taken to the present without a pipeline about them.

namespace {

using namespace dot::test;
using dot::CameraStatus;
using dot::DepthNoise;
using dot::DirectAligner;
using dot::LateMasks;
using dot::Masks;
using dot::ObjectReference;
using dot::Pinhole;
using dot::Track;
using dot::Vector3;
using dot::VelocityClassifier;

/// Keeps its frames for late masks.
struct Street : StageStreet {
  LateMasks<Pinhole, VelocityClassifier, DepthNoise, DirectAligner<>> late;
  CameraStatus next_status = CameraStatus::FromHost;

  void next(bool segmented) {
    advance();
    if (prev) camera_step.status = next_status;
    if (segmented) observe();
    late.advance(camera_step);
    play(segmented);
    late.await(cur, camera_step, segmented, setup.mask, tracks.all());
  }
  /// Masks of the frame that was `delay` frames ago.
  void submit(const dot::Image<std::uint32_t>& ids, int delay) {
    Masks masks;
    masks.ids = {ids.row(0), ids.width(), ids.height(), 4 * ids.width(), dot::PixelFormat::Id32};
    observations.count("masks", masks, 100, camera.width(), camera.height());
    const auto then = late.frames().find(static_cast<std::uint64_t>(film.index() - delay));
    ASSERT_NE(then, late.frames().end());
    const StageSetup::Setup policies = setup;
    late.apply(then, masks, cur->timestamp, {tracks, observations, labeller, policies});
  }
};

TEST(LateMasks, ReplayLeadsANewObjectToThePresent) {
  Street street;
  street.next(false);
  const auto ids = street.film.seen().ids;
  for (int i = 0; i < 3; ++i) street.next(false);
  street.submit(ids, 3);
  for (const std::uint32_t id : {parked, mover}) {
    const Track* t = street.find(id);
    ASSERT_NE(t, nullptr) << id;
    EXPECT_GT(iou(t->outline.mask, street.mask(id)), 0.85) << id;
    EXPECT_EQ(t->motion.references.front().timestamp, street.cur->timestamp) << id;
    EXPECT_EQ(t->motion.references.size(), 4u) << "as if the masks had come in time: " << id;
    EXPECT_TRUE(t->motion.step.fit.ok()) << id;
  }
  EXPECT_LT((street.find(mover)->motion.step.fit.motion.velocity - Vector3<double>(3, 0, 0)).norm(), 0.3);
  EXPECT_EQ(street.late.frames().size(), 3u) << "those after it may still get theirs";
}

TEST(LateMasks, ANewMaskOfAKnownObjectIsCarriedToThePresent) {
  Street street;
  street.next(true);
  street.next(false);
  const auto ids = street.film.seen().ids;
  for (int i = 0; i < 2; ++i) street.next(false);
  const std::uint32_t id_before = street.find(mover)->identity.id;
  street.submit(ids, 2);
  ASSERT_EQ(street.tracks.size(), 2u);
  const Track* t = street.find(mover);
  EXPECT_EQ(t->identity.id, id_before);
  EXPECT_EQ(t->outline.shape.mask.area, t->observed->mask.area);
  EXPECT_TRUE(t->outline.is_newest);
  // The shape of that frame, moved by camera and object since: 0.6 m to the right, 0.2 m nearer.
  EXPECT_LT((t->outline.T_now_shape.t - Vector3<double>(0.6, 0, -0.2)).norm(), 0.1);
  double last = 1e18;
  for (const ObjectReference& r : t->motion.references) {
    EXPECT_LT(r.timestamp, last) << "newest first, each frame once";
    last = r.timestamp;
  }
}

TEST(LateMasks, AnObjectThatTheMasksDoNotShowIsContradicted) {
  Street street;
  street.next(true);
  street.next(false);
  auto ids = street.film.seen().ids;
  for (int y = 0; y < ids.height(); ++y)
    for (int x = 0; x < ids.width(); ++x)
      if (ids(x, y) == parked) ids(x, y) = 0;
  street.next(false);
  const Vector3<double> place = street.find(parked)->motion.position_now.at;
  street.submit(ids, 1);
  const Track* t = street.find(parked);
  EXPECT_TRUE(t->outline.contradicted);
  EXPECT_FALSE(t->outline.is_newest);
  EXPECT_LT((t->motion.position_now.at - place).norm(), 1e-9) << "and stays where it is";
}

TEST(LateMasks, TakeNoReferenceAcrossAGuessOfTheCamera) {
  Street street;
  street.next(true);
  street.next(false);
  const auto ids = street.film.seen().ids;
  street.next_status = CameraStatus::Lost;
  street.next(false);
  const double guessed = street.cur->timestamp;
  street.submit(ids, 1);
  for (const Track* t : street.tracks.all()) {
    EXPECT_FALSE(t->outline.is_newest);
    for (const ObjectReference& r : t->motion.references) EXPECT_GE(r.timestamp, guessed);
  }
}

TEST(LateMasks, AreNotAwaitedAfterASegmentation) {
  Street street;
  street.next(false);
  street.next(false);
  EXPECT_EQ(street.late.frames().size(), 2u);
  street.next(true);
  EXPECT_TRUE(street.late.frames().empty());
}

}  // namespace
