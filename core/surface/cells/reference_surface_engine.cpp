#include "core/surface/cells/reference_surface_engine.h"

#include <utility>

#include "core/surface/cells/cell_pieces.h"
#include "core/surface/cells/nearest_label.h"

namespace geolloyd {
namespace {

template <class Measure>
class ReferenceSurfaceEngine final : public SurfaceEngine {
 public:
  explicit ReferenceSurfaceEngine(const FineMesh& mesh) : mesh_(mesh), unit_(moment_unit(mesh)) {}

  void assign(std::vector<RegionId> labels, std::span<const std::uint8_t> is_fixed) override {
    labels_ = std::move(labels);
    is_fixed_.assign(is_fixed.begin(), is_fixed.end());
  }

  const Cells& evaluate(std::span<const Vec3> sites) override {
    while (sweep(sites)) {
    }
    std::vector<Sum> sums(sites.size());
    for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
      const RegionId main = main_site(mesh_, t, labels_);
      if (main == no_id) continue;
      sums[main] += moments_of<Measure>(mesh_, unit_, t);
      for_each_piece<Measure>(mesh_, unit_, t, labels_, sites, [&](RegionId r, const Sum& piece) {
        sums[r] += piece;
        sums[main] -= piece;
      });
    }
    cells_.assign(sums);
    return cells_;
  }

  [[nodiscard]] const std::vector<RegionId>& labels() const override { return labels_; }
  [[nodiscard]] const Cells& cells() const override { return cells_; }

 private:
  using Sum = typename Measure::Sum;

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
  Cells cells_;
};

}  // namespace

std::unique_ptr<SurfaceEngine> make_reference_surface_engine(const FineMesh& mesh) {
  if (mesh.metric.empty()) return std::make_unique<ReferenceSurfaceEngine<EvenMeasure>>(mesh);
  return std::make_unique<ReferenceSurfaceEngine<MetricMeasure>>(mesh);
}

}  // namespace geolloyd
