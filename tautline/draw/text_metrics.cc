#include "tautline/draw/text_metrics.h"

#include <algorithm>

namespace tautline {
namespace {

bool Continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Advance width in ems.
double Advance(char lead) {
  constexpr std::string_view kNarrow = " ,.:;'!|ijlI/\\[]()ft";
  constexpr std::string_view kWide = "mwMW@%+<>=~^_";
  const unsigned char byte = static_cast<unsigned char>(lead);
  if (byte >= 0xE3) return 1.0;  // Mostly full-width scripts.
  if (byte >= 0x80) return 0.65;
  if (kNarrow.find(lead) != std::string_view::npos) return 0.38;
  if (kWide.find(lead) != std::string_view::npos) return 0.9;
  return lead >= 'A' && lead <= 'Z' ? 0.7 : 0.625;
}

/// The length of the first word of `text`, with a unit that follows it: a number is not parted from
/// its "m".
std::size_t FirstWord(std::string_view text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string_view rest = text.substr(std::min(end + 1, text.size()));
  const std::string_view next = rest.substr(0, rest.find(' '));
  const bool unit = next == "m" || next == "m," || next == "m." || next == "m²";
  return unit ? end + 1 + next.size() : end;
}

}  // namespace

double TextWidth(std::string_view text, double size, bool bold) {
  double ems = 0;
  for (const char c : text) {
    if (!Continues(c)) ems += Advance(c);
  }
  return ems * size * (bold ? 1.12 : 1.0);
}

std::string Ellipsize(std::string_view text, double size, double width) {
  if (TextWidth(text, size) <= width) return std::string(text);
  std::size_t end = text.size();
  while (end > 0 && TextWidth(text.substr(0, end), size) + size > width) {
    do {
      --end;
    } while (end > 0 && Continues(text[end]));
  }
  return std::string(text.substr(0, end)) + "…";
}

std::vector<std::string> Wrap(std::string_view text, const WrapOptions& options) {
  std::vector<std::string> lines;
  std::string line;
  const auto fits = [&](std::string_view candidate) {
    return TextWidth(candidate, options.size, options.bold) <= options.width;
  };
  while (!text.empty()) {
    const std::size_t space = FirstWord(text);
    const std::string word(text.substr(0, space));
    if (!line.empty() && !fits(std::string(line).append(" ").append(word))) {
      if (static_cast<int>(lines.size()) + 1 == options.max_lines) {
        line += " " + std::string(text);
        break;
      }
      lines.push_back(line);
      line = word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
    text.remove_prefix(std::min(space + 1, text.size()));
  }
  if (!line.empty()) lines.push_back(line);
  for (std::string& one : lines) {
    if (!fits(one)) one = Ellipsize(one, options.size * (options.bold ? 1.12 : 1.0), options.width);
  }
  return lines;
}

}  // namespace tautline
