#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "core/base/executor.h"
#include "tools/render/canvas.h"

namespace geolloyd {

/// Where the panels of a picture are, in pixels.
struct Layout {
  Size picture;
  Size panel;
  int columns = 1;         ///< panels in a row
  int caption_height = 0;  ///< of the strip below each panel; 0: no captions
};

/// As many rows as show panels of this `aspect` largest; one row where `size` leaves the height
/// open. Throws InvalidInput where panels would be too small, whatever the aspect.
Layout arrange(std::size_t panels, bool has_captions, Size size, double aspect);

/// A painted panel; no caption: "".
struct PanelImage {
  Pixels pixels;
  std::string caption;
};

/// Pictures of a mesh from one view. What is seen of the mesh is found once, for as many pictures
/// and panels as there will be.
class Picture {
 public:
  Picture(const Mesh& mesh, const View& view, Size size, std::size_t panels, bool has_captions,
          Executor& executor);
  /// By the camera that another mesh would have: so pictures of both can be compared.
  Picture(const Mesh& mesh, const Mesh& framed, const View& view, Size size, std::size_t panels,
          bool has_captions, Executor& executor);

  [[nodiscard]] const Scene& scene() const { return scene_; }

  /// PNG, on white ground with captions, on transparent ground without. Throws IoError.
  void write(const std::filesystem::path& path, std::span<const PanelImage> panels) const;

 private:
  Layout layout_;
  Scene scene_;
};

/// How many rays a picture with one panel has: its memory goes by them.
std::size_t count_samples(const Mesh& mesh, const View& view, Size size, Executor& executor);

}  // namespace geolloyd
