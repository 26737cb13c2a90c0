// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <locale>
#include <sstream>
#include <string>

#include "dot/diagnosis/diagnosis.hpp"

namespace dot {

/// A diagnosis in words: the suspicion's name, its figure and where to look. Empty if there is no suspicion.
inline std::string describe(const Diagnosis& diagnosis) {
  struct Words {
    const char *unit, *meaning;
  };
  const auto words = [&]() -> Words {
    switch (diagnosis.reason) {
      case Suspicion::None: break;
      case Suspicion::ImplausibleTimes:
        return {"s", "steps between frames longer than max_gap, or under 0.5 ms: are the times in seconds?"};
      case Suspicion::RepeatedImages:
        return {"of the frames", "images that are those of the frame before: hand in each image once, with its time"};
      case Suspicion::TooLittleDepth:
        return {"of the pixels", "hardly any pixel has depth within selection.max_depth: is it in metres?"};
      case Suspicion::TooLittleTexture:
        return {"of the frames", "too few points to track: is the image dark, plain or blurred?"};
      case Suspicion::ImplausibleDepth: return {"m", "no scene has such depth: is it in metres?"};
      case Suspicion::DepthOutOfStep:
        return {"frames late", "the depth is that of another frame: look at how images and depth are paired"};
      case Suspicion::MasksCoverImage:
        return {"of the image", "masks leave too little background: give none for the ground, walls and the like"};
      case Suspicion::SaturatedDepth:
        return {"of the pixels", "depth is cut off at a largest value, and not used there: write 0 instead"};
      case Suspicion::FixedPart:
        return {"of the image", "a part of the image does not move with the scene: write depth 0 there"};
      case Suspicion::RollingShutter:
        return {"rad",
                "the rows of the image move differently: a rolling shutter, or other intrinsics than the image has"};
      case Suspicion::UnsteadyScale:
        return {"of the depth", "its scale differs from frame to frame: distances and speeds are as uncertain"};
      case Suspicion::HostMotion:
        return {"px", "camera_motion is not the image's: is it T_cur_prev, of this interval, metres, camera's axes?"};
      case Suspicion::LensDistortion:
        return {"px", "the image is distorted and the camera model is not, or depth is along the ray instead of z"};
    }
    return {"", ""};
  }();
  if (*words.meaning == '\0') return {};
  std::ostringstream text;
  text.imbue(std::locale::classic());  // a point in any locale
  text.precision(3);
  text << to_string(diagnosis.reason) << " (" << diagnosis.figure << " " << words.unit << "): " << words.meaning;
  return text.str();
}

/// Tells a host which diagnoses to print: one line when a suspicion appears, not one with every frame. A suspicion that
/// comes and goes is news again only after it was absent for 200 frames.
class DiagnosisNews {
 public:
  /// Takes the diagnosis of each frame in turn. @return whether it should be printed.
  bool add(const Diagnosis& diagnosis) {
    ++frames_;
    if (diagnosis.reason == Suspicion::None) return false;
    std::int64_t& last = last_.at(static_cast<std::size_t>(diagnosis.reason));
    const bool is_news = last == 0 || frames_ - last > kAbsent;
    last = frames_;
    return is_news;
  }

  /// All is news again, as for another recording.
  void clear() noexcept { *this = {}; }

 private:
  static constexpr std::int64_t kAbsent = 200;

  std::int64_t frames_ = 0;
  std::array<std::int64_t, static_cast<std::size_t>(Suspicion::LensDistortion) + 1>
      last_{};  ///< frame, from 1; 0: never
};

}  // namespace dot
