// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <opencv2/imgproc.hpp>

#include "measures.hpp"
#include "words.hpp"

/// @file
/// Pictures that come twice. Two pictures that a camera took differ at least by its noise, even if nothing moves.

namespace check {
namespace {

constexpr double same = 0.02;      ///< grey values, mean: nothing has changed but the compression of a few pixels
constexpr double most_same = 0.9;  ///< share above which the recording has no noise, and shows nothing that moves

bool equal(const cv::Mat& a, const cv::Mat& b) {
  return !a.empty() && a.size() == b.size() && a.type() == b.type() &&
         cv::norm(a, b, cv::NORM_L1) <= same * static_cast<double>(a.total());
}

}  // namespace

Findings check_repeats(const Samples& samples) {
  int images = 0, depths = 0, pairs = 0;
  for (std::size_t i = 1; i < samples.frames.size(); ++i) {
    const Sample &before = samples.frames[i - 1], &now = samples.frames[i];
    if (!now.follows) continue;
    ++pairs;
    const bool image = equal(before.grey, now.grey);
    if (image) ++images;
    if (!image && !samples.depth_from_pair && before.depth.size() == now.depth.size() &&
        cv::norm(before.depth, now.depth, cv::NORM_INF) == 0 && cv::countNonZero(now.depth) > 0)
      ++depths;
  }
  if (pairs == 0) {
    const char* const why = "There are no two frames in a row.";
    return {unknown("images-repeated", why), unknown("depth-repeated", why)};
  }
  Findings findings;
  const auto add = [&](const char* fault, int repeated, const char* what, const char* advice) {
    const double percent = 100.0 * repeated / (pairs + 1);
    const std::string words = text(repeated) + " of " + count_text(pairs + 1, "frame") + " show the " + what +
                              " of the frame before once more.";
    if (repeated > most_same * pairs)
      findings.push_back(unknown(fault, "All show the same " + std::string(what) + "."));
    else if (repeated > 0)
      findings.push_back(faulty(fault, percent, "%", words, advice));
    else
      findings.push_back(fine(fault, 0, "%", words));
  };
  add("images-repeated", images, "image",
      "Leave these frames out: for the tracker all things stop for a moment and then jump. Look for a driver that "
      "hands "
      "out its last picture when there is no new one.");
  add("depth-repeated", depths, "depth",
      "Leave the depth of these frames out (all zeros), or take images at the rate of the depth: it is a frame late.");
  return findings;
}

}  // namespace check
