#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bench/zoo/part.h"
#include "geolloyd/remesh.h"

namespace geolloyd::zoo {

/// How a remesh compares with what is true of its part.
struct Verdict {
  std::size_t wanted = 0;
  std::size_t vertices = 0;
  bool is_manifold = false;
  bool has_topology = false;  ///< parts and their Euler characteristics
  std::size_t parts = 0;
  std::size_t flat = 0;          ///< triangles without area
  std::size_t crossings = 0;     ///< pairs of triangles that go through each other
  double smallest_angle = 0;     ///< degrees
  double wanted_angle = 0;       ///< 20 degrees, or three quarters of what the part forces
  double valence_6 = 0;          ///< share of the inner vertices
  double valence_6_between = 0;  ///< and of those on no feature
  double volume_error = 0;       ///< as a share
  double hausdorff = 0;          ///< share of the diagonal, of both ways the larger
  std::optional<double> kept;    ///< share of sharp edges: see KeptEdges
  std::optional<std::size_t> least_on_rim;  ///< vertices: see KeptEdges
  std::size_t features = 0;                 ///< edges of the remesh
  std::vector<RemeshWarning> warnings;
  double seconds = 0;  ///< of all threads

  /// A manifold of the true topology, all of whose triangles have an area.
  [[nodiscard]] bool is_sound() const;
  /// All figures but valences are as they should be.
  [[nodiscard]] bool is_good() const;
  /// Nobody should use it without looking.
  [[nodiscard]] bool is_bad() const;
};

/// As it is after reading.
Mesh welded(const Part& part);
/// Of the box around it.
double diagonal_of(const Mesh& mesh);
/// Remeshes a part with the usual options and judges what comes out.
Verdict judge(const Part& part, std::size_t vertices);

}  // namespace geolloyd::zoo
