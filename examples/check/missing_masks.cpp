// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <opencv2/imgproc.hpp>

#include "measures.hpp"
#include "words.hpp"

/// @file
/// Things that lose their mask while the image still shows them: a network that misses them, or masks that leave out
/// what stands.

namespace check {
namespace {

constexpr double widest = 640;   ///< pixels; larger images are made smaller
constexpr int least_area = 150;  ///< pixels of a mask, after that
constexpr int least_side = 10;
constexpr int reach = 60;             ///< pixels that a thing may move between two frames
constexpr double textured = 5;        ///< grey values, standard deviation; a flat thing is found everywhere
constexpr double same_picture = 0.8;  ///< correlation from which on the image still shows it
constexpr double masked = 0.3;        ///< share of its pixels that are masked, from which on it has a mask

/// An image and its masks at a size that is quick to search.
struct Small {
  cv::Mat grey, ids;
};

Small small(const Sample& frame) {
  const double scale = std::min(1.0, widest / frame.grey.cols);
  Small out;
  cv::resize(frame.grey, out.grey, {}, scale, scale, cv::INTER_AREA);
  frame.ids.convertTo(out.ids, CV_32S);
  cv::resize(out.ids, out.ids, out.grey.size(), 0, 0, cv::INTER_NEAREST);
  return out;
}

/// The box about each mask that is large enough, and away from the image's borders, where things leave it.
std::map<int, cv::Rect> boxes_of(const cv::Mat& ids) {
  std::map<int, cv::Rect> boxes;
  std::map<int, int> areas;
  for (int y = 0; y < ids.rows; ++y)
    for (int x = 0; x < ids.cols; ++x)
      if (const int id = ids.at<int>(y, x); id != 0) boxes[id] |= cv::Rect(x, y, 1, 1), ++areas[id];
  for (auto it = boxes.begin(); it != boxes.end();) {
    const cv::Rect& b = it->second;
    const bool inside = b.x > 2 && b.y > 2 && b.br().x < ids.cols - 2 && b.br().y < ids.rows - 2;
    const bool large = areas[it->first] >= least_area && b.width >= least_side && b.height >= least_side;
    it = inside && large ? std::next(it) : boxes.erase(it);
  }
  return boxes;
}

/// Whether the next frame still shows what is in the box: the place where it does.
bool find_again(const Small& before, const Small& now, const cv::Rect& box, cv::Rect& there) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(before.grey(box), mean, deviation);
  if (deviation[0] < textured || now.grey.size() != before.grey.size()) return false;
  const cv::Rect image({}, now.grey.size());
  const cv::Rect window = (box + cv::Size(2 * reach, 2 * reach) - cv::Point(reach, reach)) & image;
  cv::Mat match;
  cv::matchTemplate(now.grey(window), before.grey(box), match, cv::TM_CCOEFF_NORMED);
  double best = 0;
  cv::Point at;
  cv::minMaxLoc(match, nullptr, &best, nullptr, &at);
  there = {window.tl() + at, box.size()};
  return best >= same_picture;
}

}  // namespace

Findings check_missing_masks(const Samples& samples) {
  constexpr int least = 20;    // things seen in two frames
  constexpr double most = 10;  // per cent; networks miss some
  int shown = 0, missing = 0;
  for (std::size_t i = 1; i < samples.frames.size(); ++i) {
    const Sample &frame = samples.frames[i], &last = samples.frames[i - 1];
    if (!frame.follows || frame.ids.empty() || last.ids.empty() || !has_masks(frame) || !has_masks(last)) continue;
    const Small before = small(last), now = small(frame);
    for (const auto& [id, box] : boxes_of(before.ids)) {
      cv::Rect there;
      if (!find_again(before, now, box, there)) continue;
      const cv::Mat thing = before.ids(box) == id;
      const int covered = cv::countNonZero(thing & (now.ids(there) != 0));
      ++shown;
      if (covered < masked * cv::countNonZero(thing)) ++missing;
    }
  }
  if (shown < least) return {unknown("masks-missing", "Too few masked things are seen in two frames in a row.")};
  const double percent = 100.0 * missing / shown;
  const std::string said = number(percent, 0) + " % of the things that a mask shows have none in the next frame, " +
                           "though the image shows them there";
  if (percent > most)
    return {faulty("masks-missing", percent, "%", said + ".",
                   "Lower the network's threshold, and give masks of all that can move, whether it moves or stands: "
                   "what has no mask counts as background.")};
  return {fine("masks-missing", percent, "%", said + ".")};
}

}  // namespace check
