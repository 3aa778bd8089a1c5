// GeoJSON maps.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_answer.h"
#include "tautline/scene/geojson.h"
#include "tautline/scene/json_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tautline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto world = ParseJson(text, "m.geojson").and_then([](const Document& document) {
    return ReadGeoJson(document, "m.geojson");
  });
  fuzz::CheckAnswer(world);
  return 0;
}
