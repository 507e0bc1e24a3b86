#include "core/surface/reference_surface_engine.h"

#include <utility>

#include "core/surface/cell_pieces.h"
#include "core/surface/nearest_label.h"

namespace geolloyd {
namespace {

class ReferenceSurfaceEngine final : public SurfaceEngine {
 public:
  explicit ReferenceSurfaceEngine(const FineMesh& mesh) : mesh_(mesh), unit_(mesh.whole_mass) {}

  void assign(std::vector<RegionId> labels, std::span<const std::uint8_t> is_fixed) override {
    labels_ = std::move(labels);
    is_fixed_.assign(is_fixed.begin(), is_fixed.end());
  }

  std::span<const Moments> evaluate(std::span<const Vec3> sites) override {
    while (sweep(sites)) {
    }
    cells_.assign(sites.size(), {});
    for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
      const RegionId main = main_site(mesh_, t, labels_);
      if (main == no_id) continue;
      cells_[main] += moments_of(mesh_, unit_, t);
      for_each_piece(mesh_, unit_, t, labels_, sites, [&](RegionId r, const Moments& piece) {
        cells_[r] += piece;
        cells_[main] -= piece;
      });
    }
    return cells_;
  }

  [[nodiscard]] const std::vector<RegionId>& labels() const override { return labels_; }
  [[nodiscard]] std::span<const Moments> cells() const override { return cells_; }

 private:
  bool sweep(std::span<const Vec3> sites) {
    std::vector<RegionId> next = labels_;
    for (VertexId v = 0; v < mesh_.vertex_count(); ++v) {
      if (is_fixed_[v] == 0) next[v] = nearest_label(mesh_, labels_, sites, v).label;
    }
    std::swap(labels_, next);
    return labels_ != next;
  }

  const FineMesh& mesh_;
  MomentUnit unit_;
  std::vector<RegionId> labels_;
  std::vector<std::uint8_t> is_fixed_;
  std::vector<Moments> cells_;
};

}  // namespace

std::unique_ptr<SurfaceEngine> make_reference_surface_engine(const FineMesh& mesh) {
  return std::make_unique<ReferenceSurfaceEngine>(mesh);
}

}  // namespace geolloyd
