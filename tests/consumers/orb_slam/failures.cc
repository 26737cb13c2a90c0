// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// failures SEQUENCE: what the guide says of wrong input, and of input of other kinds. Built in the changed host alone.

#include <iostream>
#include <opencv2/calib3d/calib3d.hpp>
#include <opencv2/imgcodecs/imgcodecs.hpp>
#include <opencv2/imgproc/imgproc.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "DotExclusion.h"
#include "truth.h"

namespace {

int failed = 0;

void Expect(bool holds, const char* what) {
  std::cout << (holds ? "ok      " : "FAILED  ") << what << std::endl;
  failed += !holds;
}

cv::Mat As(int type, const cv::Mat& image) {
  cv::Mat other;
  image.convertTo(other, type);
  return other;
}

// The same pixels with rows further apart.
cv::Mat CutOut(const cv::Mat& image) {
  cv::Mat large(image.rows + 7, image.cols + 24, image.type(), cv::Scalar(77));
  cv::Mat part = large(cv::Rect(8, 4, image.cols, image.rows));
  image.copyTo(part);
  return part;
}

cv::Mat Moved(const cv::Mat& image, const cv::Mat& map, int interpolation) {
  cv::Mat out;
  cv::remap(image, out, map, cv::Mat(), interpolation);
  return out;
}

bool Same(const cv::Mat& a, const cv::Mat& b) { return a.size() == b.size() && cv::countNonZero(a != b) == 0; }

// The frame as a lens with distortion shows it: the mask is the one without, seen through that lens.
void Distorted(const cv::Mat& K, const cv::Mat& gray, const cv::Mat& depth, const cv::Mat& ids, const cv::Mat& mask) {
  const cv::Mat lens = (cv::Mat_<float>(4, 1) << -0.2, 0.03, 0, 0);
  std::vector<cv::Point2f> raw, straight;
  for (int y = 0; y < gray.rows; y++)
    for (int x = 0; x < gray.cols; x++) raw.push_back(cv::Point2f(x, y));
  cv::undistortPoints(raw, straight, K, lens, cv::Mat(), K);
  const cv::Mat map = cv::Mat(straight, true).reshape(2, gray.rows);
  const cv::Mat expected = Moved(mask, map, cv::INTER_NEAREST);

  DotExclusion dot;
  const cv::Mat seen = dot.Mask(K, lens, 0, Moved(gray, map, cv::INTER_LINEAR), Moved(depth, map, cv::INTER_NEAREST),
                                As(CV_32S, Moved(ids, map, cv::INTER_NEAREST)), 0);
  const int area = cv::countNonZero(expected), differing = cv::countNonZero(seen != expected);
  std::cout << area << " pixels excluded, " << differing << " differ" << std::endl;
  Expect(area > 1000 && differing < area / 20, "distortion: the mask belongs to the raw image");
  Expect(cv::countNonZero(mask != expected) > 10 * differing, "which differs");
}

// Masks of every second frame, two frames late: movers are known all the same.
void Late(const char* sequence, const cv::Mat& K) {
  const Truth truth(sequence);
  DotExclusion dot;
  Expect(!dot.Late(cv::Mat::zeros(188, 620, CV_8UC1), 0), "late instances before the first frame");
  double all[3] = {0, 0, 0}, excluded[3] = {0, 0, 0};
  bool taken = true;
  for (int i = 0; i < FRAMES; i++) {
    if (i >= 2 && i % 2 == 0)
      taken = dot.Late(Read(cv::format("%s/masks/%06d.png", sequence, i - 2)), 0.1 * (i - 2)) && taken;
    const cv::Mat depth = As(CV_32F, Read(cv::format("%s/depth/%06d.png", sequence, i))) / 256;
    const cv::Mat mask =
        dot.Mask(K, cv::Mat(), 0, cv::imread(cv::format("%s/rgb/%06d.png", sequence, i), 0), depth, cv::Mat(), 0.1 * i);
    const cv::Mat kinds = truth.Kinds(i);
    for (int kind = 0; kind < 3 && i >= 8; kind++) {
      all[kind] += cv::countNonZero(kinds == kind);
      excluded[kind] += cv::countNonZero((kinds == kind) & (mask == 255));
    }
  }
  std::cout << "excluded " << excluded[0] / all[0] << " elsewhere, " << excluded[1] / all[1] << " of parked cars, "
            << excluded[2] / all[2] << " of movers" << std::endl;
  Expect(taken, "late instances are taken");
  Expect(excluded[2] > 0.9 * all[2] && excluded[1] < 0.1 * all[1] && excluded[0] < 0.1 * all[0], "and serve");
  Expect(!dot.Late(cv::Mat::zeros(188, 620, CV_8UC1), 0.5), "too late, or of a frame before the last segmentation");
}

// Number of lines that a recording in other units gives, if the first one is about `suspicion`.
int Told(const char* sequence, const cv::Mat& K, double seconds, double metres, const char* suspicion) {
  std::ostringstream said;
  std::streambuf* const terminal = std::cerr.rdbuf(said.rdbuf());
  DotExclusion dot;
  for (int i = 0; i < FRAMES; i++) {
    const cv::Mat depth = As(CV_32F, Read(cv::format("%s/depth/%06d.png", sequence, i))) * metres / 256;
    dot.Mask(K, cv::Mat(), 0, cv::imread(cv::format("%s/rgb/%06d.png", sequence, i), 0), depth,
             Read(cv::format("%s/masks/%06d.png", sequence, i)), seconds * i);
  }
  std::cerr.rdbuf(terminal);
  std::istringstream lines(said.str());
  std::string line;
  int count = 0;
  bool named = false;
  while (std::getline(lines, line)) {
    std::cout << line << std::endl;
    if (line.find(" % of the image is excluded") != std::string::npos) continue;
    named = named || line.find(std::string("dot: suspicion ") + suspicion) == 0;
    count++;
  }
  return named || count == 0 ? count : -1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: failures SEQUENCE" << std::endl;
    return 2;
  }
  const cv::Mat K = (cv::Mat_<float>(3, 3) << 362.5, 0, 309.5, 0, 362.5, 93.5, 0, 0, 1);
  cv::Mat gray[4], depth[4], ids[4];
  for (int i = 0; i < 4; i++) {
    gray[i] = cv::imread(cv::format("%s/rgb/%06d.png", argv[1], i), cv::IMREAD_GRAYSCALE);
    depth[i] = As(CV_32F, cv::imread(cv::format("%s/depth/%06d.png", argv[1], i), cv::IMREAD_UNCHANGED)) / 256;
    ids[i] = cv::imread(cv::format("%s/masks/%06d.png", argv[1], i), cv::IMREAD_UNCHANGED);
    if (gray[i].empty() || depth[i].empty() || ids[i].empty()) {
      std::cerr << "cannot read " << argv[1] << std::endl;
      return 1;
    }
  }

  DotExclusion dot, other;
  const cv::Mat first = dot.Mask(K, cv::Mat(), 0, gray[0], depth[0], ids[0], 0);
  Expect(cv::countNonZero(first) > 1000, "a first frame");
  Expect(dot.Mask(K, cv::Mat(), 0, gray[1], depth[1], cv::Mat(), 0).empty(), "a frame that came before");
  const cv::Mat second = dot.Mask(K, cv::Mat(), 0, gray[1], depth[1], cv::Mat(), 0.1);
  Expect(cv::countNonZero(second) > 1000, "the next one, without instances");
  Expect(dot.Mask(K, cv::Mat(), 0, gray[2], depth[2], cv::Mat(ids[2].size(), CV_8UC3), 0.2).empty(),
         "instances in colour");
  Expect(dot.Mask(K, cv::Mat(), 0, gray[2], depth[2], ids[2].rowRange(0, 90), 0.2).empty(),
         "instances of another size");
  Expect(dot.Mask(K, cv::Mat(), 0, gray[2], depth[2].rowRange(0, 90), ids[2], 0.2).empty(), "depth of another size");
  const cv::Mat third = dot.Mask(K, cv::Mat(), 0, gray[2], depth[2], ids[2], 0.2);
  Expect(cv::countNonZero(third) > 1000, "the same frame as it should be");

  Expect(Same(first, other.Mask(K, cv::Mat(), 0, CutOut(gray[0]), CutOut(depth[0]), CutOut(As(CV_16U, ids[0])), 0)) &&
             Same(second, other.Mask(K, cv::Mat(), 0, CutOut(gray[1]), CutOut(depth[1]), cv::Mat(), 0.1)) &&
             Same(third, other.Mask(K, cv::Mat(), 0, gray[2], depth[2], As(CV_32S, ids[2]), 0.2)),
         "ids of 16 and 32 bit, rows further apart: the same masks, and no trace of the errors");

  Expect(Same(first, dot.Mask(K, cv::Mat(), 0, gray[0], depth[0], ids[0], -5)), "time goes back: as at the beginning");
  const cv::Rect part(0, 0, 400, 188);
  const cv::Mat smaller = dot.Mask(K, cv::Mat(), 0, gray[1](part), depth[1](part), ids[1](part), -4.9);
  Expect(smaller.size() == part.size() && cv::countNonZero(smaller) > 1000, "images of another size");
  dot.Reset();
  Expect(Same(first, dot.Mask(K, cv::Mat(), 0, gray[0], depth[0], ids[0], 3)), "after Reset");
  dot.Reset();
  Expect(dot.Mask(cv::Mat::zeros(3, 3, CV_32F), cv::Mat(), 0, gray[1], depth[1], ids[1], 4).empty(), "no focal length");
  Expect(Same(first, dot.Mask(K, cv::Mat(), 0, gray[0], depth[0], ids[0], 5)), "with one");

  Distorted(K, gray[0], depth[0], ids[0], first);
  Late(argv[1], K);
  Expect(Told(argv[1], K, 0.1, 1, "") == 0, "nothing is printed while all is well");
  Expect(Told(argv[1], K, 100, 1, "implausible_times (100 s)") == 1, "times in milliseconds");
  const int told = Told(argv[1], K, 0.1, 1000, "too_little_depth");
  Expect(told > 0 && told < 4, "depth in millimetres");
  return failed == 0 ? 0 : 1;
}
