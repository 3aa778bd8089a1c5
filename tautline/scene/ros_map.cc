#include "tautline/scene/ros_map.h"

#include <cmath>

#include "tautline/scene/field_reader.h"

namespace tautline {
namespace {

using Kind = Document::Kind;

void ReadOrigin(const Document& value, FieldReader& reader, RosMapSettings& settings) {
  if (!reader.IsList(value, "origin")) return;
  if (value.items.size() != 3) {
    return reader.Fail(value.position, "origin must be [x, y, yaw], not " + Describe(value));
  }
  settings.origin = {reader.ReadNumber(value.items[0], "origin[1]"), reader.ReadNumber(value.items[1], "origin[2]")};
  reader.Check(PointFault(settings.origin), value.position, "origin");
  settings.yaw_rad = reader.ReadNumber(value.items[2], "origin[3]");
}

double ReadFraction(const Document* value, const char* what, FieldReader& reader) {
  if (value == nullptr) return 0;
  const double fraction = reader.ReadNonNegative(*value, what);
  if (fraction > 1) reader.Fail(value->position, std::string(what) + " must lie between 0 and 1");
  return fraction;
}

/// 0, 1, true or false, and any other number as map_server takes it: not zero is true.
bool ReadNegate(const Document* value, FieldReader& reader) {
  if (value == nullptr) return false;
  return value->is(Kind::kBool) ? value->boolean : reader.ReadNumber(*value, "negate") != 0;
}

RosMapMode ReadMode(const Document* value, FieldReader& reader) {
  if (value == nullptr) return RosMapMode::kTrinary;
  const std::string mode = reader.ReadText(*value, "mode");
  if (mode == "scale") return RosMapMode::kScale;
  if (mode == "raw") return RosMapMode::kRaw;
  if (mode != "trinary") {
    reader.Fail(value->position, "mode is " + Quoted(mode) + ": it must be trinary, scale or raw");
  }
  return RosMapMode::kTrinary;
}

void CheckSizes(const Document& document, const RosMapSettings& settings, FieldReader& reader) {
  if (settings.resolution_m < 1e-6 || settings.resolution_m > 1e6) {
    reader.Fail(document.Find("resolution")->position, "resolution must lie between 1e-6 and 1e6 metres per pixel");
  }
  if (settings.free_thresh > settings.occupied_thresh) {
    reader.Fail(document.Find("free_thresh")->position, "free_thresh must not be above occupied_thresh");
  }
}

/// The mean brightness of a pixel, 0..1.
double Shade(const RasterImage& image, std::size_t pixel, bool with_alpha) {
  const double sum = image.colour_sum[pixel] + (with_alpha ? static_cast<double>(image.alpha[pixel]) : 0.0);
  return sum / ((with_alpha ? 4.0 : 3.0) * image.maximum);
}

CellState ByThresholds(double occupied, const RosMapSettings& settings) {
  if (occupied > settings.occupied_thresh) return CellState::kBlocked;
  return occupied < settings.free_thresh ? CellState::kFree : CellState::kUnknown;
}

CellState StateOf(const RasterImage& image, std::size_t pixel, const RosMapSettings& settings) {
  const bool transparent = !image.alpha.empty();
  const double shade = Shade(image, pixel, transparent && settings.mode == RosMapMode::kTrinary);
  if (settings.mode == RosMapMode::kRaw) {
    const double percent = std::round(shade * 255);
    return percent > 100 ? CellState::kUnknown : ByThresholds(percent / 100, settings);
  }
  if (settings.mode == RosMapMode::kScale && transparent && image.alpha[pixel] != image.maximum) {
    return CellState::kUnknown;
  }
  return ByThresholds(settings.negate ? shade : 1 - shade, settings);
}

}  // namespace

Expected<RosMapSettings> ReadRosMapSettings(const Document& document, const std::string& file) {
  FieldReader reader(file);
  RosMapSettings settings;
  if (!reader.IsMap(document, "a ROS map")) return tl::unexpected<Error>(reader.error());
  if (const Document* value = reader.Required(document, "the ROS map", "image")) {
    settings.image = reader.ReadText(*value, "image");
  }
  if (const Document* value = reader.Required(document, "the ROS map", "resolution")) {
    settings.resolution_m = reader.ReadPositive(*value, "resolution");
  }
  if (const Document* value = reader.Required(document, "the ROS map", "origin")) ReadOrigin(*value, reader, settings);
  settings.negate = ReadNegate(reader.Required(document, "the ROS map", "negate"), reader);
  settings.occupied_thresh =
      ReadFraction(reader.Required(document, "the ROS map", "occupied_thresh"), "occupied_thresh", reader);
  settings.free_thresh = ReadFraction(reader.Required(document, "the ROS map", "free_thresh"), "free_thresh", reader);
  settings.mode = ReadMode(document.Find("mode"), reader);
  if (reader.ok()) CheckSizes(document, settings, reader);
  if (!reader.ok()) return tl::unexpected<Error>(reader.error());
  return settings;
}

OccupancyGrid GridFromRosImage(const RasterImage& image, const RosMapSettings& settings) {
  OccupancyGrid grid = MakeGrid(image.columns, image.rows, CellState::kUnknown);
  grid.cell_m = settings.resolution_m;
  grid.origin = settings.origin;
  grid.yaw_rad = settings.yaw_rad;
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.columns; ++column) {
      const std::size_t pixel = image.index(column, image.rows - 1 - row);
      grid.cells[grid.index(column, row)] = StateOf(image, pixel, settings);
    }
  }
  return grid;
}

}  // namespace tautline
