// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// sample SETTINGS SEQUENCE rgbd|stereo START [gray|bgra]: runs the host over a sequence that has the layout of
// examples/data/mini, whose clock starts at START seconds, with its pictures as they are or turned into others. It
// prints a line a frame: number, features, those on movers, those on parked cars. The truth is read for that alone.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <opencv2/imgcodecs/imgcodecs.hpp>
#include <opencv2/imgproc/imgproc.hpp>
#include <sstream>
#include <string>

#include "System.h"

using namespace std;

namespace {

const int FRAMES = 24;

cv::Mat Read(const string& path) {
  const cv::Mat image = cv::imread(path, cv::IMREAD_UNCHANGED);
  if (image.empty()) {
    cerr << "cannot read " << path << endl;
    exit(1);
  }
  return image;
}

// frame -> instance -> whether it moves, from objects.csv: frame,id,class,moving,...
map<int, map<int, bool>> ReadTruth(const string& path) {
  ifstream file(path.c_str());
  string line;
  getline(file, line);
  map<int, map<int, bool>> moving;
  while (getline(file, line)) {
    stringstream cells(line);
    string frame, id, name, moves;
    getline(cells, frame, ','), getline(cells, id, ','), getline(cells, name, ','), getline(cells, moves, ',');
    moving[atoi(frame.c_str())][atoi(id.c_str())] = moves == "1";
  }
  return moving;
}

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
  const string sequence = argv[2];
  const map<int, map<int, bool>> truth = ReadTruth(sequence + "/objects.csv");
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

    const cv::Mat ids = Read(cv::format("%s/instance/%06d.png", argv[2], ni));
    const map<int, bool>& moving = truth.at(ni);
    const vector<cv::KeyPoint> keys = SLAM.GetTrackedKeyPointsUn();
    int onMovers = 0, onParked = 0;
    for (size_t i = 0; i < keys.size(); i++) {
      const map<int, bool>::const_iterator object = moving.find(ids.at<ushort>(keys[i].pt));
      if (object != moving.end()) ++(object->second ? onMovers : onParked);
    }
    printf("frame %d: %d features, %d on movers, %d on parked cars\n", ni, static_cast<int>(keys.size()), onMovers,
           onParked);
  }
  SLAM.Shutdown();
  return 0;
}
