#include "tautline/scene/movingai_map.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "tautline/scene/raster_image.h"
#include "tautline/scene/text_lines.h"

namespace tautline {
namespace {

struct Header {
  int height = 0;
  int width = 0;
};

std::string Where(const std::string& file, const TextLines& lines) {
  return file + ":" + std::to_string(std::max(lines.number(), 1));
}

/// "type octile", then height and width in either order, then "map".
Expected<Header> ReadHeader(TextLines& lines, const std::string& file) {
  Header header;
  for (auto line = lines.Next(); line; line = lines.Next()) {
    const auto words = SplitWords(*line);
    const std::string_view key = words.empty() ? std::string_view() : words[0];
    if (words.size() == 1 && key == "map") break;
    const std::string_view value = words.size() == 2 ? words[1] : std::string_view();
    if (key == "type" && value == "octile") continue;
    const auto count = ParseCount(value);
    if ((key != "height" && key != "width") || !count || *count == 0) {
      return InvalidInput("a MovingAI map starts with 'type octile', 'height N', 'width N' and 'map'",
                          Where(file, lines));
    }
    (key == "height" ? header.height : header.width) = *count;
  }
  if (header.height > 0 && header.width > 0) return header;
  return InvalidInput("the header of the MovingAI map has no height or no width", Where(file, lines));
}

CellState StateOf(char sign) {
  return sign == '.' || sign == 'G' || sign == 'S' ? CellState::kFree : CellState::kBlocked;
}

std::string CountText(std::size_t count, int wanted, const char* what) {
  return std::to_string(count) + " " + what + ", but the header says " + std::to_string(wanted);
}

/// Only blank lines may follow the last row.
bool OnlyBlank(TextLines& lines) {
  for (auto line = lines.Next(); line; line = lines.Next()) {
    if (!SplitWords(*line).empty()) return false;
  }
  return true;
}

}  // namespace

Expected<OccupancyGrid> ParseMovingAiMap(std::string_view text, const std::string& file) {
  TextLines lines(text);
  const auto header = ReadHeader(lines, file);
  if (!header) return tl::unexpected<Error>(header.error());
  // Not as std::size_t, which has 32 bits in the browser.
  if (static_cast<std::uint64_t>(header->height) * static_cast<std::uint64_t>(header->width) > kMaxCells) {
    return tl::unexpected<Error>(
        Error{ErrorCode::kLimitExceeded, "more than 8192 x 8192 cells: cut or scale the map", file});
  }
  if (text.size() < static_cast<std::size_t>(header->height) * static_cast<std::size_t>(header->width)) {
    return InvalidInput("the map ends before its " + std::to_string(header->height) + " rows of " +
                            std::to_string(header->width) + " cells: is it cut off?",
                        file);
  }
  OccupancyGrid grid = MakeGrid(header->width, header->height, CellState::kBlocked);
  for (int row = header->height - 1; row >= 0; --row) {
    const auto line = lines.Next();
    if (!line) {
      const auto rows = static_cast<std::size_t>(header->height - 1 - row);
      return InvalidInput("the map has " + CountText(rows, header->height, "rows"), Where(file, lines));
    }
    if (line->size() != static_cast<std::size_t>(header->width)) {
      return InvalidInput("the row has " + CountText(line->size(), header->width, "cells"), Where(file, lines));
    }
    std::transform(line->begin(), line->end(), grid.cells.begin() + static_cast<std::ptrdiff_t>(grid.index(0, row)),
                   StateOf);
  }
  if (OnlyBlank(lines)) return grid;
  return InvalidInput("the map has more rows than the header says: " + std::to_string(header->height),
                      Where(file, lines));
}

}  // namespace tautline
