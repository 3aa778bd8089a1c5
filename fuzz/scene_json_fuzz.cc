// Scenes from JSON.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_answer.h"
#include "tautline/scene/json_document.h"
#include "tautline/scene/scene_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tautline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto scene =
      ParseJson(text, "s.json").and_then([](const Document& document) { return ReadScene(document, "s.json"); });
  fuzz::CheckAnswer(scene);
  return 0;
}
