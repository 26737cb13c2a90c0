// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <vector>

// Stands for the camera models and the settings of VINS-Fusion.

struct Camera {
  std::vector<double> parameters;  // k1 k2 p1 p2 fx fy cx cy
  void writeParameters(std::vector<double>& out) const { out = parameters; }
};
typedef std::shared_ptr<Camera> CameraPtr;

// The cameras in the body: a point at x in camera i is at RIC[i] x + TIC[i], metres.
extern std::vector<Eigen::Matrix3d> RIC;
extern std::vector<Eigen::Vector3d> TIC;

const int MAX_CNT = 300;
const int MIN_DIST = 8;
