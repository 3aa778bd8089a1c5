// ROS maps: a YAML file, a line with three dashes, a PGM.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_answer.h"
#include "tautline/scene/pgm.h"
#include "tautline/scene/ros_map.h"
#include "tautline/scene/yaml_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tautline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  constexpr std::string_view kSeparator = "\n---\n";
  const std::size_t end = text.find(kSeparator);
  const auto settings = ParseYaml(text.substr(0, end), "m.yaml").and_then([](const Document& document) {
    return ReadRosMapSettings(document, "m.yaml");
  });
  fuzz::CheckAnswer(settings);
  if (!settings || end == std::string_view::npos) return 0;
  const auto image = ParsePgm(text.substr(end + kSeparator.size()), "m.pgm");
  fuzz::CheckAnswer(image);
  if (image) fuzz::CheckTrace(GridFromRosImage(*image, *settings));
  return 0;
}
