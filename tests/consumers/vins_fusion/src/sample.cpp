// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// sample SEQUENCE START: runs the host over a sequence of the layout of examples/data/mini, whose clock starts at START
// seconds. It prints a line a frame: number, corners, those on movers, those on parked cars.

#include "featureTracker/feature_tracker.h"
#include "truth.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    cerr << "usage: sample SEQUENCE START" << endl;
    return 2;
  }
  const Truth truth(argv[1]);
  TIC.push_back(Eigen::Vector3d(0, 0, 0));
  TIC.push_back(Eigen::Vector3d(0.532725, 0, 0));
  Estimator estimator;
  estimator.featureTracker.m_camera.push_back(make_shared<Camera>());
  estimator.featureTracker.m_camera[0]->parameters = {0, 0, 0, 0, 362.5, 362.5, 309.5, 93.5};

  for (int i = 0; i < FRAMES; i++) {
    const double t = atof(argv[2]) + 0.1 * i;
    cv::Mat imLeft, imRight, instances;
    cv::cvtColor(Read(cv::format("%s/rgb/%06d.png", argv[1], i)), imLeft, cv::COLOR_BGR2GRAY);
    cv::cvtColor(Read(cv::format("%s/right/%06d.jpg", argv[1], i)), imRight, cv::COLOR_BGR2GRAY);
    if (i % 2 == 0) instances = Read(cv::format("%s/masks/%06d.png", argv[1], i));
    // snippet: vins_input
    estimator.inputImage(t, imLeft, imRight);
    // end of snippet
    truth.Print(i, estimator.featureTracker.cur_pts);
  }
  return 0;
}
