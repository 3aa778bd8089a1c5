// ONNX files are protocol buffers. The few messages that a perceptron needs are written by hand: a field is a key
// (number * 8 + kind) and a varint, or a length and bytes. The numbers are those of onnx.proto, IR version 8.
#include "tautline/network/onnx_file.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace tautline {
namespace {

constexpr std::uint64_t kIrVersion = 8;
constexpr std::uint64_t kOpset = 13;
constexpr std::uint64_t kFloat = 1;    // TensorProto.DataType.FLOAT
constexpr std::uint64_t kIntType = 2;  // AttributeProto.AttributeType.INT
constexpr std::uint64_t kMostParameters = 100'000'000;

namespace model {
constexpr int kIr = 1, kProducer = 2, kGraph = 7, kOpsetImport = 8, kMetadata = 14;
}
namespace opset {
constexpr int kDomain = 1, kVersion = 2;
}
namespace graph {
constexpr int kNode = 1, kName = 2, kInitializer = 5, kInput = 11, kOutput = 12;
}
namespace node {
constexpr int kInput = 1, kOutput = 2, kName = 3, kOperator = 4, kAttribute = 5;
}
namespace attribute {
constexpr int kName = 1, kInt = 3, kType = 20;
}
namespace tensor {
constexpr int kDimension = 1, kDataType = 2, kName = 8, kRawData = 9;
}
namespace value_info {
constexpr int kName = 1, kType = 2;
}
namespace type {
constexpr int kTensor = 1, kElement = 1, kShape = 2, kDimension = 1, kValue = 1, kParameter = 2;
}
namespace entry {
constexpr int kKey = 1, kValue = 2;
}

/// A message while it is written.
class Message {
 public:
  Message& Number(int field, std::uint64_t value) {
    Varint(static_cast<std::uint64_t>(field) << 3);
    Varint(value);
    return *this;
  }

  Message& Bytes(int field, std::string_view bytes) {
    Varint(static_cast<std::uint64_t>(field) << 3 | 2);
    Varint(bytes.size());
    bytes_ += bytes;
    return *this;
  }

  Message& Sub(int field, const Message& message) { return Bytes(field, message.bytes_); }

  std::string Take() { return std::move(bytes_); }

 private:
  void Varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(value | 0x80);
    bytes_ += static_cast<char>(value);
  }

  std::string bytes_;
};

std::string Numbered(const char* name, int layer) { return name + std::to_string(layer); }

/// Little-endian, whatever this machine is.
std::string RawFloats(std::span<const float> values) {
  std::string raw;
  raw.reserve(4 * values.size());
  for (const float value : values) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    for (int i = 0; i < 4; ++i) raw += static_cast<char>(bits >> (8 * i));
  }
  return raw;
}

Message TensorOf(const std::string& name, const std::vector<int>& dimensions, std::span<const float> values) {
  Message message;
  for (const int dimension : dimensions) message.Number(tensor::kDimension, static_cast<std::uint64_t>(dimension));
  message.Number(tensor::kDataType, kFloat).Bytes(tensor::kName, name).Bytes(tensor::kRawData, RawFloats(values));
  return message;
}

Message RowsOf(const std::string& name, int width) {
  Message rows, columns, shape, tensor_type, message_type, message;
  rows.Bytes(type::kParameter, "batch");
  columns.Number(type::kValue, static_cast<std::uint64_t>(width));
  shape.Sub(type::kDimension, rows).Sub(type::kDimension, columns);
  tensor_type.Number(type::kElement, kFloat).Sub(type::kShape, shape);
  message_type.Sub(type::kTensor, tensor_type);
  message.Bytes(value_info::kName, name).Sub(value_info::kType, message_type);
  return message;
}

Message GemmNode(int layer, const std::string& input, const std::string& output) {
  Message transposed, message;
  transposed.Bytes(attribute::kName, "transB").Number(attribute::kInt, 1).Number(attribute::kType, kIntType);
  message.Bytes(node::kInput, input)
      .Bytes(node::kInput, Numbered("weights", layer))
      .Bytes(node::kInput, Numbered("bias", layer))
      .Bytes(node::kOutput, output)
      .Bytes(node::kName, Numbered("layer", layer))
      .Bytes(node::kOperator, "Gemm")
      .Sub(node::kAttribute, transposed);
  return message;
}

Message ReluNode(int layer, const std::string& output) {
  Message message;
  message.Bytes(node::kInput, Numbered("sums", layer))
      .Bytes(node::kOutput, output)
      .Bytes(node::kName, Numbered("relu", layer))
      .Bytes(node::kOperator, "Relu");
  return message;
}

Message GraphOf(const Mlp& network) {
  Message message;
  std::string input = "observation";
  const int last = network.layers() - 1;
  for (int layer = 0; layer <= last; ++layer) {
    message.Sub(graph::kNode, GemmNode(layer, input, layer == last ? "values" : Numbered("sums", layer)));
    if (layer == last) break;
    input = Numbered("hidden", layer);
    message.Sub(graph::kNode, ReluNode(layer, input));
  }
  message.Bytes(graph::kName, "policy");
  for (int layer = 0; layer <= last; ++layer) {
    const auto i = static_cast<std::size_t>(layer);
    const int inputs = network.widths()[i], outputs = network.widths()[i + 1];
    message.Sub(graph::kInitializer, TensorOf(Numbered("weights", layer), {outputs, inputs}, network.weights(layer)));
    message.Sub(graph::kInitializer, TensorOf(Numbered("bias", layer), {outputs}, network.bias(layer)));
  }
  message.Sub(graph::kInput, RowsOf("observation", network.inputs()));
  message.Sub(graph::kOutput, RowsOf("values", network.outputs()));
  return message;
}

/// One field of a message that is read.
struct Field {
  int number = 0;
  std::uint64_t value = 0;  ///< Of a number.
  std::string_view bytes;   ///< Of a string or message.
};

/// Takes a message apart; what is not well formed ends it.
class FieldReader {
 public:
  explicit FieldReader(std::string_view bytes) : bytes_(bytes) {}

  /// The next field, or nothing at the end or at a fault.
  std::optional<Field> Next() {
    if (bytes_.empty()) return std::nullopt;
    Field field;
    const auto key = Varint();
    if (!key) return Fault();
    field.number = static_cast<int>(*key >> 3 & 0xffff);
    switch (*key & 7) {
      case 0: {
        const auto value = Varint();
        if (!value) return Fault();
        field.value = *value;
        return field;
      }
      case 2: {
        const auto size = Varint();
        if (!size || *size > bytes_.size()) return Fault();
        field.bytes = bytes_.substr(0, *size);
        bytes_.remove_prefix(*size);
        return field;
      }
      default:
        return Fault();
    }
  }

  bool faulty() const { return faulty_; }

 private:
  std::optional<std::uint64_t> Varint() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64 && !bytes_.empty(); shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_.front());
      bytes_.remove_prefix(1);
      value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if (byte < 0x80) return value;
    }
    return std::nullopt;
  }

  std::nullopt_t Fault() {
    faulty_ = true;
    bytes_ = {};
    return std::nullopt;
  }

  std::string_view bytes_;
  bool faulty_ = false;
};

struct Tensor {
  std::string_view name;
  std::vector<std::uint64_t> dimensions;
  std::string_view raw;
};

/// What a graph holds, as far as our own matter. Nothing where it is not well formed.
struct Graph {
  std::vector<std::string_view> operators;
  std::vector<Tensor> tensors;
};

std::optional<Tensor> ReadTensor(std::string_view bytes) {
  Tensor tensor;
  FieldReader reader(bytes);
  while (const auto field = reader.Next()) {
    if (field->number == tensor::kDimension) tensor.dimensions.push_back(field->value);
    if (field->number == tensor::kName) tensor.name = field->bytes;
    if (field->number == tensor::kRawData) tensor.raw = field->bytes;
  }
  if (reader.faulty()) return std::nullopt;
  return tensor;
}

std::optional<std::string_view> ReadOperator(std::string_view bytes) {
  std::string_view name;
  FieldReader reader(bytes);
  while (const auto field = reader.Next()) {
    if (field->number == node::kOperator) name = field->bytes;
  }
  if (reader.faulty()) return std::nullopt;
  return name;
}

std::optional<Graph> ReadGraph(std::string_view bytes) {
  Graph result;
  FieldReader reader(bytes);
  while (const auto field = reader.Next()) {
    if (field->number == graph::kNode) {
      const auto name = ReadOperator(field->bytes);
      if (!name) return std::nullopt;
      result.operators.push_back(*name);
    } else if (field->number == graph::kInitializer) {
      auto tensor = ReadTensor(field->bytes);
      if (!tensor) return std::nullopt;
      result.tensors.push_back(*std::move(tensor));
    }
  }
  if (reader.faulty()) return std::nullopt;
  return result;
}

std::optional<std::pair<std::string, std::string>> ReadEntry(std::string_view bytes) {
  std::pair<std::string, std::string> result;
  FieldReader reader(bytes);
  while (const auto field = reader.Next()) {
    if (field->number == entry::kKey) result.first = field->bytes;
    if (field->number == entry::kValue) result.second = field->bytes;
  }
  if (reader.faulty()) return std::nullopt;
  return result;
}

void ReadFloats(std::string_view raw, float* values) {
  for (std::size_t i = 0; i < raw.size() / 4; ++i) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(raw[4 * i + j])) << (8 * j);
    }
    std::memcpy(values + i, &bits, sizeof bits);
  }
}

/// The widths of a perceptron whose operators and tensors are in the order of WriteOnnx; none for other graphs.
std::vector<int> WidthsOf(const Graph& graph) {
  const std::size_t layers = graph.tensors.size() / 2;
  if (layers == 0 || graph.tensors.size() != 2 * layers || graph.operators.size() != 2 * layers - 1) return {};
  for (std::size_t i = 0; i < graph.operators.size(); ++i) {
    if (graph.operators[i] != (i % 2 == 0 ? "Gemm" : "Relu")) return {};
  }
  std::vector<int> widths;
  std::uint64_t parameters = 0;
  for (std::size_t i = 0; i < layers; ++i) {
    const Tensor& weights = graph.tensors[2 * i];
    const Tensor& bias = graph.tensors[2 * i + 1];
    const int layer = static_cast<int>(i);
    if (weights.name != Numbered("weights", layer) || bias.name != Numbered("bias", layer)) return {};
    if (weights.dimensions.size() != 2 || bias.dimensions.size() != 1) return {};
    const std::uint64_t outputs = weights.dimensions[0], inputs = weights.dimensions[1];
    if (outputs == 0 || inputs == 0 || outputs > kMostParameters || inputs > kMostParameters) return {};
    parameters += (inputs + 1) * outputs;
    if (parameters > kMostParameters || bias.dimensions[0] != outputs) return {};
    if (weights.raw.size() != 4 * inputs * outputs || bias.raw.size() != 4 * outputs) return {};
    if (i == 0) widths.push_back(static_cast<int>(inputs));
    if (static_cast<std::uint64_t>(widths.back()) != inputs) return {};
    widths.push_back(static_cast<int>(outputs));
  }
  return widths;
}

}  // namespace

std::string WriteOnnx(const OnnxModel& model) {
  Message operators, message;
  operators.Bytes(opset::kDomain, "").Number(opset::kVersion, kOpset);
  message.Number(model::kIr, kIrVersion)
      .Bytes(model::kProducer, "tautline")
      .Sub(model::kGraph, GraphOf(model.network))
      .Sub(model::kOpsetImport, operators);
  for (const auto& [key, value] : model.metadata) {
    Message pair;
    pair.Bytes(entry::kKey, key).Bytes(entry::kValue, value);
    message.Sub(model::kMetadata, pair);
  }
  return message.Take();
}

Expected<OnnxModel> ReadOnnx(std::string_view bytes, const std::string& name) {
  const auto broken = [&name] {
    return InvalidInput("is no whole ONNX file: give a policy that `tautline learn` wrote", name);
  };
  std::optional<Graph> graph;
  std::map<std::string, std::string> metadata;
  FieldReader reader(bytes);
  while (const auto field = reader.Next()) {
    if (field->number == model::kGraph) {
      graph = ReadGraph(field->bytes);
      if (!graph) return broken();
    } else if (field->number == model::kMetadata) {
      auto pair = ReadEntry(field->bytes);
      if (!pair) return broken();
      metadata.insert(*std::move(pair));
    }
  }
  if (reader.faulty() || !graph) return broken();
  const std::vector<int> widths = WidthsOf(*graph);
  if (widths.empty()) {
    return tl::unexpected(Error{ErrorCode::kUnsupported,
                                "is an ONNX model, but no perceptron that tautline wrote: give a policy that "
                                "`tautline learn` wrote",
                                name});
  }
  OnnxModel result{.network = Mlp(widths), .metadata = std::move(metadata)};
  float* values = result.network.parameters().data();
  for (const Tensor& tensor : graph->tensors) {
    ReadFloats(tensor.raw, values);
    values += tensor.raw.size() / 4;
  }
  return result;
}

}  // namespace tautline
