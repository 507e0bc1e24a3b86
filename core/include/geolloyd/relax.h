#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geolloyd/choices.h"
#include "geolloyd/mesh.h"
#include "geolloyd/runtime.h"
#include "geolloyd/types.h"

namespace geolloyd {

struct RelaxOptions;
struct Tessellation;

/// Moves seeds to the centroids of their regions until none moves (Rapetta's thesis; the definition
/// is in core/lloyd/relaxation.h). Regions are numbered as their seeds are given or chosen. Lengths
/// are in mesh units. Throws InvalidInput with a sentence where the mesh or an option is not
/// usable: no seeds, repeated or unknown ones, fewer seeds than components, more than nodes, a
/// field of another length or with values that are not finite, averaging that the norm cannot have.
Tessellation relax(const Mesh& mesh, const RelaxOptions& options, Runtime& runtime = all_threads());

/// The regions of the first seeds as they are: the graph Voronoi diagram.
Tessellation voronoi(const Mesh& mesh, RelaxOptions options, Runtime& runtime = all_threads());

/// The first seeds, with which relax() begins.
std::vector<InputId> first_seeds(const Mesh& mesh, const RelaxOptions& options,
                                 Runtime& runtime = all_threads());

/// Per input id, along the graph of these options to the nearest of `options.first_seeds`, mesh
/// units. Infinite in components without one, and for vertices of no triangle. Throws InvalidInput
/// as relax() does, but where a component has no seed.
std::vector<double> distances(const Mesh& mesh, const RelaxOptions& options,
                              Runtime& runtime = all_threads());

struct RelaxOptions {
  std::size_t seed_count = 0;  ///< number of regions, at least 1; unless first seeds are given
  std::vector<InputId> first_seeds;  ///< different; each component of the mesh has one
  /// First seeds instead, such as those of another mesh: for each the nearest id of the graph, of
  /// several the smallest. One whose nearest id is that of an earlier one is left out.
  std::vector<Vec3> first_positions;
  SeedInit init = SeedInit::automatic;
  std::uint64_t random_seed = 1;

  GraphKind graph = GraphKind::vertex;
  Norm norm = Norm::geodesic;
  std::vector<TangentSpace> field;     ///< one per vertex, or none: an isotropic metric;
                                       ///< directions may have any length
  std::optional<Averaging> averaging;  ///< of the field; none: suggested_averaging(norm)

  std::optional<GreedyMode>
      greedy;  ///< none: the mode suggested for `init` (suggested_greedy_mode)
  std::uint32_t max_greedy_steps = no_id;
  std::uint32_t max_macrosteps = no_id;
  std::uint32_t improvement_rounds = 0;  ///< leave the local minimum for a lower one
  ProgressCallback progress;
};

/// One greedy step, one macrostep or one round of improvement.
struct TessellationStep {
  Phase phase = Phase::greedy;
  double energy = 0;              ///< at its start, mesh units
  std::uint32_t seeds_moved = 0;  ///< that end it elsewhere than they began it
  std::uint64_t node_visits = 0;  ///< nodes settled by its searches
  double seconds = 0;
};

/// One region, in mesh units.
struct Region {
  InputId seed = no_id;
  std::size_t nodes = 0;
  double area = 0;    ///< of the mixed graph, twice the surface's
  double energy = 0;  ///< sum of mass * distance^2
};

/// Regions of a mesh, each with its seed. Everything speaks input ids (types.h).
struct Tessellation {
  std::vector<Region> regions;
  std::vector<RegionId> region;  ///< per input id; no_id: a vertex of no triangle, or no seed near
  std::vector<double> distance;  ///< per input id: along the graph to the seed, mesh units; or inf
  std::vector<InputId> parent;   ///< per input id: the next one on the way to the seed, or no_id
  double initial_energy = 0;     ///< of the first seeds
  double energy = 0;             ///< never more than initial_energy
  StopReason stop_reason = StopReason::converged;
  std::uint64_t fingerprint = 0;  ///< of the whole course; the same on every machine
  std::vector<TessellationStep> trace;

  std::shared_ptr<const struct TessellatedGraph> internals;  ///< what dual() goes on from
};

}  // namespace geolloyd
