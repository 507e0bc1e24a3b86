#include "geolloyd/render.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/library/tessellated_graph.h"
#include "geolloyd/errors.h"
#include "tools/render/painters.h"
#include "tools/render/picture.h"

namespace geolloyd {
namespace {

bool is_side(int pixels) {
  return pixels >= least_side && pixels <= most_side;
}

Picture make_picture(const Mesh& mesh, const RenderOptions& options, Executor& executor) {
  validate(mesh);
  if (!(std::abs(options.azimuth) <= 360) || !(std::abs(options.elevation) <= 90)) {
    throw InvalidInput("view: azimuth from -360 to 360 degrees, elevation from -90 to 90");
  }
  if (!is_side(options.width) || (options.height != 0 && !is_side(options.height))) {
    throw InvalidInput("picture: width and height from " + std::to_string(least_side) + " to " +
                       std::to_string(most_side) + " pixels");
  }
  return {mesh,    {options.azimuth, options.elevation}, {options.width, options.height}, 1, false,
          executor};
}

void write(const std::filesystem::path& path, const Picture& picture, const Canvas& canvas,
           Executor& executor) {
  const std::array<PanelImage, 1> panels = {{{to_pixels(picture.scene(), canvas, executor), ""}}};
  picture.write(path, panels);
}

}  // namespace

void render_mesh(const std::filesystem::path& path, const Mesh& mesh, const RenderOptions& options,
                 Runtime& runtime) {
  Executor& executor = runtime.executor();
  const Picture picture = make_picture(mesh, options, executor);
  write(path, picture, paint_mesh(picture.scene(), executor), executor);
}

void render_regions(const std::filesystem::path& path, const Mesh& mesh,
                    const Tessellation& tessellation, const RenderOptions& options,
                    Runtime& runtime) {
  Executor& executor = runtime.executor();
  const TessellatedGraph& tessellated = internals_of(tessellation, mesh);
  const Relaxation& relaxation = tessellated.relaxation;
  const Picture picture = make_picture(mesh, options, executor);
  const std::vector<Colour> colours = colours_of_regions(
      tessellated.mesh_graph.graph, relaxation.partition, relaxation.seeds.size());
  const Canvas canvas =
      paint_regions({tessellated.mesh_graph, relaxation.partition, relaxation.seeds, colours},
                    picture.scene(), executor);
  write(path, picture, canvas, executor);
}

}  // namespace geolloyd
