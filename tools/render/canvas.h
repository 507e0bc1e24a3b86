#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/loops.h"
#include "tools/render/labels.h"
#include "tools/render/scene.h"

namespace geolloyd {

/// Colour of each sample; what the samples do not hit is transparent.
using Canvas = std::vector<Colour>;

/// A line of even width with round ends; a disc where both ends are one.
struct Stroke {
  Vec3 from;  ///< in the space of the picture (view.h)
  Vec3 to;
  double half_width;  ///< pixels
};

struct Ink {
  Colour colour{};
  double opacity = 1;
};

/// `part` of `over` laid over `under`.
Colour blend(const Colour& under, const Colour& over, double part);

/// The surface with the colours that colour_of(sample) gives, lit.
template <class ColourOf>
Canvas paint(const Scene& scene, Executor& executor, ColourOf&& colour_of) {
  Canvas canvas(scene.hit.size());
  parallel_for(executor, canvas.size(), small_items, [&](std::size_t i) {
    if (scene.hit[i].triangle == no_id) return;
    canvas[i] = blend({0, 0, 0}, colour_of(i), scene.light[i]);
  });
  return canvas;
}

/// Draws strokes as one layer, where no part of the surface hides them: so far as they run below it
/// only by what their width and the chord of an arc amount to, they are seen.
void draw(std::span<const Stroke> strokes, const Ink& ink, const Scene& scene, Canvas& canvas,
          Executor& executor);

/// A picture, row by row: alpha, red, green, blue from the highest byte on, multiplied by alpha.
struct Pixels {
  Size size;
  std::vector<std::uint32_t> argb;
};

Pixels to_pixels(const Scene& scene, const Canvas& canvas, Executor& executor);

}  // namespace geolloyd
