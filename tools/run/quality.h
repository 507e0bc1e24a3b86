#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "core/mesh/mesh_quality.h"
#include "core/mesh/mesh_topology.h"
#include "parallel/threads/scheduler.h"
#include "tools/evaluation/surface_distance.h"
#include "tools/run/input.h"
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
  std::optional<Likeness> likeness;
};

/// `original` empty: the remesh alone. Throws Error.
QualityRecord judge(const std::filesystem::path& remesh, const std::filesystem::path& original,
                    std::size_t samples, Scheduler& scheduler, ProgressLine& progress);

}  // namespace geolloyd
