// Writes a network as ONNX, and some inputs with the outputs that tautline computes for them, for check_onnx.py.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tautline/network/mlp.h"
#include "tautline/network/onnx_file.h"

int main(int argc, char** argv) {
  using namespace tautline;
  if (argc != 3) {
    std::fprintf(stderr, "call: onnx_sample FILE.onnx FILE.csv\n");
    return 2;
  }
  Rng rng(11);
  const OnnxModel model{.network = Mlp::Random({3, 256, 256, 3}, rng), .metadata = {{"kernels", "portable"}}};
  std::ofstream(argv[1], std::ios::binary) << WriteOnnx(model);
  std::ofstream table(argv[2]);
  table.precision(9);
  MlpPass pass(model.network.widths(), 1, PortableKernels());
  for (int i = 0; i < 200; ++i) {
    std::vector<float> row;
    for (int j = 0; j < 3; ++j) row.push_back(static_cast<float>(rng.Uniform(-3, 3)));
    const auto values = pass.Forward(model.network, row);
    row.insert(row.end(), values.begin(), values.end());
    for (std::size_t j = 0; j < row.size(); ++j) table << (j == 0 ? "" : ",") << row[j];
    table << "\n";
  }
  return table.good() ? 0 : 1;
}
