// Scenes from YAML.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_answer.h"
#include "tautline/scene/scene_reader.h"
#include "tautline/scene/yaml_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tautline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto scene =
      ParseYaml(text, "s.yaml").and_then([](const Document& document) { return ReadScene(document, "s.yaml"); });
  fuzz::CheckAnswer(scene);
  return 0;
}
