// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "dot/containers/recycling_list.hpp"
#include "dot/frame/frame.hpp"
#include "dot/frame/validate.hpp"
#include "dot/mask/box_silhouette.hpp"
#include "dot/mask/centre.hpp"
#include "dot/mask/depth_gap.hpp"
#include "dot/mask/id_runs.hpp"
#include "dot/mask/mask.hpp"
#include "dot/mask/shared_pixels.hpp"

DOT_BEGIN_NAMESPACE

/// An instance in one frame, found by a network or discovered by its motion.
struct Observation {
  std::uint32_t instance_id = 0;  ///< the network's, see Instance
  Mask mask;                      ///< its pixels in the frame
  std::int32_t class_id = -1;     ///< the network's, -1 = unknown
  float score = 0;                ///< the network's
  bool always_dynamic = false;    ///< flagged by the caller
  bool discovered = false;        ///< found by its motion
  bool assigned = false;          ///< it belongs to a track
  std::uint32_t part_of = 0;      ///< id of the track whose mask it is a part of, see MaskParts; 0: it is no part
  std::array<int, 4> cut_from{};  ///< box that the mask was cut from, see BoxSilhouette; 0: it was not
  Vector3<double> centre = Vector3<double>::Zero();  ///< of the mask at its median depth, metres; zero: no depth

  /// Whether a track may still continue with it. @param of_discovery whether it is to be a discovered one.
  bool is_open(bool of_discovery) const { return !assigned && part_of == 0 && discovered == of_discovery; }

  /// Of `centre`, 1/m; 0: no depth.
  double inverse_depth() const { return centre.z() > 0 ? 1 / centre.z() : 0.0; }
};

/// The parts of a mask that may show two objects, one behind the other.
struct TwoParts {
  const Observation* whole = nullptr;  ///< the mask, borrowed
  std::array<Mask, 2> parts;           ///< the nearer and the farther one
  std::array<Vector3<double>, 2> centres = {Vector3<double>::Zero(), Vector3<double>::Zero()};  ///< as of Observation
};

/// The observations of one frame. Their addresses do not change while they are in the list.
class Observations {
 public:
  RecyclingList<Observation> list;       ///< those of the segmentation, and discovered ones
  RecyclingList<TwoParts> in_two_parts;  ///< of the segmentation's that may show two objects

  /// Adds an observation for the caller to fill in.
  Observation& add() {
    Observation& o = list.push_back();
    Observation fresh;
    std::swap(fresh.mask, o.mask);  // keeps its memory
    o = std::move(fresh);
    return o;
  }

  /// Adds a discovered object. @param mask gets the pixels of an old one, so that their memory is reused.
  template <typename Camera>
  void add_discovered(Mask& mask, const Image<float>& inverse_depth, const Camera& camera) {
    Observation& o = add();
    std::swap(o.mask, mask);
    o.centre = centre_of(o.mask, inverse_depth, camera, values_);
    o.discovered = true;
  }

  /// Reads the id image, if there is one, to count the instances. Must be called before `read`.
  /// @param field name of the masks. @param most instances that are allowed. @param width, height of the image.
  /// @throws std::invalid_argument naming the field if there are too many instances, or if their boxes overlap so much
  /// that memory and time of their masks would be unbounded.
  void count(const char* field, const Masks& masks, int most, int width, int height) {
    runs_.instances.clear();
    runs_.box_area = 0;
    runs_.runs.clear();
    if (masks.ids.data != nullptr) find_runs(masks.ids, runs_);
    const auto refuse_more = [&](const char* member, std::size_t count) {
      if (count > static_cast<std::size_t>(most))
        bad_field(std::string(field) + member, "has " + std::to_string(count) +
                                                   " instances, more than mask.max_instances, " + std::to_string(most) +
                                                   ": is it an image of something else?");
    };
    refuse_more(".ids", runs_.instances.size());
    refuse_more(".instances", masks.instances.size);
    const double image_area = 1.0 * width * height, images = runs_.box_area / image_area;
    if (images > kMostBoxes)
      bad_field(std::string(field) + ".ids", "has instances that are strewn over it: their boxes have " +
                                                 to_text(images) + " times its area, more than " + to_text(kMostBoxes) +
                                                 ": is it an image of something else?");
    if (area_of_images(masks.instances) <= kMostBoxes * image_area) return;
    double boxes = 0;
    for (const Instance& instance : masks.instances)
      if (instance.mask.data != nullptr) boxes += box_area_of(instance.mask, instance.x, instance.y, width, height);
    if (boxes > kMostBoxes * image_area)
      bad_field(std::string(field) + ".instances", "has masks that overlap too much: their boxes have " +
                                                       to_text(boxes / image_area) +
                                                       " times the image's area, more than " + to_text(kMostBoxes));
  }

  /// Adds the instances of a frame's segmentation, in whichever form it is given. Pixels that several masks of a list
  /// share go to the object whose depth they have. Where the depth does not tell, they go to the mask that lies inside
  /// the other, unless that has the lower score, and of two masks of one object to that of the higher score. A mask
  /// that loses nearly all in this way is dropped. Boxes in a list are cut to the objects in them. Call `count` with
  /// the same masks before.
  template <typename Camera, typename Noise>
  void read(const Masks& masks, const Image<float>& inverse_depth, const Camera& camera, const Noise& noise) {
    if (masks.ids.data != nullptr) {
      split_ids(runs_, [this](std::uint32_t id) -> Mask& {
        Observation& o = add();
        o.instance_id = id;
        return o.mask;
      });
    }
    for (const Instance& instance : masks.instances) {
      Observation* o = nullptr;
      if (instance.mask.data != nullptr) {
        o = &add();
        o->instance_id = instance.id;
        mask_of(instance.mask, instance.x, instance.y, camera.width(), camera.height(), o->mask);
      } else {
        for (Observation& other : list)
          if (other.instance_id == instance.id) o = &other;
      }
      if (!o) continue;
      o->class_id = instance.class_id;
      o->score = instance.score;
      o->always_dynamic = instance.always_dynamic;
    }
    list.drop_if([](const Observation& o) { return o.mask.empty(); });
    for (Observation& o : list) o.centre = centre_of(o.mask, inverse_depth, camera, values_);
    const bool may_overlap = std::any_of(masks.instances.begin(), masks.instances.end(),
                                         [](const Instance& instance) { return instance.mask.data != nullptr; });
    if (may_overlap) resolve_overlaps(inverse_depth, camera, noise);  // an id image has one id for each pixel
    in_two_parts.clear();
    for (const Observation& o : list) {
      TwoParts& two = in_two_parts.push_back();
      if (!gap_.find(inverse_depth, camera, noise, o.mask, two.parts[0], two.parts[1])) {
        in_two_parts.pop_back();
        continue;
      }
      two.whole = &o;
      for (std::size_t i : {0, 1}) two.centres[i] = centre_of(two.parts[i], inverse_depth, camera, values_);
    }
  }

  /// Forgets the observations. Keeps the memory.
  void clear() {
    list.clear();
    in_two_parts.clear();
  }

 private:
  /// Lets each pixel belong to one of the masks, and cuts boxes.
  template <typename Camera, typename Noise>
  void resolve_overlaps(const Image<float>& inverse_depth, const Camera& camera, const Noise& noise) {
    drop_covered();
    cut_boxes(inverse_depth, camera, noise);
    if (!separate_all(inverse_depth, noise)) return;
    list.drop_if([](const Observation& o) { return o.mask.empty(); });
    for (Observation& o : list) o.centre = centre_of(o.mask, inverse_depth, camera, values_);
  }

  /// Drops masks that show little besides what those show to which they give way.
  void drop_covered() {
    left_.clear();
    for (const Observation& o : list) {
      Mask* left = nullptr;
      for (const Observation& other : list) {
        if (&other == &o || !gives_way(claim_of(o), claim_of(other))) continue;
        if (!left) left = &(scratch_ = o.mask);
        take_out(other.mask, *left);
      }
      left_.push_back(left ? left->area : o.mask.area);
    }
    for (std::size_t i = 0; i < list.size(); ++i)
      if (left_[i] < kLeast * list[i].mask.area) list[i].mask.clear();
    list.drop_if([](const Observation& o) { return o.mask.empty(); });
  }

  /// Cuts each box to the object in it.
  template <typename Camera, typename Noise>
  void cut_boxes(const Image<float>& inverse_depth, const Camera& camera, const Noise& noise) {
    for (Observation& o : list) {
      if (!BoxSilhouette::is_box(o.mask)) continue;
      const std::array<int, 4> box = o.mask.box();
      rivals_.clear();
      for (const Observation& other : list)
        if (&other != &o && (intersects(other.mask.box(), box) || intersects(other.cut_from, box)))
          rivals_.push_back(&other);
      const auto claimed = [this](int u, int v) {
        return std::any_of(rivals_.begin(), rivals_.end(), [u, v](const Observation* other) {
          return other->mask.at(u, v) || intersects(other->cut_from, {u, v, 1, 1});
        });
      };
      if (!silhouette_.cut(inverse_depth, camera, noise, claimed, o.mask)) continue;
      o.cut_from = box;
      o.centre = centre_of(o.mask, inverse_depth, camera, values_);
    }
  }

  /// Whether two boxes (x, y, width, height) share a pixel.
  static bool intersects(const std::array<int, 4>& a, const std::array<int, 4>& b) {
    return a[0] < b[0] + b[2] && b[0] < a[0] + a[2] && a[1] < b[1] + b[3] && b[1] < a[1] + a[3];
  }

  template <typename Noise>
  bool separate_all(const Image<float>& inverse_depth, const Noise& noise) {
    bool changed = false;
    for (std::size_t i = 0; i < list.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        Observation &a = list[i], &b = list[j];
        const bool a_loses = gives_way(claim_of(a), claim_of(b)), b_loses = gives_way(claim_of(b), claim_of(a));
        const Mask* loser = a_loses ? &a.mask : b_loses ? &b.mask : nullptr;
        changed |= separate(inverse_depth, noise, static_cast<float>(a.inverse_depth()),
                            static_cast<float>(b.inverse_depth()), a.mask, b.mask, loser, scratch_);
      }
    return changed;
  }

  static Claim claim_of(const Observation& o) { return {o.mask, o.score, o.always_dynamic}; }

  static double area_of_images(const Span<Instance>& instances) {
    double area = 0;
    for (const Instance& instance : instances)
      if (instance.mask.data != nullptr) area += 1.0 * instance.mask.width * instance.mask.height;
    return area;
  }

  static constexpr double kMostBoxes = 32;  ///< largest total area of all boxes, in image areas
  static constexpr double kLeast = 0.5;     ///< share of a mask that the others must leave, else it shows nothing new

  IdRuns runs_;
  BoxSilhouette silhouette_;
  DepthGap gap_;
  std::vector<const Observation*> rivals_;  ///< with pixels in the box that is cut
  Mask scratch_;
  std::vector<float> values_;
  std::vector<int> left_;  ///< pixels of each mask that those to which it gives way do not show
};

DOT_END_NAMESPACE
