// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "feature_tracker.h"

vector<Eigen::Matrix3d> RIC;
vector<Eigen::Vector3d> TIC;

namespace {

struct Corner {
  cv::Point2f place;
  int id, count;
};

bool Longer(const Corner& a, const Corner& b) { return a.count > b.count; }

}  // namespace

void FeatureTracker::setMask() {
  mask = cv::Mat(row, col, CV_8UC1, cv::Scalar(255));
  // snippet: vins_set_mask
  // end of snippet

  vector<Corner> corners;
  for (size_t i = 0; i < cur_pts.size(); i++) corners.push_back({cur_pts[i], ids[i], track_cnt[i]});
  stable_sort(corners.begin(), corners.end(), Longer);
  cur_pts.clear(), ids.clear(), track_cnt.clear();
  for (const Corner& corner : corners) {
    if (mask.at<uchar>(corner.place) != 255) continue;
    cur_pts.push_back(corner.place);
    ids.push_back(corner.id);
    track_cnt.push_back(corner.count);
    cv::circle(mask, corner.place, MIN_DIST, 0, -1);
  }
}

void FeatureTracker::trackImage(double _cur_time, const cv::Mat& _img, const cv::Mat& _img1) {
  cur_time = _cur_time;
  cur_img = _img;
  row = cur_img.rows;
  col = cur_img.cols;
  cv::Mat rightImg = _img1;
  // snippet: vins_track_rectified
  // end of snippet
  cur_pts.clear();

  if (!prev_pts.empty()) {
    vector<cv::Point2f> followed;
    vector<uchar> status;
    vector<float> err;
    cv::calcOpticalFlowPyrLK(prev_img, cur_img, prev_pts, followed, status, err, cv::Size(21, 21), 3);
    vector<int> old_ids, old_cnt;
    old_ids.swap(ids), old_cnt.swap(track_cnt);
    const cv::Rect_<float> inside(1, 1, col - 2, row - 2);
    for (size_t i = 0; i < followed.size(); i++) {
      if (!status[i] || !inside.contains(followed[i])) continue;
      cur_pts.push_back(followed[i]);
      ids.push_back(old_ids[i]);
      track_cnt.push_back(old_cnt[i] + 1);
    }
  }

  setMask();
  const int wanted = MAX_CNT - static_cast<int>(cur_pts.size());
  n_pts.clear();
  if (wanted > 0) cv::goodFeaturesToTrack(cur_img, n_pts, wanted, 0.01, MIN_DIST, mask);
  for (const cv::Point2f& p : n_pts) {
    cur_pts.push_back(p);
    ids.push_back(n_id++);
    track_cnt.push_back(1);
  }
  prev_img = cur_img;
  prev_pts = cur_pts;
}
