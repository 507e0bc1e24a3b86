#pragma once

#include <cairo/cairo.h>

#include <filesystem>
#include <memory>
#include <string>

#include "tools/render/canvas.h"

namespace geolloyd {

/// Where pictures and captions come together, and become a PNG file (Cairo).
class Sheet {
 public:
  enum class Ground { transparent, white };

  Sheet(Size size, Ground ground);

  /// Whether it is UTF-8.
  static bool can_show(const std::string& caption);

  void place(const Pixels& picture, int x, int y);
  /// Text of this height in the middle of `width` pixels, made smaller where it would not fit.
  void caption(const std::string& text, double height, int x, int y, int width);
  /// The file appears whole or not at all. Throws IoError.
  void write(const std::filesystem::path& path) const;

 private:
  template <class Object, void (*destroy)(Object*)>
  struct Destroy {
    void operator()(Object* object) const { destroy(object); }
  };
  using Surface = std::unique_ptr<cairo_surface_t, Destroy<cairo_surface_t, cairo_surface_destroy>>;
  using Context = std::unique_ptr<cairo_t, Destroy<cairo_t, cairo_destroy>>;

  Surface surface_;
  Context context_;
};

}  // namespace geolloyd
