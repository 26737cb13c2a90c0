// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "network.hpp"

#include <memory>
#include <utility>

#include "backend.hpp"
#include "classes.hpp"
#include "id_image.hpp"
#include "input.hpp"
#include "mask_rcnn.hpp"
#include "sequence/errors.hpp"
#include "yolo_seg.hpp"

namespace network {
namespace {

constexpr const char* names[] = {"yolo-seg", "mask-rcnn", "ids"};

Format guess_format(const OnnxFile& file) {
  const std::size_t count = file.outputs.size(), rank = file.outputs[0].shape.size();
  if (count == 1 && rank >= 2) return Format::Ids;
  if (count >= 2 && rank == 3) return Format::YoloSeg;
  if ((count == 4 || count == 5) && rank == 2) return Format::MaskRcnn;
  std::string outputs;
  for (const Port& output : file.outputs)
    outputs += (outputs.empty() ? "'" : ", '") + output.name + "' " + to_text(output.shape);
  throw NetworkError("its outputs (" + outputs + ") are of no format that is known; --network-format tells which");
}

/// The size of the input, which the file, the user or the format states, in this order.
cv::Size input_size(const Port& input, const std::optional<cv::Size>& wanted, cv::Size usual) {
  const std::size_t rank = input.shape.size();
  if (rank == 0) return wanted.value_or(usual);
  const auto may_be = [](int length, int value) { return length == value || length < 0; };
  if ((rank != 3 && rank != 4) || !may_be(input.shape[rank - 3], 3) || (rank == 4 && !may_be(input.shape[0], 1)))
    throw NetworkError("input '" + input.name + "' has shape " + to_text(input.shape) + ", expected 1x3xHxW or 3xHxW");
  const cv::Size stated(input.shape[rank - 1], input.shape[rank - 2]);
  cv::Size size = wanted.value_or(usual);
  if (stated.width > 0) size.width = stated.width;
  if (stated.height > 0) size.height = stated.height;
  if (wanted && size != *wanted)
    throw NetworkError("input '" + input.name + "' has shape " + to_text(input.shape) + ", and --network-size says " +
                       std::to_string(wanted->width) + "x" + std::to_string(wanted->height));
  return size;
}

class LoadedNetwork {
 public:
  LoadedNetwork(const NetworkOptions& options, cv::Size image) : path_(options.model) {
    const OnnxFile file = read_onnx(path_);
    format_ = options.format ? *options.format : guess_format(file);
    if (file.inputs.size() != 1)
      throw NetworkError("has " + std::to_string(file.inputs.size()) + " inputs, expected one image");
    input_ = file.inputs[0];
    form_.letterbox = format_ == Format::YoloSeg;
    if (format_ == Format::MaskRcnn) kind_ = mask_rcnn_kind(file.outputs.size());
    if (format_ == Format::MaskRcnn && kind_ == MaskRcnnKind::Detectron2) form_.rgb = false, form_.scale = 1;
    if (format_ != Format::YoloSeg) threshold_.score = 0.5F;
    if (options.score) threshold_.score = *options.score;
    size_ = input_size(input_, options.size, format_ == Format::YoloSeg ? cv::Size(640, 640) : image);
    read_class_list(options);
    runtime_ = options.backend == BackendChoice::OnnxRuntime ||
               (options.backend == BackendChoice::Default && has_onnx_runtime());
    backend_ = runtime_ ? open_onnx_runtime(path_, file) : open_opencv(path_, file);
  }

  runner::Segmentation segment(const cv::Mat& image) {
    const Placement placement = place(image.size(), size_, form_.letterbox);
    Tensor input = make_input(image, placement, form_);
    input.name = input_.name;
    if (input_.shape.size() == 3) input.shape.erase(input.shape.begin());
    const std::vector<Tensor> outputs = backend_->run(input);
    if (format_ == Format::Ids) return decode_id_image(outputs, placement);
    const int classes = static_cast<int>(classes_.size());
    return to_segmentation(format_ == Format::YoloSeg
                               ? decode_yolo_seg(outputs, classes, placement, threshold_)
                               : decode_mask_rcnn(outputs, kind_, classes, placement, threshold_),
                           classes_, image.size());
  }

  std::string description() const {
    return std::string(names[static_cast<int>(format_)]) + ", input " + std::to_string(size_.width) + "x" +
           std::to_string(size_.height) + ", " + (runtime_ ? "ONNX Runtime" : "OpenCV " CV_VERSION);
  }

  std::vector<std::string> class_names() const {
    std::vector<std::string> list;
    for (const Class& entry : classes_) list.push_back(entry.name);
    return list;
  }

 private:
  void read_class_list(const NetworkOptions& options) {
    if (format_ == Format::Ids) {
      if (!options.classes.empty()) throw runner::UsageError("--network-classes: an image of ids has no classes");
      if (!options.always_dynamic.empty()) throw runner::UsageError("--always-dynamic: an image of ids has no classes");
      if (options.score) throw runner::UsageError("--network-score: an image of ids has no scores");
      return;
    }
    const bool categories = format_ == Format::MaskRcnn && kind_ == MaskRcnnKind::Torchvision;
    if (!options.classes.empty())
      classes_ = read_classes(options.classes);
    else
      classes_ = categories ? coco_categories() : coco_classes();
    set_dynamic(classes_, options.always_dynamic);
  }

  std::filesystem::path path_;
  Format format_ = Format::Ids;
  MaskRcnnKind kind_ = MaskRcnnKind::Torchvision;
  Port input_;
  InputForm form_;
  cv::Size size_;
  Threshold threshold_;
  std::vector<Class> classes_;
  bool runtime_ = false;
  std::unique_ptr<Backend> backend_;
};

/// Errors of the network as those of its file.
template <typename Body>
auto naming(const std::filesystem::path& model, Body&& body) {
  try {
    return body();
  } catch (const NetworkError& error) {
    throw runner::FileError(model.string() + ": " + error.what());
  }
}

}  // namespace

Network open_network(const NetworkOptions& options, cv::Size image) {
  const auto loaded = naming(options.model, [&] { return std::make_shared<LoadedNetwork>(options, image); });
  const auto segment = [loaded, model = options.model](const cv::Mat& frame) {
    return naming(model, [&] { return loaded->segment(frame); });
  };
  return {segment, loaded->description(), loaded->class_names()};
}

}  // namespace network
