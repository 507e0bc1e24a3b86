#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/course/hooks.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/remesh.h"
#include "geolloyd/runtime.h"

namespace geolloyd {

/// All that a remesh is made from. What is referred to must live on.
struct RemeshCourse {
  const Mesh& mesh;  ///< valid
  const MeshEdges& edges;
  RemeshOptions options;  ///< for this mesh
  Runtime& runtime;
  CourseHooks hooks = {};
  /// What the client's whole run holds for a remesh with so many vertices: for hooks.budget.
  std::function<std::uint64_t(std::size_t vertices, const RemeshOptions& options)> bytes = {};
  /// For the last remesh: gives back what nothing but edges.duplicates needs (surface/result).
  std::function<void()> release_edges = {};
};

/// A remesh, and how long its parts took.
struct TimedRemesh {
  Remesh remesh;
  struct Seconds {
    double prepare = 0;   ///< until sites began to move
    double move = 0;      ///< sites; then the fit and the glides
    double assemble = 0;  ///< the mesh, once they had stopped
  } seconds;
};

/// About how many vertices the remesh has; above 0. Throws InvalidInput where there are too many.
std::size_t expected_vertices(const RemeshCourse& course);

/// Asks for the budget, then makes the remesh. Where hooks.keep_going or the options' progress ends
/// the moving of sites, it is made from where they are.
TimedRemesh run(RemeshCourse course);

}  // namespace geolloyd
