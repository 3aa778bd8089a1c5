#include "tautline/scene/png_gray.h"

#include <png.h>

#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <vector>

namespace tautline {
namespace {

/// All pixels as libpng hands them out: kMaxCells of four channels of 8 bits.
constexpr std::size_t kMaxUnpackedBytes = 4 * kMaxCells;

/// Everything that outlives a jump out of libpng, which reports errors by longjmp: no function between setjmp and
/// libpng owns anything.
struct Decoder {
  std::string_view bytes;
  std::size_t position = 0;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::vector<png_byte> pixels;  ///< All rows, as libpng hands them out.
  std::size_t row_bytes = 0;
  std::vector<png_bytep> row_starts;
  bool too_many_pixels = false;
  bool too_many_bytes = false;
  char message[160] = "";

  explicit Decoder(std::string_view b) : bytes(b) {}
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void OnError(png_structp png, png_const_charp message) {
  auto* decoder = static_cast<Decoder*>(png_get_error_ptr(png));
  std::strncpy(decoder->message, message, sizeof(decoder->message) - 1);
  png_longjmp(png, 1);
}

void OnWarning(png_structp, png_const_charp) {}

void OnRead(png_structp png, png_bytep to, std::size_t count) {
  auto* decoder = static_cast<Decoder*>(png_get_io_ptr(png));
  if (decoder->bytes.size() - decoder->position < count) png_error(png, "the file is cut off");
  std::memcpy(to, decoder->bytes.data() + decoder->position, count);
  decoder->position += count;
}

/// Reads the header and asks for whole channels of 8 or 16 bits, in host order.
void ReadHeader(Decoder& decoder) {
  png_set_user_limits(decoder.png, 1 << 24, 1 << 24);
  png_set_read_fn(decoder.png, &decoder, OnRead);
  png_read_info(decoder.png, decoder.info);
  const std::size_t pixels = static_cast<std::size_t>(png_get_image_width(decoder.png, decoder.info)) *
                             png_get_image_height(decoder.png, decoder.info);
  decoder.too_many_pixels = pixels > kMaxCells;
  if (decoder.too_many_pixels) png_error(decoder.png, "too large");
  png_set_expand(decoder.png);
  png_set_interlace_handling(decoder.png);
  png_read_update_info(decoder.png, decoder.info);
  decoder.row_bytes = png_get_rowbytes(decoder.png, decoder.info);
  decoder.too_many_bytes = decoder.row_bytes * png_get_image_height(decoder.png, decoder.info) > kMaxUnpackedBytes;
  if (decoder.too_many_bytes) png_error(decoder.png, "too large");
}

bool DecodeHeader(Decoder& decoder) {
  if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
  ReadHeader(decoder);
  return true;
}

bool DecodePixels(Decoder& decoder) {
  if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
  png_read_image(decoder.png, decoder.row_starts.data());
  png_read_end(decoder.png, nullptr);
  return true;
}

void AllocateRows(Decoder& decoder) {
  const std::size_t rows = png_get_image_height(decoder.png, decoder.info);
  decoder.pixels.resize(rows * decoder.row_bytes);
  for (std::size_t row = 0; row < rows; ++row) {
    decoder.row_starts.push_back(decoder.pixels.data() + row * decoder.row_bytes);
  }
}

/// The decoded rows as brightness and opacity.
RasterImage ToRaster(const Decoder& decoder) {
  RasterImage image;
  image.columns = static_cast<int>(png_get_image_width(decoder.png, decoder.info));
  image.rows = static_cast<int>(png_get_image_height(decoder.png, decoder.info));
  const bool wide = png_get_bit_depth(decoder.png, decoder.info) == 16;
  image.maximum = wide ? 65535 : 255;
  const std::size_t channels = png_get_channels(decoder.png, decoder.info);  // 1, 2 with alpha, 3, 4 with alpha
  const bool colour = channels >= 3, alpha = channels % 2 == 0;
  const std::size_t count = static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
  image.colour_sum.resize(count);
  if (alpha) image.alpha.resize(count);
  const std::size_t width = wide ? 2 : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const png_byte* pixel = decoder.pixels.data() + i * channels * width;
    const auto channel = [pixel, wide](std::size_t c) {
      return wide ? std::uint32_t{pixel[2 * c]} * 256 + pixel[2 * c + 1] : std::uint32_t{pixel[c]};
    };
    image.colour_sum[i] = colour ? channel(0) + channel(1) + channel(2) : 3 * channel(0);
    if (alpha) image.alpha[i] = static_cast<std::uint16_t>(channel(channels - 1));
  }
  return image;
}

}  // namespace

Expected<RasterImage> ParsePng(std::string_view bytes, const std::string& file) {
  Decoder decoder(bytes);
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, OnError, OnWarning);
  decoder.info = decoder.png == nullptr ? nullptr : png_create_info_struct(decoder.png);
  if (decoder.info == nullptr) return InvalidInput("libpng cannot be started", file);
  bool decoded = DecodeHeader(decoder);
  if (decoded) {
    AllocateRows(decoder);
    decoded = DecodePixels(decoder);
  }
  if (decoded) return ToRaster(decoder);
  if (decoder.too_many_pixels) {
    return tl::unexpected<Error>(
        Error{ErrorCode::kLimitExceeded, "more than 8192 x 8192 pixels: scale the map down", file});
  }
  if (decoder.too_many_bytes) {
    return tl::unexpected<Error>(
        Error{ErrorCode::kLimitExceeded, "larger than 256 MiB when unpacked: convert it to 8-bit grey", file});
  }
  return InvalidInput("not a readable PNG: " + std::string(decoder.message), file);
}

}  // namespace tautline
