// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <opencv2/imgproc.hpp>

#include "measures.hpp"
#include "words.hpp"

/// @file
/// Things without a mask that have one in the frame before or after, while the image shows them in both: a network that
/// misses them, or masks that leave out what stands.

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

/// Whether the other frame shows what is in the box as well: the place where it does.
bool find_again(const Small& one, const Small& other, const cv::Rect& box, cv::Rect& there) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(one.grey(box), mean, deviation);
  if (deviation[0] < textured || other.grey.size() != one.grey.size()) return false;
  const cv::Rect image({}, other.grey.size());
  const cv::Rect window = (box + cv::Size(2 * reach, 2 * reach) - cv::Point(reach, reach)) & image;
  cv::Mat match;
  cv::matchTemplate(other.grey(window), one.grey(box), match, cv::TM_CCOEFF_NORMED);
  double best = 0;
  cv::Point at;
  cv::minMaxLoc(match, nullptr, &best, nullptr, &at);
  there = {window.tl() + at, box.size()};
  return best >= same_picture;
}

/// Things that a mask shows in one frame and the image in the other, and how many of them have no mask there.
struct Count {
  int shown = 0, missing = 0;

  void add(const Small& masked_here, const Small& there) {
    for (const auto& [id, box] : boxes_of(masked_here.ids)) {
      cv::Rect found;
      if (!find_again(masked_here, there, box, found)) continue;
      const cv::Mat thing = masked_here.ids(box) == id;
      const int covered = cv::countNonZero(thing & (there.ids(found) != 0));
      ++shown;
      if (covered < masked * cv::countNonZero(thing)) ++missing;
    }
  }
};

}  // namespace

Findings check_missing_masks(const Samples& samples) {
  constexpr int least = 20;    // things seen in two frames
  constexpr double most = 10;  // per cent; networks miss some
  Count count;
  for (std::size_t i = 1; i < samples.frames.size(); ++i) {
    const Sample &frame = samples.frames[i], &last = samples.frames[i - 1];
    if (!frame.follows || frame.ids.empty() || last.ids.empty() || !has_masks(frame) || !has_masks(last)) continue;
    const Small before = small(last), now = small(frame);
    count.add(before, now);
    count.add(now, before);
  }
  if (count.shown < least) return {unknown("masks-missing", "Too few masked things are seen in two frames in a row.")};
  const double percent = 100.0 * count.missing / count.shown;
  const std::string said = number(percent, 0) +
                           " % of the things that a mask shows have none in the next frame or in " +
                           "the one before, though the image shows them there";
  if (percent > most)
    return {faulty("masks-missing", percent, "%", said + ".",
                   "Lower the network's threshold, and give masks of all that can move, whether it moves or stands: "
                   "what has no mask counts as background.")};
  return {fine("masks-missing", percent, "%", said + ".")};
}

}  // namespace check
