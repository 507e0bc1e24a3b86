#include "core/surface/fit/largest_distances.h"

#include <algorithm>

#include "core/surface/fit/sample_projection.h"

namespace geolloyd {
namespace {

// Tips and rims are farthest, and only vertices are on them.
class VertexSamples final : public SampleSet {
 public:
  VertexSamples(const FineMesh& fine, std::span<const RegionId> labels,
                std::span<const VertexId> always, std::size_t most)
      : fine_(fine),
        labels_(labels),
        always_(always),
        stride_(std::max<std::size_t>(1, fine.vertex_count() / most)),
        every_so_many_((fine.vertex_count() + stride_ - 1) / stride_) {}

  [[nodiscard]] std::size_t size() const override { return every_so_many_ + always_.size(); }
  [[nodiscard]] Sample operator[](std::size_t i) const override {
    const auto v =
        i < every_so_many_ ? static_cast<VertexId>(i * stride_) : always_[i - every_so_many_];
    return {fine_.positions[v], 1, labels_[v]};
  }

 private:
  const FineMesh& fine_;
  std::span<const RegionId> labels_;
  std::span<const VertexId> always_;
  std::size_t stride_;
  std::size_t every_so_many_;
};

}  // namespace

std::vector<double> largest_distances(const SurfaceInput& input, std::span<const RegionId> labels,
                                      std::span<const VertexId> always, const Mesh& remesh,
                                      Executor& executor) {
  constexpr std::size_t per_vertex = 64;
  const MovingRemesh in_unit_frame(input.frame, remesh, executor);
  const VertexSamples samples(input.fine, labels, always, per_vertex * remesh.vertex_count());
  SampleProjection projection(samples, in_unit_frame, executor);
  projection.project();
  return projection.largest_at_vertices();
}

}  // namespace geolloyd
