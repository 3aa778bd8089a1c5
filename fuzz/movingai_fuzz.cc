// MovingAI maps.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_answer.h"
#include "tautline/scene/movingai_map.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tautline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto grid = ParseMovingAiMap(text, "m.map");
  fuzz::CheckAnswer(grid);
  if (grid) fuzz::CheckTrace(*grid);
  return 0;
}
