#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "core/mesh/mesh_quality.h"
#include "core/mesh/mesh_topology.h"
#include "parallel/threads/scheduler.h"
#include "tools/cli/relax_arguments.h"
#include "tools/evaluation/surface_distance.h"
#include "tools/run/input.h"
#include "tools/run/metric_quality.h"
#include "tools/system/progress.h"

namespace geolloyd {

/// A mesh that is judged, or that another is judged by.
struct JudgedMesh {
  Input input;
  MeshTopology topology;
};

/// A remesh beside the mesh that it stands for.
struct Likeness {
  JudgedMesh original;
  std::size_t samples = 0;   ///< on each of the two
  SurfaceDistance distance;  ///< first the remesh, second the original
  double energy = 0;         ///< of sites at the original's points closest to the remesh's vertices
                             ///< (site_energy.h)
  double hexagonal = 0;      ///< that of the hexagonal tiling with as many regions
};

/// All there is to tell of one run of `quality`.
struct QualityRecord {
  JudgedMesh remesh;
  MeshQuality quality;
  std::optional<MetricQuality> in_metric;
  std::optional<Likeness> likeness;
};

/// What is judged, and by what.
struct QualityInput {
  std::filesystem::path remesh;
  std::filesystem::path original;  ///< empty: the remesh is judged alone
  FieldSource field;               ///< of the original
  std::size_t samples = 0;         ///< on each of the two
};

/// Throws Error.
QualityRecord judge(const QualityInput& input, Scheduler& scheduler, ProgressLine& progress);

}  // namespace geolloyd
