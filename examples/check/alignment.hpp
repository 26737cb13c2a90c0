// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <opencv2/core.hpp>

#include "edges.hpp"

namespace check {

/// Best place of edges of the depth or of masks on those of the image.
struct Match {
  double height = 0;   ///< correlation over that of other places, of the mean edge pixel, both sides together
  cv::Point2d offset;  ///< pixels by which the edges lie to the right of and below the image's: mean of the two sides
};

/// Compares edges of the depth or of masks with those of the image, over lags and offsets.
///
/// The correlation at all offsets is one product of Fourier transforms. The products are summed over the frames of each
/// of a few parts of the recording: what the parts do not agree on is noise.
class Alignment {
 public:
  static constexpr int kMaxLag = 3;      ///< frames
  static constexpr int kMaxOffset = 24;  ///< pixels
  static constexpr int kParts = 4;

  explicit Alignment(cv::Size size);

  /// The next frame.
  /// @param sides may be empty. @param follows whether it is the frame after the one before.
  /// @param part of the recording, 0 <= part < kParts.
  void add(const Sides& sides, const cv::Mat& image_edges, bool follows, int part);

  /// @param lag of the sides' frame over the image's: positive if depth or masks are late.
  Match match(int lag, int part) const;
  /// Of all parts together.
  Match match(int lag) const;

 private:
  struct Sum {
    cv::Mat spectra[2];     ///< of the correlations of the left and the right sides
    double pixels[2] = {};  ///< of these sides
    void add(const Sum& other);
  };
  struct Transforms {
    std::array<cv::Mat, 2> sides;
    cv::Mat image;
    std::array<double, 2> pixels{};
  };

  cv::Mat transform(const cv::Mat& edges) const;
  void accumulate(const Transforms& sides, const Transforms& image, int lag, int part);
  Match match_of(const Sum& sum) const;

  cv::Size size_, padded_;
  std::vector<Transforms> last_;  ///< frames of this run, newest last
  Sum sums_[kParts][2 * kMaxLag + 1];
};

/// The lag that fits best.
struct Lag {
  int frames = 0;
  bool clear = false;  ///< the parts of the recording agree on it, and it fits clearly better than no lag
  bool known = false;  ///< it stands out from the others at all
  Match match;         ///< at that lag if it is clear, otherwise at none
  double spread = 0;   ///< pixels by which the offset of three quarters of the parts differs from that one, at most
};

Lag find_lag(const Alignment& alignment);

}  // namespace check
