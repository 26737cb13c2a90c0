// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "onnx_file.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <string_view>

#include "sequence/errors.hpp"

namespace network {
namespace {

struct Malformed {};

/// One field of a message: a number or bytes.
struct Field {
  std::uint64_t number = 0;
  std::uint64_t value = 0;
  std::string_view bytes;
};

/// Goes through the fields of a message in the encoding of Protocol Buffers.
class Message {
 public:
  explicit Message(std::string_view bytes) : rest_(bytes) {}

  bool next(Field& field) {
    if (rest_.empty()) return false;
    const std::uint64_t key = varint();
    field = {key >> 3, 0, {}};
    switch (key & 7) {
      case 0: field.value = varint(); break;
      case 1: field.bytes = take(8); break;
      case 2: field.bytes = take(varint()); break;
      case 5: field.bytes = take(4); break;
      default: throw Malformed{};
    }
    return true;
  }

  bool at_end() const { return rest_.empty(); }

  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const auto byte = static_cast<std::uint8_t>(take(1)[0]);
      value |= std::uint64_t{byte & 0x7fU} << shift;
      if (byte < 0x80) return value;
    }
    throw Malformed{};
  }

 private:
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) throw Malformed{};
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  std::string_view rest_;
};

/// The first field of that number; empty bytes when there is none.
std::string_view find(std::string_view message, std::uint64_t number) {
  Message fields(message);
  for (Field field; fields.next(field);)
    if (field.number == number) return field.bytes;
  return {};
}

/// TensorShapeProto.Dimension: dim_value = 1, dim_param = 2.
int read_length(std::string_view dimension) {
  Message fields(dimension);
  for (Field field; fields.next(field);)
    if (field.number == 1 && field.value > 0 && field.value <= std::numeric_limits<int>::max())
      return static_cast<int>(field.value);
  return -1;
}

/// ValueInfoProto: name = 1, type = 2; TypeProto: tensor_type = 1; Tensor: shape = 2; TensorShapeProto: dim = 1.
Port read_port(std::string_view value_info) {
  Port port;
  port.name = find(value_info, 1);
  Message shape(find(find(find(value_info, 2), 1), 2));
  for (Field field; shape.next(field);)
    if (field.number == 1) port.shape.push_back(read_length(field.bytes));
  return port;
}

/// TensorProto: dims = 1, one by one or packed.
bool is_row(std::string_view tensor) {
  std::vector<std::uint64_t> lengths;
  Message fields(tensor);
  for (Field field; fields.next(field);) {
    if (field.number != 1) continue;
    if (field.bytes.empty()) lengths.push_back(field.value);
    for (Message packed(field.bytes); !packed.at_end();) lengths.push_back(packed.varint());
  }
  return lengths.size() == 2 && lengths[0] == 1 && lengths[1] > 1;
}

/// NodeProto: input = 1, output = 2, op_type = 4, attribute = 5; AttributeProto: t = 5.
/// @param rows names of the constants so far; those that a node of the type Constant makes are added.
/// @param used those that an elementwise operator takes are added.
void read_node(std::string_view node, std::vector<std::string_view>& rows, std::vector<std::string>& used) {
  constexpr std::string_view elementwise[] = {"Add", "Sub", "Mul", "Div"};
  const std::string_view type = find(node, 4);
  if (type == "Constant" && is_row(find(find(node, 5), 5))) rows.push_back(find(node, 2));
  if (std::find(std::begin(elementwise), std::end(elementwise), type) == std::end(elementwise)) return;
  Message fields(node);
  for (Field field; fields.next(field);)
    if (field.number == 1 && std::find(rows.begin(), rows.end(), field.bytes) != rows.end())
      used.emplace_back(field.bytes);
}

OnnxFile read_graph(std::string_view graph) {
  OnnxFile file;
  std::vector<std::string_view> weights;  // old files list them among the inputs
  std::vector<std::string_view> nodes, rows;
  Message fields(graph);
  for (Field field; fields.next(field);) {
    if (field.number == 1) nodes.push_back(field.bytes);
    if (field.number == 5) weights.push_back(find(field.bytes, 8));
    if (field.number == 5 && is_row(field.bytes)) rows.push_back(weights.back());
    if (field.number == 11) file.inputs.push_back(read_port(field.bytes));
    if (field.number == 12) file.outputs.push_back(read_port(field.bytes));
  }
  const auto is_weight = [&](const Port& p) {
    return std::find(weights.begin(), weights.end(), p.name) != weights.end();
  };
  file.inputs.erase(std::remove_if(file.inputs.begin(), file.inputs.end(), is_weight), file.inputs.end());
  for (const std::string_view node : nodes) read_node(node, rows, file.rows);
  return file;
}

}  // namespace

OnnxFile read_onnx(const std::filesystem::path& path) {
  std::string bytes;
  try {
    std::ifstream stream(path, std::ios::binary);
    if (stream) bytes.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  } catch (const std::ios_base::failure&) {
    bytes.clear();  // a folder, or a failing disk
  }
  if (bytes.empty()) throw runner::FileError(path.string() + ": cannot be read");
  OnnxFile file;
  try {
    file = read_graph(find(bytes, 7));
  } catch (const Malformed&) {
    file = {};
  }
  if (file.inputs.empty() || file.outputs.empty()) throw runner::FileError(path.string() + ": is no ONNX model");
  return file;
}

}  // namespace network
