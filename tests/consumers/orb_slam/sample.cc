// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// sample SETTINGS SEQUENCE rgbd|stereo START [gray|bgra]: runs the host over a sequence that has the layout of
// examples/data/mini, whose clock starts at START seconds, with its pictures as they are or turned into others. It
// prints a line a frame: number, features, those on movers, those on parked cars.

#include <opencv2/imgproc/imgproc.hpp>

#include "System.h"
#include "truth.h"

using namespace std;

namespace {

cv::Mat As(const string& kind, const cv::Mat& image) {
  cv::Mat other = image;
  if (kind == "gray") cv::cvtColor(image, other, cv::COLOR_BGR2GRAY);
  if (kind == "bgra") cv::cvtColor(image, other, cv::COLOR_BGR2BGRA);
  return other;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5 && argc != 6) {
    cerr << "usage: sample SETTINGS SEQUENCE rgbd|stereo START [gray|bgra]" << endl;
    return 2;
  }
  const bool stereo = string(argv[3]) == "stereo";
  const string kind = argc == 6 ? argv[5] : "";
  const Truth truth(argv[2]);
  ORB_SLAM2::System SLAM(argv[1], stereo ? ORB_SLAM2::System::STEREO : ORB_SLAM2::System::RGBD);

  for (int ni = 0; ni < FRAMES; ni++) {
    const double tframe = atof(argv[4]) + 0.1 * ni;
    const cv::Mat imRGB = As(kind, Read(cv::format("%s/rgb/%06d.png", argv[2], ni)));
    // snippet: orb_instances
    // end of snippet
    if (stereo) {
      const cv::Mat imLeft = imRGB, imRight = As(kind, Read(cv::format("%s/right/%06d.jpg", argv[2], ni)));
      // snippet: orb_program_stereo
      SLAM.TrackStereo(imLeft, imRight, tframe);
      // end of snippet
    } else {
      const cv::Mat imD = Read(cv::format("%s/depth/%06d.png", argv[2], ni));
      // snippet: orb_program_rgbd
      SLAM.TrackRGBD(imRGB, imD, tframe);
      // end of snippet
    }

    vector<cv::Point2f> features;
    cv::KeyPoint::convert(SLAM.GetTrackedKeyPointsUn(), features);
    truth.Print(ni, features);
  }
  SLAM.Shutdown();
  return 0;
}
