// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "classes.hpp"

#include <algorithm>
#include <cstddef>

#include "sequence/errors.hpp"
#include "sequence/fields.hpp"
#include "sequence/text.hpp"

namespace network {
namespace {

constexpr Role moves = Role::Moves, dynamic = Role::Dynamic, ignored = Role::Ignored;

/// A class of COCO; `category` is its number in the data set's own files, which leave out ten.
struct CocoClass {
  int category;
  const char* name;
  Role role;
};

// Things that people carry, push or ride move with them; furniture that is seldom moved, fixtures and food do not.
constexpr CocoClass coco[] = {{1, "person", dynamic},
                              {2, "bicycle", moves},
                              {3, "car", moves},
                              {4, "motorcycle", moves},
                              {5, "airplane", moves},
                              {6, "bus", moves},
                              {7, "train", moves},
                              {8, "truck", moves},
                              {9, "boat", moves},
                              {10, "traffic light", ignored},
                              {11, "fire hydrant", ignored},
                              {13, "stop sign", ignored},
                              {14, "parking meter", ignored},
                              {15, "bench", ignored},
                              {16, "bird", dynamic},
                              {17, "cat", dynamic},
                              {18, "dog", dynamic},
                              {19, "horse", dynamic},
                              {20, "sheep", dynamic},
                              {21, "cow", dynamic},
                              {22, "elephant", dynamic},
                              {23, "bear", dynamic},
                              {24, "zebra", dynamic},
                              {25, "giraffe", dynamic},
                              {27, "backpack", moves},
                              {28, "umbrella", moves},
                              {31, "handbag", moves},
                              {32, "tie", ignored},
                              {33, "suitcase", moves},
                              {34, "frisbee", moves},
                              {35, "skis", moves},
                              {36, "snowboard", moves},
                              {37, "sports ball", moves},
                              {38, "kite", moves},
                              {39, "baseball bat", moves},
                              {40, "baseball glove", moves},
                              {41, "skateboard", moves},
                              {42, "surfboard", moves},
                              {43, "tennis racket", moves},
                              {44, "bottle", moves},
                              {46, "wine glass", moves},
                              {47, "cup", moves},
                              {48, "fork", ignored},
                              {49, "knife", ignored},
                              {50, "spoon", ignored},
                              {51, "bowl", moves},
                              {52, "banana", ignored},
                              {53, "apple", ignored},
                              {54, "sandwich", ignored},
                              {55, "orange", ignored},
                              {56, "broccoli", ignored},
                              {57, "carrot", ignored},
                              {58, "hot dog", ignored},
                              {59, "pizza", ignored},
                              {60, "donut", ignored},
                              {61, "cake", ignored},
                              {62, "chair", moves},
                              {63, "couch", ignored},
                              {64, "potted plant", ignored},
                              {65, "bed", ignored},
                              {67, "dining table", ignored},
                              {70, "toilet", ignored},
                              {72, "tv", ignored},
                              {73, "laptop", moves},
                              {74, "mouse", ignored},
                              {75, "remote", ignored},
                              {76, "keyboard", ignored},
                              {77, "cell phone", ignored},
                              {78, "microwave", ignored},
                              {79, "oven", ignored},
                              {80, "toaster", ignored},
                              {81, "sink", ignored},
                              {82, "refrigerator", ignored},
                              {84, "book", moves},
                              {85, "clock", ignored},
                              {86, "vase", ignored},
                              {87, "scissors", ignored},
                              {88, "teddy bear", moves},
                              {89, "hair drier", ignored},
                              {90, "toothbrush", ignored}};

Role role_of(const runner::Place& place, const std::string& name) {
  if (name == "moves") return moves;
  if (name == "dynamic") return dynamic;
  if (name == "ignored") return ignored;
  runner::fail(place, "role must be moves, dynamic or ignored, not " + runner::quoted(name));
}

}  // namespace

const std::vector<Class>& coco_classes() {
  static const std::vector<Class> classes = [] {
    std::vector<Class> all;
    for (const CocoClass& c : coco) all.push_back({c.name, c.role});
    return all;
  }();
  return classes;
}

const std::vector<Class>& coco_categories() {
  static const std::vector<Class> classes = [] {
    std::vector<Class> all(static_cast<std::size_t>(std::end(coco)[-1].category), Class{"none", ignored});
    for (const CocoClass& c : coco) all[static_cast<std::size_t>(c.category - 1)] = {c.name, c.role};
    return all;
  }();
  return classes;
}

std::vector<Class> read_classes(const std::filesystem::path& path) {
  std::vector<Class> classes;
  runner::Place place{path};
  for (const std::string& line : runner::read_lines(path)) {
    ++place.line;
    if (runner::trim(line).empty()) continue;
    const std::vector<std::string> fields = runner::split(line, ',');
    if (fields.size() > 2 || fields[0].empty()) runner::fail(place, "must be name or name,role");
    classes.push_back({fields[0], fields.size() > 1 ? role_of(place, fields[1]) : moves});
  }
  if (classes.empty()) throw runner::FileError(path.string() + ": names no class");
  return classes;
}

void set_dynamic(std::vector<Class>& classes, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    bool found = false;
    for (Class& c : classes)
      if (c.name == name) c.role = dynamic, found = true;
    if (!found) throw runner::UsageError("--always-dynamic: the network has no class '" + name + "'");
  }
}

}  // namespace network
