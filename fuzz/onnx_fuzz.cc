// Saved policies: whatever the bytes are, they are refused or give a network that is written and read again as it is,
// and computes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/network/kernels.h"
#include "tautline/network/onnx_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tautline;
  const auto model = ReadOnnx({reinterpret_cast<const char*>(data), size}, "policy.onnx");
  if (!model) {
    TAUTLINE_CHECK(!model.error().message.empty() && ToString(model.error()).find('\n') == std::string::npos);
    return 0;
  }
  const std::string written = WriteOnnx(*model);
  const auto again = ReadOnnx(written, "again.onnx");
  TAUTLINE_CHECK(again.has_value() && again->network.widths() == model->network.widths());
  TAUTLINE_CHECK(WriteOnnx(*again) == written);
  const std::vector<float> x(static_cast<std::size_t>(model->network.inputs()), 0.5F);
  MlpPass pass(model->network.widths(), 1, PortableKernels());
  TAUTLINE_CHECK(pass.Forward(model->network, x).size() == static_cast<std::size_t>(model->network.outputs()));
  return 0;
}
