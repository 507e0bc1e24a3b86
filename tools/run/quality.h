#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/course/field_source.h"
#include "core/mesh/mesh_quality.h"
#include "core/mesh/mesh_topology.h"
#include "geolloyd/runtime.h"
#include "tools/evaluation/likeness.h"
#include "tools/evaluation/metric_quality.h"
#include "tools/run/input.h"
#include "tools/system/progress.h"

namespace geolloyd {

/// A mesh that is judged, or that another is judged by.
struct JudgedMesh {
  Input input;
  MeshTopology topology;
};

/// All there is to tell of one run of `quality`; empty without an original, or without a field.
struct QualityRecord {
  JudgedMesh remesh;
  MeshQuality quality;
  std::vector<TrianglePair> self_intersections;  ///< of the remesh
  std::optional<JudgedMesh> original;
  std::optional<Likeness> likeness;
  std::optional<SurfaceDistanceBounds> bounds;  ///< of the distance, first the remesh; if asked for
  std::optional<MetricQuality> in_metric;
};

/// What is judged, and by what.
struct QualityInput {
  std::filesystem::path remesh;
  std::filesystem::path original;  ///< empty: the remesh is judged alone
  FieldSource field;               ///< of the original
  std::size_t samples = 0;         ///< on each of the two
  bool certify = false;            ///< finds bounds of the distance, too
  MeshReading reading = {};        ///< of both
};

/// Throws Error.
QualityRecord judge(const QualityInput& input, Runtime& runtime, ProgressLine& progress);

}  // namespace geolloyd
