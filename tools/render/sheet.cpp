#include "tools/render/sheet.h"

#include <algorithm>
#include <exception>

#include "core/text/file_writer.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

constexpr double ink = 0.2;  // of captions: dark grey

void check(cairo_status_t status, const std::string& what) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw IoError(what + ": cannot make the picture: " + cairo_status_to_string(status));
}

// An exception must not cross Cairo's C code, so it waits here.
struct Stream {
  FileWriter& out;
  std::exception_ptr error;

  static cairo_status_t write(void* self, const unsigned char* bytes, unsigned count) {
    auto& stream = *static_cast<Stream*>(self);
    try {
      stream.out.text({reinterpret_cast<const char*>(bytes), count});
      return CAIRO_STATUS_SUCCESS;
    } catch (...) {
      stream.error = std::current_exception();
      return CAIRO_STATUS_WRITE_ERROR;
    }
  }
};

}  // namespace

Sheet::Sheet(Size size, Ground ground)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, size.width, size.height)),
      context_(cairo_create(surface_.get())) {
  if (ground == Ground::transparent) return;
  cairo_set_source_rgb(context_.get(), 1, 1, 1);
  cairo_paint(context_.get());
}

bool Sheet::can_show(const std::string& caption) {
  const Sheet smallest({1, 1}, Ground::transparent);
  cairo_text_extents_t extents;
  cairo_text_extents(smallest.context_.get(), caption.c_str(), &extents);
  return cairo_status(smallest.context_.get()) != CAIRO_STATUS_INVALID_STRING;
}

void Sheet::place(const Pixels& picture, int x, int y) {
  // Cairo only reads it, but has no way to say so.
  auto* const bytes = reinterpret_cast<unsigned char*>(
      const_cast<std::uint32_t*>(picture.argb.data()));  // NOLINT(*-const-cast)
  const Surface source(cairo_image_surface_create_for_data(
      bytes, CAIRO_FORMAT_ARGB32, picture.size.width, picture.size.height, 4 * picture.size.width));
  cairo_set_source_surface(context_.get(), source.get(), x, y);
  cairo_paint(context_.get());
  cairo_set_source_rgb(context_.get(), 0, 0, 0);  // lets go of the source
}

void Sheet::caption(const std::string& text, double height, int x, int y, int width) {
  cairo_t* const context = context_.get();
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_text_extents_t extents;
  cairo_set_font_size(context, height);
  cairo_text_extents(context, text.c_str(), &extents);
  const double shrink = std::min(1.0, width / std::max(1.0, extents.width));
  cairo_set_font_size(context, height * shrink);
  cairo_set_source_rgb(context, ink, ink, ink);
  cairo_move_to(context, x + (width - shrink * extents.width) / 2 - shrink * extents.x_bearing, y);
  cairo_show_text(context, text.c_str());
}

void Sheet::write(const std::filesystem::path& path) const {
  check(cairo_status(context_.get()), path.string());
  FileWriter out(path);
  Stream stream{out, nullptr};
  const cairo_status_t status =
      cairo_surface_write_to_png_stream(surface_.get(), Stream::write, &stream);
  if (stream.error) std::rethrow_exception(stream.error);
  check(status, path.string());
  out.commit();
}

}  // namespace geolloyd
