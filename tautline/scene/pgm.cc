#include "tautline/scene/pgm.h"

#include <cstdint>
#include <optional>

namespace tautline {
namespace {

constexpr std::int64_t kLargestValue = 65535;

bool IsBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// Reads the bytes from the front and counts lines for messages.
class Scanner {
 public:
  explicit Scanner(std::string_view bytes) : bytes_(bytes) {}

  std::size_t position() const { return position_; }
  void Skip(std::size_t count) { position_ += count; }

  std::string Where(const std::string& file) const {
    std::size_t line = 1;
    for (const char c : bytes_.substr(0, position_)) line += c == '\n' ? 1 : 0;
    return file + ":" + std::to_string(line);
  }

  /// The next number after blanks and comments; nothing when there is none or it is above `largest`.
  std::optional<std::int64_t> Number(std::int64_t largest) {
    SkipBlanks();
    if (position_ == bytes_.size() || !IsDigit(bytes_[position_])) return std::nullopt;
    std::int64_t number = 0;
    for (; position_ < bytes_.size() && IsDigit(bytes_[position_]); ++position_) {
      number = number * 10 + (bytes_[position_] - '0');
      if (number > largest) return std::nullopt;
    }
    return number;
  }

  /// The one blank that ends a binary header.
  bool OneBlank() { return position_ < bytes_.size() && IsBlank(bytes_[position_++]); }

 private:
  void SkipBlanks() {
    while (position_ < bytes_.size() && (IsBlank(bytes_[position_]) || bytes_[position_] == '#')) {
      if (bytes_[position_] == '#') {
        while (position_ < bytes_.size() && bytes_[position_] != '\n' && bytes_[position_] != '\r') ++position_;
      } else {
        ++position_;
      }
    }
  }

  std::string_view bytes_;
  std::size_t position_ = 0;
};

/// P2: numbers as text.
bool ReadPlain(Scanner& scanner, RasterImage& image) {
  for (std::uint32_t& sum : image.colour_sum) {
    const auto value = scanner.Number(image.maximum);
    if (!value) return false;
    sum = 3 * static_cast<std::uint32_t>(*value);
  }
  return true;
}

/// P5: one or two bytes per pixel, `bytes` from the first pixel on.
bool ReadBinary(std::string_view bytes, RasterImage& image) {
  const std::size_t width = image.maximum > 255 ? 2 : 1;
  for (std::size_t i = 0; i < image.colour_sum.size(); ++i) {
    std::uint32_t value = static_cast<unsigned char>(bytes[i * width]);
    if (width == 2) value = value * 256 + static_cast<unsigned char>(bytes[i * width + 1]);
    if (value > static_cast<std::uint32_t>(image.maximum)) return false;
    image.colour_sum[i] = 3 * value;
  }
  return true;
}

Error TooSmall(const std::string& where, const RasterImage& image) {
  return {ErrorCode::kInvalidInput,
          "the PGM ends before its " + std::to_string(image.columns) + " x " + std::to_string(image.rows) +
              " pixels: is it cut off?",
          where};
}

}  // namespace

Expected<RasterImage> ParsePgm(std::string_view bytes, const std::string& file) {
  const bool plain = bytes.substr(0, 2) == "P2";
  if (!plain && bytes.substr(0, 2) != "P5") {
    return tl::unexpected<Error>(
        Error{ErrorCode::kUnsupported, "not a PGM: it must start with P2 or P5; convert it to PGM or PNG", file});
  }
  Scanner scanner(bytes);
  scanner.Skip(2);
  constexpr std::int64_t kLongestSide = 1 << 24;
  const auto columns = scanner.Number(kLongestSide), rows = scanner.Number(kLongestSide);
  const auto maximum = scanner.Number(kLargestValue);
  if (!columns || !rows || !maximum || *columns == 0 || *rows == 0 || *maximum == 0) {
    return InvalidInput("the PGM header must hold width, height and a largest value of 1 to 65535",
                        scanner.Where(file));
  }
  // Not as std::size_t, which has 32 bits in the browser.
  if (*columns * *rows > static_cast<std::int64_t>(kMaxCells)) {
    return tl::unexpected<Error>(
        Error{ErrorCode::kLimitExceeded, "more than 8192 x 8192 pixels: scale the map down", file});
  }
  RasterImage image;
  image.columns = static_cast<int>(*columns);
  image.rows = static_cast<int>(*rows);
  image.maximum = static_cast<int>(*maximum);
  const std::size_t pixels = static_cast<std::size_t>(*columns) * static_cast<std::size_t>(*rows);
  const std::size_t needed = plain ? 2 * pixels - 1 : pixels * (image.maximum > 255 ? 2 : 1);
  const bool separated = plain || scanner.OneBlank();
  if (!separated || bytes.size() - scanner.position() < needed) {
    return tl::unexpected<Error>(TooSmall(file, image));
  }
  image.colour_sum.resize(pixels);
  if (plain ? ReadPlain(scanner, image) : ReadBinary(bytes.substr(scanner.position()), image)) return image;
  return InvalidInput("a pixel is missing or is not a number up to " + std::to_string(image.maximum),
                      plain ? scanner.Where(file) : file);
}

}  // namespace tautline
