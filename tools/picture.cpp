#include "tools/picture.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/bounding_box.h"
#include "core/errors.h"
#include "core/file_writer.h"
#include "tools/ray_caster.h"
#include "tools/unit_frame.h"

namespace geolloyd {
namespace {

constexpr int width = 1280;
constexpr int samples_per_side = 3;  // of a pixel
constexpr double margin = 1.04;      // of the picture, around the mesh

/// A parallel projection. The picture's plane goes through the middle of the mesh.
struct View {
  Vec3 middle;
  Vec3 right;  // unit vectors
  Vec3 up;
  Vec3 away;
  double step = 1;    // side of a sample, mesh units
  double behind = 0;  // where rays begin
  int columns = width * samples_per_side;
  int rows = 0;

  explicit View(const Mesh& mesh) {
    const BoundingBox box = bounding_box(mesh.positions);
    const Vec3 extent = box.extent();
    std::array<int, 3> axis = {0, 1, 2};
    std::stable_sort(axis.begin(), axis.end(), [&](int a, int b) { return extent[a] < extent[b]; });
    const Vec3 towards =
        normalized(Vec3::Unit(axis[0]) + 0.45 * Vec3::Unit(axis[2]) + 0.3 * Vec3::Unit(axis[1]));
    middle = box.middle();
    away = -towards;
    right = normalized(cross(Vec3::Unit(axis[1]), towards));
    up = cross(towards, right);
    fit(mesh);
  }

  // Exactly around the mesh, as seen.
  void fit(const Mesh& mesh) {
    std::vector<Vec3> seen;
    seen.reserve(mesh.vertex_count());
    for (const Vec3& p : mesh.positions) {
      seen.emplace_back(dot(p - middle, right), dot(p - middle, up), dot(p - middle, away));
    }
    const BoundingBox box = bounding_box(seen);
    const Vec3 extent = box.extent();
    middle += box.middle().x() * right + box.middle().y() * up;
    const double across = std::max({extent.x(), 0.5 * extent.y(), 1e-3 * extent.z()}) * margin;
    if (across > 0) step = across / columns;
    const int pixel_rows =
        static_cast<int>(std::ceil(extent.y() * margin / step)) / samples_per_side;
    rows = (pixel_rows + 1) * samples_per_side;
    behind = extent.z() + 1000 * step;
  }

  [[nodiscard]] Vec3 origin(int column, int row) const {
    return middle + (column + 0.5 - columns / 2.0) * step * right +
           (rows / 2.0 - row - 0.5) * step * up - behind * away;
  }
};

struct Sample {
  std::uint32_t input_id = no_id;  // none where the ray misses the mesh
  bool is_dot = false;
  float light = 0;
};

class Painter {
 public:
  explicit Painter(const RunRecord& run)
      : run_(run),
        frame_(run.input.mesh.positions),
        mesh_(frame_(run.input.mesh)),
        view_(mesh_),
        caster_(mesh_) {
    const double region_area = run.facts.area / static_cast<double>(run.regions.size());
    dot_radius_ = 0.13 * std::sqrt(region_area / std::numbers::pi) * frame_.scale;
    for (const RegionSummary& region : run.regions) {
      seed_position_.push_back(frame_(run.mesh_graph.position[region.seed]));
    }
  }

  [[nodiscard]] int height() const { return view_.rows / samples_per_side; }

  // Four bytes a pixel: red, green, blue, opacity.
  std::vector<std::uint8_t> paint() {
    samples_.resize(static_cast<std::size_t>(view_.columns) * static_cast<std::size_t>(view_.rows));
    for (int row = 0; row < view_.rows; ++row) {
      for (int column = 0; column < view_.columns; ++column) at(column, row) = look(column, row);
    }
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width; ++x) {
        for (const std::uint8_t channel : pixel(x, y)) pixels.push_back(channel);
      }
    }
    return pixels;
  }

 private:
  Sample& at(int column, int row) {
    return samples_[static_cast<std::size_t>(row) * static_cast<std::size_t>(view_.columns) +
                    static_cast<std::size_t>(column)];
  }

  [[nodiscard]] Sample look(int column, int row) const {
    const auto hit = caster_.cast(view_.origin(column, row), view_.away);
    if (!hit) return {};
    const Triangle& t = mesh_.triangles[hit->triangle];
    const std::array<double, 3> weight = {1 - hit->u - hit->v, hit->u, hit->v};
    Vec3 point(0, 0, 0);
    for (std::size_t c = 0; c < 3; ++c) point += weight[c] * mesh_.positions[t[c]];
    const std::uint32_t id = shown_id(*hit, weight);
    const std::int32_t region = run_.labels[id].region;
    const bool is_dot =
        region >= 0 && norm(point - seed_position_[static_cast<std::size_t>(region)]) < dot_radius_;
    return {id, is_dot, light_on(t)};
  }

  // Of the triangle, where triangles have labels; else of the nearest corner.
  [[nodiscard]] std::uint32_t shown_id(const RayHit& hit,
                                       const std::array<double, 3>& weight) const {
    if (has_triangles(run_.mesh_graph.kind)) {
      return static_cast<std::uint32_t>(run_.mesh_graph.first_triangle_id + hit.triangle);
    }
    const auto nearest = std::max_element(weight.begin(), weight.end()) - weight.begin();
    return mesh_.triangles[hit.triangle][static_cast<std::size_t>(nearest)];
  }

  // From the eye and from above; both sides of the surface alike.
  [[nodiscard]] float light_on(const Triangle& t) const {
    const Vec3& a = mesh_.positions[t[0]];
    Vec3 normal = normalized(cross(mesh_.positions[t[1]] - a, mesh_.positions[t[2]] - a));
    if (dot(normal, view_.away) > 0) normal = -normal;
    const double eye = -dot(normal, view_.away);
    const double above = std::max(0.0, dot(normal, view_.up));
    return static_cast<float>(std::min(1.0, 0.35 + 0.55 * eye + 0.25 * above));
  }

  [[nodiscard]] bool is_border(int column, int row) {
    const Sample& here = at(column, row);
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}}) {
      if (column + dx >= view_.columns || row + dy >= view_.rows) continue;
      const Sample& beside = at(column + dx, row + dy);
      if (beside.input_id != no_id && label(beside).region != label(here).region) return true;
    }
    return false;
  }

  std::array<std::uint8_t, 4> pixel(int x, int y) {
    std::array<double, 3> sum = {0, 0, 0};
    int hits = 0;
    for (int j = 0; j < samples_per_side; ++j) {
      for (int i = 0; i < samples_per_side; ++i) {
        const int column = x * samples_per_side + i;
        const int row = y * samples_per_side + j;
        const Sample& sample = at(column, row);
        if (sample.input_id == no_id) continue;
        ++hits;
        const bool is_dark = sample.is_dot || is_border(column, row);
        const double light = is_dark ? 0.2 * sample.light : sample.light;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += light * label(sample).colour[c];
      }
    }
    std::array<std::uint8_t, 4> result = {0, 0, 0, 0};
    for (std::size_t c = 0; c < 3 && hits > 0; ++c) {
      result[c] = static_cast<std::uint8_t>(sum[c] / hits);
    }
    result[3] = static_cast<std::uint8_t>(255 * hits / (samples_per_side * samples_per_side));
    return result;
  }

  [[nodiscard]] const Label& label(const Sample& sample) const {
    return run_.labels[sample.input_id];
  }

  const RunRecord& run_;
  UnitFrame frame_;
  Mesh mesh_;
  View view_;
  RayCaster caster_;
  double dot_radius_;
  std::vector<Vec3> seed_position_;  // per region
  std::vector<Sample> samples_;      // row by row
};

}  // namespace

void write_picture(const std::filesystem::path& path, const RunRecord& run) {
  Painter painter(run);
  const std::vector<std::uint8_t> pixels = painter.paint();
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.format = PNG_FORMAT_RGBA;
  image.width = width;
  image.height = static_cast<png_uint_32>(painter.height());
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0) {
    throw IoError(path.string() + ": cannot make the picture: " + std::string(image.message));
  }
  FileWriter out(path);
  out.text({bytes.data(), size});
  out.commit();
}

}  // namespace geolloyd
