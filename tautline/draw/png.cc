#include "tautline/draw/png.h"

#include <cairo.h>
#include <fontconfig/fontconfig.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>

namespace tautline {
namespace {

struct Release {
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
  void operator()(GInputStream* stream) const { g_object_unref(stream); }
  void operator()(GError* error) const { g_error_free(error); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
  void operator()(FcObjectSet* objects) const { FcObjectSetDestroy(objects); }
  void operator()(FcFontSet* fonts) const { FcFontSetDestroy(fonts); }
};

tl::unexpected<Error> RenderFailure(GError* error) {
  const std::unique_ptr<GError, Release> owned(error);
  return InvalidInput(std::string("the picture cannot be rendered: ") + (owned ? owned->message : "unknown error"),
                      "svg");
}

/// The parsed document, or nothing and an error. Large maps are single paths of many megabytes,
/// which the reader takes only when it is told that it may.
std::unique_ptr<RsvgHandle, Release> ReadSvg(const std::string& svg, GError** error) {
  const std::unique_ptr<GInputStream, Release> stream(
      g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr));
  return std::unique_ptr<RsvgHandle, Release>(
      rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, error));
}

cairo_status_t AppendBytes(void* closure, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

Expected<std::string> Encode(cairo_surface_t* surface) {
  std::string bytes;
  if (cairo_surface_write_to_png_stream(surface, AppendBytes, &bytes) != CAIRO_STATUS_SUCCESS) {
    return InvalidInput("the picture cannot be encoded as PNG", "svg");
  }
  return bytes;
}

Expected<std::string> RenderOnWhite(RsvgHandle* handle, int width, int height) {
  const std::unique_ptr<cairo_surface_t, Release> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    return tl::unexpected<Error>(
        Error{ErrorCode::kLimitExceeded, "no memory for a picture of this size; use a smaller scale", "scale"});
  }
  const std::unique_ptr<cairo_t, Release> context(cairo_create(surface.get()));
  cairo_set_source_rgb(context.get(), 1, 1, 1);
  cairo_paint(context.get());
  const RsvgRectangle frame{0, 0, static_cast<double>(width), static_cast<double>(height)};
  GError* error = nullptr;
  if (!rsvg_handle_render_document(handle, context.get(), &frame, &error)) return RenderFailure(error);
  cairo_surface_flush(surface.get());
  return Encode(surface.get());
}

}  // namespace

Expected<std::string> RenderPng(const std::string& svg, double scale) {
  if (!(scale > 0) || !std::isfinite(scale)) return InvalidInput("the scale of a picture must be positive", "scale");
  GError* error = nullptr;
  const std::unique_ptr<RsvgHandle, Release> handle = ReadSvg(svg, &error);
  if (!handle) return RenderFailure(error);
  gdouble width = 0, height = 0;
  if (!rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) || !(width > 0) || !(height > 0)) {
    return InvalidInput("the picture says no width and height in pixels", "svg");
  }
  width = std::ceil(width * scale);
  height = std::ceil(height * scale);
  if (width > kMaxPngPixels || height > kMaxPngPixels) {
    return tl::unexpected<Error>(Error{
        ErrorCode::kLimitExceeded,
        "the picture would be larger than " + std::to_string(kMaxPngPixels) + " pixels; use a smaller scale", "scale"});
  }
  return RenderOnWhite(handle.get(), static_cast<int>(width), static_cast<int>(height));
}

bool HasFont() {
  const std::unique_ptr<FcPattern, Release> any(FcPatternCreate());
  const std::unique_ptr<FcObjectSet, Release> no_details(FcObjectSetCreate());
  const std::unique_ptr<FcFontSet, Release> fonts(FcFontList(nullptr, any.get(), no_details.get()));
  return fonts && fonts->nfont > 0;
}

}  // namespace tautline
