#include "tautline/network/onnx_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/base/test_scale.h"

namespace tautline {
namespace {

OnnxModel Sample() {
  Rng rng(4);
  return {.network = Mlp::Random({3, 7, 5, 2}, rng), .metadata = {{"kernels", "portable"}, {"empty", ""}}};
}

TEST(OnnxFile, ComesBackAsItWas) {
  const OnnxModel model = Sample();
  const auto read = ReadOnnx(WriteOnnx(model), "policy.onnx");
  ASSERT_TRUE(read.has_value()) << ToString(read.error());
  EXPECT_EQ(read->network.widths(), model.network.widths());
  EXPECT_THAT(read->network.parameters(), testing::ElementsAreArray(model.network.parameters()));
  EXPECT_EQ(read->metadata, model.metadata);
  EXPECT_EQ(WriteOnnx(*read), WriteOnnx(model));
}

TEST(OnnxFile, ANetworkWithoutHiddenLayersComesBack) {
  Rng rng(5);
  const OnnxModel model{.network = Mlp::Random({4, 3}, rng), .metadata = {}};
  const auto read = ReadOnnx(WriteOnnx(model), "policy.onnx");
  ASSERT_TRUE(read.has_value());
  EXPECT_THAT(read->network.parameters(), testing::ElementsAreArray(model.network.parameters()));
}

TEST(OnnxFile, NoPartOfAFileIsTakenForTheWhole) {
  OnnxModel model = Sample();
  model.metadata.clear();
  const std::string bytes = WriteOnnx(model);
  // The last field tells the opset, which the reader does not need.
  const std::size_t graph_end = bytes.size() - 6;
  for (std::size_t size = 0; size < graph_end; ++size) {
    const auto read = ReadOnnx(std::string_view(bytes).substr(0, size), "policy.onnx");
    ASSERT_FALSE(read.has_value()) << size;
    EXPECT_EQ(read.error().where, "policy.onnx");
  }
}

TEST(OnnxFile, ChangedBytesNeverBreakTheReader) {
  const std::string bytes = WriteOnnx(Sample());
  Rng rng(6);
  int refused = 0;
  const auto trials = ScaledTestCount(20'000);
  for (std::int64_t trial = 0; trial < trials; ++trial) {
    std::string changed = bytes;
    for (int i = rng.UniformInt(1, 4); i > 0; --i) {
      changed[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(changed.size()) - 1))] =
          static_cast<char>(rng.Next());
    }
    refused += ReadOnnx(changed, "policy.onnx").has_value() ? 0 : 1;
  }
  EXPECT_GT(refused, 0);
}

TEST(OnnxFile, OtherFilesAreRefused) {
  const auto text = ReadOnnx("world: {outline: []}", "scene.yaml");
  ASSERT_FALSE(text.has_value());
  EXPECT_THAT(ToString(text.error()), testing::StartsWith("scene.yaml: is no whole ONNX file"));
  EXPECT_FALSE(ReadOnnx("", "nothing").has_value());
}

}  // namespace
}  // namespace tautline
