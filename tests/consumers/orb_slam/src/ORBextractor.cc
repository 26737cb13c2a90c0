// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "ORBextractor.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc/imgproc.hpp>

using namespace cv;
using namespace std;

namespace ORB_SLAM2 {

namespace {

const int EDGE_THRESHOLD = 19;
const int CELL = 30;  // pixels

// A rectangle of a level and the corners in it.
struct Node {
  Rect_<float> area;
  vector<KeyPoint> keys;
};

bool FewerKeys(const Node& a, const Node& b) { return a.keys.size() < b.keys.size(); }

bool Weaker(const KeyPoint& a, const KeyPoint& b) { return a.response < b.response; }

// The fullest node is quartered until there are as many as corners are wanted; each gives its strongest corner.
vector<KeyPoint> DistributeOctTree(const vector<KeyPoint>& keys, float width, float height, int wanted) {
  vector<Node> nodes(1);
  nodes[0].area = Rect_<float>(0, 0, width, height);
  nodes[0].keys = keys;
  while (static_cast<int>(nodes.size()) < wanted) {
    const vector<Node>::iterator fullest = max_element(nodes.begin(), nodes.end(), FewerKeys);
    if (fullest->keys.size() < 2 || fullest->area.width < 0.5f) break;
    const Node parent = *fullest;
    nodes.erase(fullest);
    const float w = parent.area.width / 2, h = parent.area.height / 2;
    for (int quarter = 0; quarter < 4; ++quarter) {
      Node child;
      child.area = Rect_<float>(parent.area.x + w * (quarter % 2), parent.area.y + h * (quarter / 2), w, h);
      for (size_t i = 0; i < parent.keys.size(); ++i)
        if (child.area.contains(parent.keys[i].pt)) child.keys.push_back(parent.keys[i]);
      if (!child.keys.empty()) nodes.push_back(child);
    }
  }
  vector<KeyPoint> chosen;
  for (size_t i = 0; i < nodes.size(); ++i)
    if (!nodes[i].keys.empty()) chosen.push_back(*max_element(nodes[i].keys.begin(), nodes[i].keys.end(), Weaker));
  return chosen;
}

}  // namespace

ORBextractor::ORBextractor(int _nfeatures, float scaleFactor, int _nlevels, int _iniThFAST, int _minThFAST)
    : nfeatures(_nfeatures), nlevels(_nlevels), iniThFAST(_iniThFAST), minThFAST(_minThFAST) {
  const float factor = 1 / scaleFactor;
  float wanted = nfeatures * (1 - factor) / (1 - pow(factor, static_cast<float>(nlevels)));
  float scale = 1;
  for (int level = 0; level < nlevels; ++level, scale *= scaleFactor, wanted *= factor) {
    mvScaleFactor.push_back(scale);
    mnFeaturesPerLevel.push_back(cvRound(wanted));
  }
  mvImagePyramid.resize(nlevels);
}

void ORBextractor::operator()(const Mat& image, const Mat&, vector<KeyPoint>& keypoints) {
  CV_Assert(image.type() == CV_8UC1);
  ComputePyramid(image);
  vector<vector<KeyPoint>> allKeypoints;
  ComputeKeyPointsOctTree(allKeypoints);
  keypoints.clear();
  for (int level = 0; level < nlevels; ++level) {
    for (size_t i = 0; i < allKeypoints[level].size(); ++i) {
      KeyPoint key = allKeypoints[level][i];
      key.pt *= mvScaleFactor[level];
      keypoints.push_back(key);
    }
  }
}

void ORBextractor::ComputePyramid(const Mat& image) {
  mvImagePyramid[0] = image;
  for (int level = 1; level < nlevels; ++level) {
    const Size size(cvRound(image.cols / mvScaleFactor[level]), cvRound(image.rows / mvScaleFactor[level]));
    resize(mvImagePyramid[level - 1], mvImagePyramid[level], size, 0, 0, INTER_LINEAR);
  }
}

void ORBextractor::ComputeKeyPointsOctTree(vector<vector<KeyPoint>>& allKeypoints) {
  allKeypoints.assign(nlevels, vector<KeyPoint>());
  for (int level = 0; level < nlevels; ++level) {
    const Mat& image = mvImagePyramid[level];
    const int minBorderX = EDGE_THRESHOLD - 3, minBorderY = minBorderX;
    const int maxBorderX = image.cols - minBorderX, maxBorderY = image.rows - minBorderY;

    vector<KeyPoint> vToDistributeKeys;
    for (int y = minBorderY; y < maxBorderY - 6; y += CELL) {
      for (int x = minBorderX; x < maxBorderX - 6; x += CELL) {
        const Mat cell = image(Range(y, min(y + CELL + 6, maxBorderY)), Range(x, min(x + CELL + 6, maxBorderX)));
        vector<KeyPoint> vKeysCell;
        FAST(cell, vKeysCell, iniThFAST, true);
        if (vKeysCell.empty()) FAST(cell, vKeysCell, minThFAST, true);
        for (size_t i = 0; i < vKeysCell.size(); ++i) {
          vKeysCell[i].pt += Point2f(x - minBorderX, y - minBorderY);
          vToDistributeKeys.push_back(vKeysCell[i]);
        }
      }
    }

    // snippet: orb_extractor
    // end of snippet

    vector<KeyPoint>& keypoints = allKeypoints[level];
    keypoints = DistributeOctTree(vToDistributeKeys, maxBorderX - minBorderX, maxBorderY - minBorderY,
                                  mnFeaturesPerLevel[level]);
    for (size_t i = 0; i < keypoints.size(); ++i) {
      keypoints[i].pt += Point2f(minBorderX, minBorderY);
      keypoints[i].octave = level;
    }
  }
}

}  // namespace ORB_SLAM2
