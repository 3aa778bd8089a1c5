// Networks as files in the ONNX format, which other programs run.
#ifndef TAUTLINE_NETWORK_ONNX_FILE_H_
#define TAUTLINE_NETWORK_ONNX_FILE_H_

#include <map>
#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/network/mlp.h"

namespace tautline {

/// A network and what is to be known about it.
struct OnnxModel {
  Mlp network;                                  ///< Its weights.
  std::map<std::string, std::string> metadata;  ///< How it was made; printed in the order of the keys.
};

/// The bytes of an ONNX model (onnx.ai): opset 13, one Gemm a layer with a Relu between, the input "observation" and
/// the output "values", floats with one row for each sample. The same model gives the same bytes. O(parameters).
std::string WriteOnnx(const OnnxModel& model);

/// Reads what WriteOnnx wrote. Errors, with `name` as where: the bytes are no such model, or not whole, or have more
/// than 100 million parameters; kUnsupported where it is an ONNX model of another kind. O(bytes).
[[nodiscard]] Expected<OnnxModel> ReadOnnx(std::string_view bytes, const std::string& name);

}  // namespace tautline

#endif  // TAUTLINE_NETWORK_ONNX_FILE_H_
