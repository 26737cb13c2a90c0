// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// The guide's way for raw pairs. Built in the changed host alone.

#include <memory>

#include "featureTracker/feature_tracker.h"

namespace {

// As in trackImage.
struct RawTracker : FeatureTracker {
  unique_ptr<Rectifier> rectifier;

  void Exclude(const cv::Mat& rightImg) {
    // snippet: vins_track_raw
    // end of snippet
  }
};

int failed = 0;

void Expect(bool holds, const char* what) {
  cout << (holds ? "ok      " : "FAILED  ") << what << endl;
  failed += !holds;
}

}  // namespace

int main() {
  // A wide lens, the right camera 0.1 m to the right and turned by one degree.
  const cv::Size size(640, 480);
  const cv::Mat K = (cv::Mat_<double>(3, 3) << 460, 0, 320, 0, 460, 240, 0, 0, 1);
  const cv::Mat D = (cv::Mat_<double>(1, 4) << -0.28, 0.07, 0.0002, 0.00002);
  cv::Mat R;
  cv::Rodrigues(cv::Vec3d(0, 0.0175, 0), R);
  const cv::Mat t = (cv::Mat_<double>(3, 1) << -0.1, 0, 0);

  RawTracker tracker;
  tracker.rectifier.reset(new Rectifier(K, D, K, D, R, t, size));
  const Rectifier& rectifier = *tracker.rectifier;
  Expect(abs(rectifier.baseline - 0.1) < 1e-4, "the baseline is the distance of the cameras");

  // There and back again: a disc near the border, where the distortion is large, comes back to its place.
  cv::Mat disc = cv::Mat::zeros(size, CV_8UC1);
  cv::circle(disc, cv::Point(120, 100), 30, 255, -1);
  const cv::Mat moved = rectifier.Instances(disc), back = rectifier.BackToRaw(moved);
  Expect(cv::countNonZero(moved != disc) > 500, "rectifying moves it");
  Expect(cv::countNonZero(back != disc) < 150, "the way back undoes that");

  // A patterned wall: the first frame gives a mask, of the raw image, around the instance.
  cv::Mat noise(size, CV_8UC1);
  cv::theRNG().state = 1;
  cv::randu(noise, 0, 255);
  cv::GaussianBlur(noise, noise, cv::Size(5, 5), 0);
  tracker.cur_img = noise;
  tracker.cur_time = 0;
  tracker.instances = disc;
  tracker.Exclude(noise);
  Expect(tracker.excluded.size() == size && tracker.excluded.at<uchar>(100, 120) == 255 &&
             tracker.excluded.at<uchar>(300, 400) == 0,
         "the mask belongs to the raw image");
  tracker.Exclude(noise);
  Expect(tracker.excluded.empty(), "a frame that came before: no mask, no end");
  return failed == 0 ? 0 : 1;
}
