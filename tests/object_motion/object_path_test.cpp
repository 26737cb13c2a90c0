// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/object_motion/object_path.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace {

using dot::ObjectPath;
using dot::SE3d;
using dot::Vector3;
using dot::Vector6;
using namespace dot::test;

SE3d random_motion(Random& random) {
  Vector6<double> x;
  for (int i = 0; i < 6; ++i) x[i] = random.uniform(-0.2, 0.2);
  return SE3d::exp(x);
}

double difference(const SE3d& a, const SE3d& b) { return (a * b.inverse()).log().norm(); }

TEST(ObjectPath, IsTheMotionApartFromTheCamera) {
  Random random(1);
  ObjectPath path;
  SE3d camera, object;
  for (int i = 0; i < 5; ++i) {
    const SE3d T_c = random_motion(random), T_o = random_motion(random);
    path.advance(T_c, T_o);
    if (i > 1) camera = T_c * camera, object = T_c * T_o * object;
    path.add(i, 0);
  }
  // Points of frame 1 are taken to the present by `object`.
  EXPECT_LT(difference(path.since(1, 4, {9, 9, 9}) * camera, object), 1e-12);
  EXPECT_LT(difference(path.since(4, 4, {9, 9, 9}), SE3d{}), 1e-12);
}

TEST(ObjectPath, GoesOnAtConstantVelocityWhereItIsNotKnown) {
  const Vector3<double> v(1, 2, 3);
  ObjectPath path;
  EXPECT_LT(difference(path.since(1, 3, v), SE3d::translation(2 * v)), 1e-12);
  path.add(3, 0);
  const SE3d T_o = SE3d::translation(Vector3<double>(0.5, 0, 0));
  path.advance({}, T_o);
  path.add(4, 0);
  EXPECT_LT(difference(path.since(1, 4, v), T_o * SE3d::translation(2 * v)), 1e-12);
  EXPECT_LT(difference(path.since(3, 4, v), T_o), 1e-12);

  path.forget_after(3);
  path.advance({}, T_o);
  path.add(5, 0);
  // At 4 it was not found; the fit that took it from 3 to 5 is all that is known.
  EXPECT_LT(difference(path.since(3, 5, v), T_o * T_o), 1e-12);
  EXPECT_LT(difference(path.since(4, 5, v), SE3d::translation(v)), 1e-12);

  path.add(6, 5);
  EXPECT_LT(difference(path.since(3, 6, Vector3<double>::Zero()), SE3d{}), 1e-12);
  path.clear();
  EXPECT_LT(difference(path.since(5, 6, v), SE3d::translation(v)), 1e-12);
}

}  // namespace
