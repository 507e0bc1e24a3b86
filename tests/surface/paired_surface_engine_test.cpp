#include "core/surface/cells/paired_surface_engine.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/course/paired_surfaces.h"
#include "core/lloyd/paired_engine.h"
#include "core/shapes/shapes.h"
#include "core/surface/cells/reference_surface_engine.h"
#include "core/surface/result/remesh.h"

namespace geolloyd {
namespace {

// An engine that goes wrong in one place, in its n-th evaluation.
class FaultySurfaceEngine final : public SurfaceEngine {
 public:
  enum class Fault { label, area, second, metric, cells };

  FaultySurfaceEngine(const FineMesh& mesh, Fault fault, int after)
      : true_(make_reference_surface_engine(mesh)), fault_(fault), left_(after) {}

  void assign(std::vector<RegionId> labels, std::span<const std::uint8_t> is_fixed) override {
    true_->assign(std::move(labels), is_fixed);
  }
  const Cells& evaluate(std::span<const Vec3> sites) override {
    cells_ = true_->evaluate(sites);
    labels_ = true_->labels();
    if (--left_ > 0) return cells_;
    if (fault_ == Fault::label) labels_[7] = no_id;
    if (fault_ == Fault::area) ++cells_.moments[1].area;
    if (fault_ == Fault::second) --cells_.moments[1].second;
    if (fault_ == Fault::metric) ++cells_.metric[1].parts[4];
    if (fault_ == Fault::cells) cells_.moments.pop_back();
    return cells_;
  }
  [[nodiscard]] const std::vector<RegionId>& labels() const override { return labels_; }
  [[nodiscard]] const Cells& cells() const override { return true_->cells(); }

 private:
  std::unique_ptr<SurfaceEngine> true_;
  Fault fault_;
  int left_;
  std::vector<RegionId> labels_;
  Cells cells_;
};

class FaultyRuntime final : public Runtime {
 public:
  FaultyRuntime(FaultySurfaceEngine::Fault fault, int after) : fault_(fault), after_(after) {}

  Executor& executor() override { return sequential(); }
  std::unique_ptr<Engine> make_engine(const Graph&) override { return nullptr; }
  std::unique_ptr<GrowingSearch> make_growing_search(const Graph&) override { return nullptr; }
  std::unique_ptr<SurfaceEngine> make_surface_engine(const FineMesh& mesh) override {
    return std::make_unique<FaultySurfaceEngine>(mesh, fault_, after_);
  }

 private:
  FaultySurfaceEngine::Fault fault_;
  int after_;
};

Remesh remesh_with(Runtime& runtime, bool has_field = false) {
  const Mesh mesh = torus(500, 1);
  RemeshOptions options;
  options.vertex_count = 40;
  if (has_field) {
    options.field.assign(mesh.vertex_count(), {Vec3::UnitX(), Vec3::UnitY(), 1, 1});
  }
  return make_remesh(mesh, find_edges(mesh), options, runtime);
}

std::string complaint(FaultySurfaceEngine::Fault fault, int after) {
  SurfaceComparison comparison;
  FaultyRuntime faulty(fault, after);
  PairedSurfaces pairs(reference_runtime(), faulty, comparison);
  try {
    remesh_with(pairs, fault == FaultySurfaceEngine::Fault::metric);
  } catch (const Disagreement& difference) {
    return difference.what();
  }
  return "";
}

TEST(PairedSurfaceEngine, NamesTheFirstEvaluationPlaceAndValueThatDiffer) {
  using Fault = FaultySurfaceEngine::Fault;
  const std::string label = complaint(Fault::label, 3);
  EXPECT_EQ(label.substr(0, 57), "in evaluation 3, on mesh 1: label of vertex 7: expected s");
  EXPECT_TRUE(label.ends_with(", got none")) << label;
  const std::string moments =
      "in evaluation 1, on mesh 1: moments of the cell of site 1: expected ";
  EXPECT_TRUE(complaint(Fault::area, 1).starts_with(moments));
  EXPECT_TRUE(complaint(Fault::second, 1).starts_with(moments));
  EXPECT_TRUE(complaint(Fault::metric, 1)
                  .starts_with("in evaluation 1, on mesh 1: metric of the cell of site 1: "));
  EXPECT_TRUE(
      complaint(Fault::cells, 2).starts_with("in evaluation 2, on mesh 1: number of cells: "));
}

TEST(PairedSurfaceEngine, IsSilentWhereBothAgree) {
  SurfaceComparison comparison;
  PairedSurfaces pairs(reference_runtime(), reference_runtime(), comparison);
  const Remesh paired = remesh_with(pairs);
  const Remesh alone = remesh_with(reference_runtime());
  EXPECT_EQ(paired.fingerprint, alone.fingerprint);
  EXPECT_EQ(paired.mesh.positions, alone.mesh.positions);
  EXPECT_GT(comparison.evaluations, comparison.meshes);
  EXPECT_GT(comparison.labels, comparison.cells);
  EXPECT_GT(comparison.expected_seconds, 0);
  EXPECT_GT(comparison.tested_seconds, 0);
}

}  // namespace
}  // namespace geolloyd
