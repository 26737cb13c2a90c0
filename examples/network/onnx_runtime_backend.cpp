// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "backend.hpp"

#ifdef DOT_HAS_ONNX_RUNTIME
#include <onnxruntime_cxx_api.h>

#include <cstdint>
#include <iostream>
#include <streambuf>
#include <string>
#endif

namespace network {

#ifdef DOT_HAS_ONNX_RUNTIME
namespace {

template <typename T>
void copy(const Ort::Value& value, Tensor& tensor) {
  const T* first = value.GetTensorData<T>();
  tensor.values.assign(first, first + count_of(tensor.shape));
}

Tensor to_tensor(const std::string& name, const Ort::Value& value) {
  const Ort::TensorTypeAndShapeInfo info = value.GetTensorTypeAndShapeInfo();
  Tensor tensor{name, {}, {}};
  for (const std::int64_t length : info.GetShape()) tensor.shape.push_back(static_cast<int>(length));
  switch (info.GetElementType()) {
    case ONNX_TENSOR_ELEMENT_DATA_TYPE_FLOAT: copy<float>(value, tensor); break;
    case ONNX_TENSOR_ELEMENT_DATA_TYPE_INT64: copy<std::int64_t>(value, tensor); break;
    case ONNX_TENSOR_ELEMENT_DATA_TYPE_INT32: copy<std::int32_t>(value, tensor); break;
    case ONNX_TENSOR_ELEMENT_DATA_TYPE_UINT8: copy<std::uint8_t>(value, tensor); break;
    case ONNX_TENSOR_ELEMENT_DATA_TYPE_BOOL: copy<bool>(value, tensor); break;
    default: throw NetworkError("output '" + name + "' has a type of number other than float, int64, int32 and uint8");
  }
  return tensor;
}

/// Nothing is written to std::cerr while it lives.
class QuietErrors {
 public:
  QuietErrors() : kept_(std::cerr.rdbuf(nullptr)) {}
  ~QuietErrors() { std::cerr.rdbuf(kept_); }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  std::streambuf* kept_;
};

/// As Debian 13 packages it, the first session registers the operators of ONNX, which libonnx has registered before,
/// and complains of each of them. What goes wrong in earnest is thrown.
Ort::Session open_session(const Ort::Env& env, const std::filesystem::path& path) {
  const QuietErrors quiet;
  return Ort::Session(env, path.c_str(), Ort::SessionOptions{});
}

class OnnxRuntimeBackend : public Backend {
 public:
  OnnxRuntimeBackend(const std::filesystem::path& path, const OnnxFile& file) try : session_(open_session(env_, path)) {
    for (const Port& output : file.outputs) names_.push_back(output.name);
  } catch (const Ort::Exception& error) {
    throw NetworkError(std::string("ONNX Runtime cannot load it: ") + error.what());
  }

  std::vector<Tensor> run(const Tensor& input) override {
    try {
      const std::vector<std::int64_t> shape(input.shape.begin(), input.shape.end());
      const Ort::MemoryInfo memory = Ort::MemoryInfo::CreateCpu(OrtArenaAllocator, OrtMemTypeDefault);
      const Ort::Value value = Ort::Value::CreateTensor<float>(memory, const_cast<float*>(input.values.data()),
                                                               input.values.size(), shape.data(), shape.size());
      const char* const input_name = input.name.c_str();
      std::vector<const char*> names;
      for (const std::string& name : names_) names.push_back(name.c_str());
      const std::vector<Ort::Value> outputs =
          session_.Run(Ort::RunOptions{nullptr}, &input_name, &value, 1, names.data(), names.size());
      std::vector<Tensor> tensors;
      for (std::size_t i = 0; i < names_.size(); ++i) tensors.push_back(to_tensor(names_[i], outputs[i]));
      return tensors;
    } catch (const Ort::Exception& error) {
      throw NetworkError("ONNX Runtime cannot run it on input '" + input.name + "' of shape " + to_text(input.shape) +
                         ": " + error.what());
    }
  }

 private:
  Ort::Env env_{ORT_LOGGING_LEVEL_ERROR, "dot_run"};
  Ort::Session session_;
  std::vector<std::string> names_;
};

}  // namespace

bool has_onnx_runtime() { return true; }

std::unique_ptr<Backend> open_onnx_runtime(const std::filesystem::path& path, const OnnxFile& file) {
  return std::make_unique<OnnxRuntimeBackend>(path, file);
}
#else
bool has_onnx_runtime() { return false; }

std::unique_ptr<Backend> open_onnx_runtime(const std::filesystem::path&, const OnnxFile&) {
  throw NetworkError("this program was built without ONNX Runtime");
}
#endif

}  // namespace network
