// PNG images.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_answer.h"
#include "tautline/scene/png_gray.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tautline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  fuzz::CheckAnswer(ParsePng(text, "m.png"));
  return 0;
}
