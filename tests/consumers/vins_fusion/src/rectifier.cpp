// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// The guide's way for raw pairs. Built in the changed host alone.

#include "featureTracker/feature_tracker.h"

namespace {

// As in trackImage.
struct RawTracker : FeatureTracker {
  // snippet: vins_rectifier_member
  // end of snippet

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
  RawTracker tracker;
  for (int i = 0; i < 2; i++) {
    tracker.m_camera.push_back(make_shared<Camera>());
    tracker.m_camera[i]->parameters = {-0.28, 0.07, 0.0002, 0.00002, 460, 460, 320, 240};
    RIC.push_back(Eigen::AngleAxisd(0.0175 * i, Eigen::Vector3d::UnitY()).toRotationMatrix());
    TIC.push_back(Eigen::Vector3d(0.1 * i, 0, 0));
  }

  // A patterned wall with an instance near the border, where the distortion is large.
  cv::Mat noise(size, CV_8UC1), disc = cv::Mat::zeros(size, CV_8UC1);
  cv::theRNG().state = 1;
  cv::randu(noise, 0, 255);
  cv::GaussianBlur(noise, noise, cv::Size(5, 5), 0);
  cv::circle(disc, cv::Point(120, 100), 30, 255, -1);
  tracker.cur_img = noise;
  tracker.cur_time = 0;
  tracker.instances = disc;
  tracker.Exclude(noise);
  Expect(tracker.excluded.size() == size && tracker.excluded.at<uchar>(100, 120) == 255 &&
             tracker.excluded.at<uchar>(300, 400) == 0,
         "the first frame gives a mask of the raw image");
  tracker.Exclude(noise);
  Expect(tracker.excluded.empty(), "a frame that came before: no mask, no end");

  const Rectifier& rectifier = *tracker.rectifier;
  Expect(abs(rectifier.baseline - 0.1) < 1e-4, "the baseline is the distance of the cameras");

  // A point 2 m ahead, seen by both cameras: in the rectified pair it is in the same row, shifted by the disparity.
  cv::Mat dot_left = cv::Mat::zeros(size, CV_8UC1), dot_right = dot_left.clone();
  const Eigen::Vector3d point(-0.3, -0.4, 2);
  for (int i = 0; i < 2; i++) {
    const Eigen::Vector3d seen = RIC[i].transpose() * (point - TIC[i]);
    const vector<cv::Point3f> where(1, cv::Point3f(seen.x(), seen.y(), seen.z()));
    const vector<double>& p = tracker.m_camera[i]->parameters;
    const cv::Mat K = (cv::Mat_<double>(3, 3) << p[4], 0, p[6], 0, p[5], p[7], 0, 0, 1);
    vector<cv::Point2f> pixel;
    cv::projectPoints(where, cv::Vec3d(), cv::Vec3d(), K, vector<double>(p.begin(), p.begin() + 4), pixel);
    cv::circle(i == 0 ? dot_left : dot_right, pixel[0], 3, 255, -1);
  }
  const cv::Moments l = cv::moments(rectifier.Left(dot_left)), r = cv::moments(rectifier.Right(dot_right));
  const double disparity = l.m10 / l.m00 - r.m10 / r.m00;
  Expect(abs(l.m01 / l.m00 - r.m01 / r.m00) < 1, "rows of the rectified pair belong together");
  Expect(abs(rectifier.K.at<float>(0, 0) * 0.1 / disparity - 2) < 0.2, "and the disparity gives the depth");

  // There and back again: the disc comes back to its place.
  const cv::Mat moved = rectifier.Instances(disc), back = rectifier.BackToRaw(moved);
  Expect(cv::countNonZero(moved != disc) > 500, "rectifying moves it");
  Expect(cv::countNonZero(back != disc) < 150, "the way back undoes that");
  return failed == 0 ? 0 : 1;
}
