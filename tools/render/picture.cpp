#include "tools/render/picture.h"

#include <algorithm>
#include <optional>

#include "core/base/loops.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/errors.h"
#include "tools/render/sheet.h"

namespace geolloyd {
namespace {

constexpr int gap = 8;            // between panels
constexpr int least_length = 24;  // of a panel's side

int text_height(int panel_width) {
  return std::clamp(panel_width / 24, 11, 30);
}

Layout arrange_in(int columns, std::size_t panels, bool has_captions, Size size, double aspect) {
  Layout layout{size, {(size.width - (columns - 1) * gap) / columns, 0}, columns, 0};
  const int rows = (static_cast<int>(panels) + columns - 1) / columns;
  if (has_captions) layout.caption_height = 2 * text_height(layout.panel.width);
  const int beside = rows * layout.caption_height + (rows - 1) * gap;
  if (size.height == 0) {
    layout.panel.height = std::max(least_length, static_cast<int>(layout.panel.width * aspect));
    layout.picture.height = rows * layout.panel.height + beside;
  } else {
    layout.panel.height = (size.height - beside) / rows;
  }
  return layout;
}

// How large something of this aspect is in a panel.
double scale_of(const Layout& layout, double aspect) {
  return std::min<double>(layout.panel.width, layout.panel.height / aspect);
}

}  // namespace

Layout arrange(std::size_t panels, bool has_captions, Size size, double aspect) {
  std::optional<Layout> best;
  const int least_columns = size.height > 0 ? 1 : static_cast<int>(panels);
  for (int columns = static_cast<int>(panels); columns >= least_columns; --columns) {
    const Layout layout = arrange_in(columns, panels, has_captions, size, aspect);
    if (layout.panel.width < least_length || layout.panel.height < least_length) continue;
    if (!best || scale_of(layout, aspect) > scale_of(*best, aspect)) best = layout;
  }
  if (best) return *best;
  throw InvalidInput("--size: too small for " + std::to_string(panels) + " panels");
}

Picture::Picture(const Mesh& mesh, const View& view, Size size, std::size_t panels,
                 bool has_captions, Executor& executor)
    : Picture(mesh, mesh, view, size, panels, has_captions, executor) {}

Picture::Picture(const Mesh& mesh, const Mesh& framed, const View& view, Size size,
                 std::size_t panels, bool has_captions, Executor& executor) {
  const Outline outline = outline_of(referenced_positions(framed, executor), view);
  layout_ = arrange(panels, has_captions, size, aspect_of(outline));
  Camera camera = fit_camera(outline, layout_.panel);
  if (&mesh != &framed) {  // nothing of it is behind the viewer
    for (const Vec3& p : referenced_positions(mesh, executor)) {
      camera.corner.z() = std::min(camera.corner.z(), camera.axes(p).z() - camera.pixel);
    }
  }
  scene_ = make_scene(mesh, camera, Shading::smooth, executor);
}

void Picture::write(const std::filesystem::path& path, std::span<const PanelImage> panels) const {
  Sheet sheet(layout_.picture,
              layout_.caption_height > 0 ? Sheet::Ground::white : Sheet::Ground::transparent);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto number = static_cast<int>(i);
    const int x = number % layout_.columns * (layout_.panel.width + gap);
    const int y = number / layout_.columns * (layout_.panel.height + layout_.caption_height + gap);
    sheet.place(panels[i].pixels, x, y);
    if (panels[i].caption.empty()) continue;
    const int height = text_height(layout_.panel.width);
    sheet.caption(panels[i].caption, height, x, y + layout_.panel.height + height * 4 / 3,
                  layout_.panel.width);
  }
  sheet.write(path);
}

std::size_t count_samples(const Mesh& mesh, const View& view, Size size, Executor& executor) {
  const Outline outline = outline_of(referenced_positions(mesh, executor), view);
  return SampleGrid{arrange(1, false, size, aspect_of(outline)).panel}.count();
}

}  // namespace geolloyd
