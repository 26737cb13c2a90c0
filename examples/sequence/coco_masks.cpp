// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "coco_masks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "coco_shapes.hpp"
#include "errors.hpp"
#include "fields.hpp"
#include "json_value.hpp"
#include "plausible.hpp"

namespace runner {
namespace {

using Type = JsonValue::Type;

constexpr std::int64_t largest_whole = std::int64_t{1} << 53;  // what a double holds
constexpr std::int64_t largest_category = 2147483647;
constexpr double largest_coordinate = 1e6;  // pixels, of a polygon's corner

/// One object of one of the lists of the file, with what to say when it is wrong.
struct Item {
  const std::filesystem::path& path;
  std::string list;
  std::size_t index;
  const JsonValue& value;

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(path.string() + ": " + list + "[" + std::to_string(index) + "]: " + what);
  }
  const JsonValue* find(const std::string& name, Type type) const {
    const JsonValue* found = value.find(name);
    if (found != nullptr && !found->is(type)) fail(name + " is of a wrong type");
    return found;
  }
  const JsonValue& get(const std::string& name, Type type) const {
    const JsonValue* found = find(name, type);
    if (found == nullptr) fail("has no " + name);
    return *found;
  }
  std::int64_t whole(const std::string& name, std::int64_t most = largest_whole) const {
    const std::optional<std::int64_t> number = to_whole(get(name, Type::Number).number(), -most, most);
    if (!number) fail(name + " is not a whole number");
    return *number;
  }
};

template <typename Function>
void for_each(const std::filesystem::path& path, const JsonValue& document, const std::string& list, bool needed,
              const Function& function) {
  const JsonValue* found = document.find(list);
  if (found == nullptr && !needed) return;
  if (found == nullptr || !found->is(Type::Array))
    throw FileError(path.string() + ": has no list '" + list + "': COCO's format has images, annotations, categories");
  for (std::size_t i = 0; i < found->array().size(); ++i) function(Item{path, list, i, found->array()[i]});
}

std::vector<double> numbers(const Item& item, const JsonValue& list) {
  std::vector<double> values;
  for (const JsonValue& value : list.array()) {
    if (!value.is(Type::Number)) item.fail("segmentation has what is not a number");
    values.push_back(value.number());
  }
  return values;
}

std::vector<double> coordinates(const Item& item, const JsonValue& polygon) {
  std::vector<double> values = numbers(item, polygon);
  for (const double value : values)
    if (std::abs(value) > largest_coordinate) item.fail("segmentation has a corner over 1e6 pixels away");
  return values;
}

cv::Size size_of(const Item& item, const JsonValue& segmentation) {
  constexpr int largest_side = 65535;
  const JsonValue* size = segmentation.find("size");
  const auto side = [&](std::size_t i) { return to_whole(size->array()[i].number(), 1, largest_side); };
  if (size == nullptr || size->array().size() != 2 || !side(0) || !side(1))
    item.fail("segmentation has no size [height, width]");
  return {*side(1), *side(0)};
}

std::string to_text(cv::Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

}  // namespace

CocoMasks::CocoMasks(std::filesystem::path path) : path_(std::move(path)) {
  const JsonValue document = read_json(path_);
  if (!document.is(Type::Object))
    throw FileError(path_.string() + ": is not an object with images and annotations, as COCO's format has them");
  std::map<std::int64_t, std::string> names;
  for_each(path_, document, "images", true, [&](const Item& item) {
    const std::string& name = item.get("file_name", Type::String).string();
    const auto [image, is_new] = images_.try_emplace(key(name));
    if (!is_new) item.fail(quoted(name) + " is named as another image");
    if (!names.emplace(item.whole("id"), key(name)).second) item.fail("has the id of another image");
    if (item.value.find("width") == nullptr || item.value.find("height") == nullptr) return;
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    image->second.size = {static_cast<int>(item.whole("width", most)), static_cast<int>(item.whole("height", most))};
  });
  for_each(path_, document, "categories", false, [&](const Item& item) {
    categories_[static_cast<std::int32_t>(item.whole("id", largest_category))] =
        item.get("name", Type::String).string();
  });
  for_each(path_, document, "annotations", true, [&](const Item& item) {
    const auto image = names.find(item.whole("image_id"));
    if (image == names.end()) item.fail("image_id is that of no image");
    const JsonValue* crowd = item.value.find("iscrowd");
    if (crowd != nullptr && crowd->number() != 0) return;
    Annotation a;
    a.id = item.value.find("id") != nullptr ? item.whole("id") : static_cast<std::int64_t>(item.index);
    if (item.value.find("category_id") != nullptr)
      a.category = static_cast<std::int32_t>(item.whole("category_id", largest_category));
    if (const JsonValue* score = item.find("score", Type::Number)) {
      constexpr double most = 1e6;
      if (!(std::abs(score->number()) <= most)) item.fail("score is out of range");
      a.score = static_cast<float>(score->number());
    }
    const JsonValue* shape = item.value.find("segmentation");
    if (shape == nullptr) item.fail("has no segmentation");
    if (shape->is(Type::Array)) {
      for (const JsonValue& polygon : shape->array()) a.polygons.push_back(coordinates(item, polygon));
    } else if (shape->is(Type::Object)) {
      a.size = size_of(item, *shape);
      const JsonValue* counts = shape->find("counts");
      if (counts == nullptr || !(counts->is(Type::String) || counts->is(Type::Array)))
        item.fail("segmentation has no counts");
      a.compressed_runs = counts->string();
      for (const double length : numbers(item, *counts)) {
        const std::optional<std::int64_t> whole = to_whole(length, std::int64_t{0}, largest_whole);
        if (!whole) item.fail("segmentation has counts that are no numbers of pixels");
        a.runs.push_back(*whole);
      }
    } else {
      item.fail("segmentation is neither polygons nor run lengths");
    }
    images_[image->second].annotations.push_back(std::move(a));
  });
}

void CocoMasks::paint(const Annotation& a, std::uint16_t id, cv::Mat& ids) {
  for (const std::vector<double>& polygon : a.polygons) paint_polygon(polygon, id, ids);
  if (a.size == cv::Size()) return;
  if (a.size != ids.size())
    throw std::invalid_argument("is of an image of " + to_text(a.size) + ", the camera is " + to_text(ids.size()));
  paint_runs(a.compressed_runs.empty() ? a.runs : decode_run_lengths(a.compressed_runs), id, ids);
}

Segmentation CocoMasks::read(const std::string& file_name, cv::Size size,
                             const std::vector<std::string>& always_dynamic) const {
  const Image& image = images_.at(key(file_name));
  if (image.size != cv::Size() && image.size != size)
    throw FileError(path_.string() + ": " + file_name + " is an image of " + to_text(image.size) + ", the camera is " +
                    to_text(size));
  std::vector<Annotation> annotations = image.annotations;
  std::stable_sort(annotations.begin(), annotations.end(),
                   [](const Annotation& a, const Annotation& b) { return a.score < b.score; });
  if (annotations.size() > static_cast<std::size_t>(largest_id))
    throw FileError(path_.string() + ": " + file_name + " has more than " + std::to_string(largest_id) +
                    " annotations");
  const auto flagged = [&](const std::string& name) {
    return std::find(always_dynamic.begin(), always_dynamic.end(), name) != always_dynamic.end();
  };
  Segmentation result;
  result.ids = cv::Mat::zeros(size, CV_16UC1);
  for (const Annotation& annotation : annotations) {
    dot::Instance instance;
    instance.id = static_cast<std::uint32_t>(result.instances.size() + 1);
    instance.class_id = annotation.category;
    instance.score = annotation.score;
    const auto category = categories_.find(annotation.category);
    instance.always_dynamic =
        flagged(std::to_string(annotation.category)) || (category != categories_.end() && flagged(category->second));
    try {
      paint(annotation, static_cast<std::uint16_t>(instance.id), result.ids);
    } catch (const std::invalid_argument& error) {
      throw FileError(path_.string() + ": annotation " + std::to_string(annotation.id) + " of " + file_name + ": " +
                      error.what());
    }
    result.instances.push_back(instance);
  }
  return result;
}

}  // namespace runner
