#include "core/surface/cells/paired_surface_engine.h"

#include <utility>

#include "core/base/disagreement.h"
#include "core/base/stopwatch.h"

namespace geolloyd {
namespace {

std::string name_of_label(RegionId label) {
  return label == no_id ? "none" : "site " + std::to_string(label);
}

std::string text_of(const Moments& m) {
  return "area " + std::to_string(m.area) + ", first " + std::to_string(m.first[0]) + " " +
         std::to_string(m.first[1]) + " " + std::to_string(m.first[2]) + ", second " +
         std::to_string(m.second);
}

std::string text_of(const MetricIntegral& m) {
  std::string text = "parts";
  for (const std::int64_t part : m.parts) text.append(" ").append(std::to_string(part));
  return text;
}

}  // namespace

PairedSurfaceEngine::PairedSurfaceEngine(std::unique_ptr<SurfaceEngine> expected,
                                         std::unique_ptr<SurfaceEngine> tested,
                                         SurfaceComparison& comparison)
    : expected_(std::move(expected)),
      tested_(std::move(tested)),
      comparison_(comparison),
      mesh_(++comparison.meshes) {}

void PairedSurfaceEngine::assign(std::vector<RegionId> labels,
                                 std::span<const std::uint8_t> is_fixed) {
  {
    const Timed timed(comparison_.expected_seconds);
    expected_->assign(labels, is_fixed);
  }
  const Timed timed(comparison_.tested_seconds);
  tested_->assign(std::move(labels), is_fixed);
}

const Cells& PairedSurfaceEngine::evaluate(std::span<const Vec3> sites) {
  const auto timed_evaluate = [&](SurfaceEngine& engine, double& seconds) -> const Cells& {
    const Timed timed(seconds);
    return engine.evaluate(sites);
  };
  const Cells& expected = timed_evaluate(*expected_, comparison_.expected_seconds);
  const Cells& tested = timed_evaluate(*tested_, comparison_.tested_seconds);
  ++comparison_.evaluations;
  compare_labels();
  compare_moments(expected, tested);
  comparison_.labels += expected_->labels().size();
  comparison_.cells += expected.size();
  return expected;
}

void PairedSurfaceEngine::differ(const std::string& what, const std::string& expected,
                                 const std::string& tested) const {
  throw Disagreement("in evaluation " + std::to_string(comparison_.evaluations) + ", on mesh " +
                         std::to_string(mesh_) + ": " + what + ": expected " + expected + ", got " +
                         tested,
                     no_id);
}

void PairedSurfaceEngine::compare_labels() const {
  const std::vector<RegionId>& expected = expected_->labels();
  const std::vector<RegionId>& tested = tested_->labels();
  if (expected == tested) return;
  if (expected.size() != tested.size()) {
    differ("number of labels", std::to_string(expected.size()), std::to_string(tested.size()));
  }
  std::size_t v = 0;
  while (expected[v] == tested[v]) ++v;
  differ("label of vertex " + std::to_string(v), name_of_label(expected[v]),
         name_of_label(tested[v]));
}

void PairedSurfaceEngine::compare_moments(const Cells& expected, const Cells& tested) const {
  if (expected.size() != tested.size()) {
    differ("number of cells", std::to_string(expected.size()), std::to_string(tested.size()));
  }
  for (std::size_t r = 0; r < expected.size(); ++r) {
    if (expected.moments[r] == tested.moments[r]) continue;
    differ("moments of the cell of site " + std::to_string(r), text_of(expected.moments[r]),
           text_of(tested.moments[r]));
  }
  for (std::size_t r = 0; r < expected.metric.size(); ++r) {
    if (expected.metric[r] == tested.metric[r]) continue;
    differ("metric of the cell of site " + std::to_string(r), text_of(expected.metric[r]),
           text_of(tested.metric[r]));
  }
}

}  // namespace geolloyd
