// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <map>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "alignment.hpp"
#include "measures.hpp"
#include "words.hpp"

/// @file
/// The masks: their size, whether their values are instances, and whether they are of the same moment as the image.

namespace check {
namespace {

Finding size_finding(const Samples& samples) {
  for (const Sample& frame : samples.frames)
    if (!frame.ids.empty() && !has_masks(frame)) {
      const double percent = 100.0 * frame.ids.cols / frame.grey.cols;
      return faulty("masks-size", percent, "%",
                    "The masks of frame " + text(samples.recording.entries[frame.index].number) + " are " +
                        size_text(frame.ids.size()) + ", the image " + size_text(frame.grey.size()) + ".",
                    "Scale the masks to the image, nearest neighbour, and undo any border that the network added.");
    }
  return fine("masks-size", 100, "%", "The masks have the size of the image.");
}

/// What the values of masks look like.
struct Values {
  double graded = 0;   ///< share of masked pixels whose neighbour to the right is masked by another value
  double regions = 0;  ///< separate regions of a value
  int most = 0;        ///< values in a frame
  int line = 0;        ///< a value that is a line of a few pixels in most frames; 0: there is none
};

/// Regions that are not small, and a good part of all pixels of their value.
int large_regions(const cv::Mat& of_value) {
  constexpr double share = 0.15;
  constexpr int least = 60;
  cv::Mat labels, statistics, centres;
  const int count = cv::connectedComponentsWithStats(of_value, labels, statistics, centres);
  const int all = cv::countNonZero(of_value);
  int large = 0;
  for (int i = 1; i < count; ++i)
    if (const int area = statistics.at<int>(i, cv::CC_STAT_AREA); area >= least && area > share * all) ++large;
  return large;
}

/// Whether pixels are nowhere more than six wide, and are no small thing.
bool is_line(const cv::Mat& of_value, int pixels) {
  constexpr int least = 300;
  if (pixels < least) return false;
  cv::Mat inner;
  cv::erode(of_value, inner, cv::Mat::ones(7, 7, CV_8U));
  return cv::countNonZero(inner) == 0;
}

constexpr int countable = 40;  ///< values in a frame

Values look_at(const Samples& samples) {
  Values values;
  double masked = 0, graded = 0;
  int regions = 0, shown = 0, frames = 0;
  std::map<int, int> lines;  // value, frames
  for (std::size_t i = 0; i < samples.frames.size(); i += 2) {
    const Sample& frame = samples.frames[i];
    if (frame.ids.empty()) continue;
    cv::Mat ids;
    frame.ids.convertTo(ids, CV_32S);
    std::map<int, int> pixels;
    for (int y = 0; y < ids.rows; ++y) {
      const auto* row = ids.ptr<int>(y);
      for (int x = 0; x + 1 < ids.cols; ++x) {
        if (row[x] == 0) continue;
        ++pixels[row[x]];
        masked += 1;
        if (row[x + 1] != 0 && row[x + 1] != row[x]) graded += 1;
      }
    }
    values.most = std::max(values.most, static_cast<int>(pixels.size()));
    if (pixels.size() > static_cast<std::size_t>(countable)) continue;
    ++frames;
    for (const auto& [value, count] : pixels) {
      const cv::Mat of_value = ids == value;
      if (const int large = large_regions(of_value)) ++shown, regions += large;
      lines[value] += is_line(of_value, count);
    }
  }
  constexpr int least_frames = 3;
  for (const auto& [value, count] : lines)
    if (count >= least_frames && 2 * count > frames) values.line = value;
  if (masked > 0) values.graded = graded / masked;
  if (shown > 0) values.regions = static_cast<double>(regions) / shown;
  return values;
}

Finding value_finding(const Samples& samples) {
  constexpr double most_graded = 0.15;  // borders between instances that touch: up to 0.02
  constexpr double most_regions = 1.6;  // an instance in two parts by what stands before it: up to 1.2 on average
  const char* const advice =
      "Give each instance a value of its own, 0 for the background. Of a network that gives classes or one map for "
      "all, "
      "take its instances, or number the connected regions.";
  const Values values = look_at(samples);
  if (values.graded > most_graded)
    return faulty("masks-values", 100 * values.graded, "%",
                  number(100 * values.graded, 0) + " % of the masks' pixels have a neighbour of another value, up to " +
                      text(values.most) + " values in a frame: they look like probabilities or an image, not like ids.",
                  "Threshold the probabilities of each instance, and write its number where it is the likeliest.");
  if (values.line != 0)
    return faulty("masks-values", values.line, "value",
                  "In most frames the value " + text(values.line) +
                      " is a line of a few pixels: it looks like the border around instances that data sets call void.",
                  "Set it to 0. The pixels of a border belong to no instance.");
  if (values.most == 0) return unknown("masks-values", "The masks are empty.");
  if (values.regions == 0 && values.most > countable)
    return unknown("masks-values",
                   "Too many values in a frame, " + text(values.most) + ": their regions are not looked at.");
  const std::string said = "A value stands for " + number(values.regions, 1) + " separate regions on average, " +
                           text(values.most) + (values.most == 1 ? " value" : " values") + " in a frame at most";
  if (values.regions > most_regions)
    return faulty("masks-values", values.regions, "regions a value",
                  said + ": they look like classes, not like instances.", advice);
  return fine("masks-values", values.regions, "regions a value", said + ".");
}

Finding lag_finding(const Samples& samples) {
  Alignment alignment(samples.frames[0].grey.size());
  const int count = static_cast<int>(samples.frames.size());
  for (int i = 0; i < count; ++i) {
    const Sample& frame = samples.frames[static_cast<std::size_t>(i)];
    alignment.add(frame.ids.empty() ? Sides{} : mask_sides(frame.ids), image_edges(frame.grey), frame.follows,
                  i * Alignment::kParts / count);
  }
  const Lag lag = find_lag(alignment);
  if (lag.clear) {
    const int frames = std::abs(lag.frames);
    return faulty("masks-lag", lag.frames, "frames",
                  "The masks come " + count_text(frames, "frame") + (lag.frames > 0 ? " late" : " early") +
                      ": their borders lie on the edges of the image " + count_text(frames, "frame") +
                      (lag.frames > 0 ? " before." : " after."),
                  "Give masks with the frame from whose image they were made; those that are done later go to "
                  "submit_masks (dot_run --mask-delay) with that frame's id.");
  }
  if (!lag.known)
    return unknown("masks-lag",
                   "No lag fits clearly better than the others: too little moves, or the masks are coarse.");
  return fine("masks-lag", 0, "frames", "Masks and images are of the same moment.");
}

}  // namespace

Findings check_masks(const Samples& samples) {
  const bool any =
      std::any_of(samples.frames.begin(), samples.frames.end(), [](const Sample& f) { return !f.ids.empty(); });
  if (!any) {
    const char* const why = "There are no masks.";
    return {unknown("masks-size", why), unknown("masks-values", why), unknown("masks-lag", why)};
  }
  Findings findings{size_finding(samples), value_finding(samples)};
  findings.push_back(findings[0].verdict == Verdict::Fault ? unknown("masks-lag", "The masks have another size.")
                                                           : lag_finding(samples));
  return findings;
}

}  // namespace check
