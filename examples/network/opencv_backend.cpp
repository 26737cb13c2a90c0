// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include <opencv2/dnn.hpp>
#include <string>

#include "backend.hpp"

namespace network {
namespace {

/// The last line of OpenCV's message that says something; those before it name places in its sources.
std::string reason(const cv::Exception& error) {
  std::string text = error.err.empty() ? error.what() : error.err;
  for (const char* const before : {"error: (", ") "})
    if (const std::size_t at = text.rfind(before); at != std::string::npos) text = text.substr(at);
  if (text.rfind(") ", 0) == 0) text = text.substr(2);
  for (const char* const after : {" in function '", "\n"}) text = text.substr(0, text.find(after));
  return text;
}

class OpenCvBackend : public Backend {
 public:
  OpenCvBackend(const std::filesystem::path& path, const OnnxFile& file) {
    if (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR < 7 && !file.rows.empty())
      throw NetworkError("OpenCV " CV_VERSION " may compute wrongly with the constant '" + file.rows[0] +
                         "' of one row; examples/network/expand_constants.py mends the file, see docs/network.md");
    try {
      net_ = cv::dnn::readNetFromONNX(path.string());
    } catch (const cv::Exception& error) {
      throw NetworkError("OpenCV's dnn module cannot load it: " + reason(error));
    }
    for (const Port& output : file.outputs) {
      if (net_.getLayerId(output.name) < 0)
        throw NetworkError("OpenCV's dnn module has no output '" + output.name + "'");
      names_.push_back(output.name);
    }
    net_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    // OpenCV 4.6 fuses the product of two activations with a scale after it, and gets it wrong: attention, in YOLO11.
    net_.enableFusion(false);
  }

  std::vector<Tensor> run(const Tensor& input) override {
    std::vector<cv::Mat> outputs;
    try {
      net_.setInput(cv::Mat(input.shape, CV_32F, const_cast<float*>(input.values.data())));
      net_.forward(outputs, names_);
    } catch (const cv::Exception& error) {
      throw NetworkError("OpenCV's dnn module cannot run it on input '" + input.name + "' of shape " +
                         to_text(input.shape) + ": " + reason(error));
    }
    std::vector<Tensor> tensors;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      cv::Mat values;
      outputs[i].convertTo(values, CV_32F);
      const auto* first = values.ptr<float>();
      tensors.push_back({names_[i], std::vector<int>(values.size.p, values.size.p + values.dims), {}});
      tensors.back().values.assign(first, first + values.total());
    }
    return tensors;
  }

 private:
  cv::dnn::Net net_;
  std::vector<cv::String> names_;
};

}  // namespace

std::unique_ptr<Backend> open_opencv(const std::filesystem::path& path, const OnnxFile& file) {
  return std::make_unique<OpenCvBackend>(path, file);
}

}  // namespace network
