#pragma once

#include <filesystem>
#include <vector>

#include "core/base/executor.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/choices.h"

namespace geolloyd {

/// Where a tangent field comes from.
struct FieldSource {
  std::filesystem::path vfield;  ///< a file, or the word for one of the surface's own; empty: none

  /// A file of that name is ./curvature, or ./cross.
  [[nodiscard]] bool has_curvature_field() const { return vfield == "curvature"; }
  [[nodiscard]] bool has_cross_field() const { return vfield == "cross"; }
  /// Empty where the field is none or the surface's own.
  [[nodiscard]] std::filesystem::path field_file() const {
    return has_curvature_field() || has_cross_field() ? std::filesystem::path() : vfield;
  }

  friend bool operator==(const FieldSource&, const FieldSource&) = default;
};

/// One tangent space per vertex, or none. Throws Error where a file cannot be read, or is of
/// another mesh.
std::vector<TangentSpace> find_field(const FieldSource& source, const Mesh& mesh,
                                     const MeshEdges& edges, Executor& executor);

}  // namespace geolloyd
