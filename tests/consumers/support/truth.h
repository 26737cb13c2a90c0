// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <opencv2/core/core.hpp>
#include <opencv2/imgcodecs/imgcodecs.hpp>
#include <sstream>
#include <string>
#include <vector>

// What hosts of several kinds need to count their features by what examples/data/mini knows to be true. C++11.

const int FRAMES = 24;

inline cv::Mat Read(const std::string& path) {
  const cv::Mat image = cv::imread(path, cv::IMREAD_UNCHANGED);
  if (image.empty()) {
    std::cerr << "cannot read " << path << std::endl;
    std::exit(1);
  }
  return image;
}

class Truth {
 public:
  explicit Truth(const std::string& sequence) : sequence_(sequence) {
    std::ifstream file((sequence + "/objects.csv").c_str());  // frame,id,class,moving,...
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
      std::stringstream cells(line);
      std::string frame, id, name, moving;
      std::getline(cells, frame, ',');
      std::getline(cells, id, ',');
      std::getline(cells, name, ',');
      std::getline(cells, moving, ',');
      moving_[std::atoi(frame.c_str())][std::atoi(id.c_str())] = moving == "1";
    }
  }

  // 0 elsewhere, 1 on parked cars, 2 on moving ones; CV_8UC1.
  cv::Mat Kinds(int frame) const {
    const cv::Mat ids = Read(cv::format("%s/instance/%06d.png", sequence_.c_str(), frame));
    cv::Mat kinds = cv::Mat::zeros(ids.size(), CV_8UC1);
    const std::map<int, bool>& moving = moving_.at(frame);
    for (std::map<int, bool>::const_iterator object = moving.begin(); object != moving.end(); ++object)
      kinds.setTo(object->second ? 2 : 1, ids == object->first);
    return kinds;
  }

  void Print(int frame, const std::vector<cv::Point2f>& features) const {
    const cv::Mat kinds = Kinds(frame);
    int count[3] = {0, 0, 0};
    for (size_t i = 0; i < features.size(); i++) ++count[kinds.at<uchar>(features[i])];
    std::printf("frame %d: %d features, %d on movers, %d on parked cars\n", frame, static_cast<int>(features.size()),
                count[2], count[1]);
  }

 private:
  std::string sequence_;
  std::map<int, std::map<int, bool>> moving_;
};
