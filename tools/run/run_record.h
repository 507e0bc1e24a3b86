#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/formats/mesh_io.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/relaxation.h"
#include "core/mesh/mesh_check.h"
#include "core/remesh/tessellation.h"
#include "tools/cli/relax_arguments.h"
#include "tools/evaluation/ground_truth.h"
#include "tools/evaluation/hexagonal_energy.h"
#include "tools/run/remesh.h"

namespace geolloyd {

struct StageSeconds {
  double load = 0;  ///< reading and checking the mesh
  double graph = 0;
  double seeds = 0;
  double relax = 0;
  double remesh = 0;
  double ground_truth = 0;
  double write = 0;
  double total = 0;
};

/// What was done before a run that resumed it.
struct EarlierPart {
  std::size_t steps = 0;
  double seconds = 0;  ///< of the relaxation
};

/// All there is to tell of one run of `relax`.
struct RunRecord {
  RelaxArguments arguments;
  LoadedMesh input;
  MeshFacts facts;
  MeshGraph mesh_graph;
  std::size_t components = 0;  ///< of the graph
  Relaxation relaxation;
  std::size_t threads = 0;  ///< of the relaxation
  std::optional<EarlierPart> resumed;
  std::vector<RegionSummary> regions;
  std::vector<Label> labels;  ///< per input id
  Remesh remesh;
  std::optional<GroundTruth> ground_truth;
  bool interrupted = false;  ///< before the results were written: they may be less than otherwise
  StageSeconds seconds;
  std::uint64_t memory_estimate = 0;    ///< bytes, before the graph was built
  std::uint64_t peak_memory_bytes = 0;  ///< until the results were written
};

/// That of the hexagonal tiling with as much area and as many regions.
inline double hexagonal_energy(const RunRecord& run) {
  double mass = 0;
  for (const RegionSummary& region : run.regions) mass += region.area;
  return hexagonal_energy(mass, run.facts.area, run.regions.size());
}

}  // namespace geolloyd
