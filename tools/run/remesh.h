#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "core/mesh/mesh_quality.h"
#include "core/surface/cells/surface_engine.h"
#include "geolloyd/evaluation.h"
#include "geolloyd/remesh.h"
#include "parallel/threads/scheduler.h"
#include "tools/cli/remesh_arguments.h"
#include "tools/run/edge_lengths.h"
#include "tools/run/input.h"
#include "tools/system/progress.h"

namespace geolloyd {

/// Engines of this kind. `scheduler` must live on.
MakeSurfaceEngine make_surface_engines(EngineKind kind, Scheduler& scheduler);

/// Reads the mesh, repairs it if that is wanted, and finds its edges. Throws InvalidInput where it
/// has no area.
LoadedInput load_surface(const std::filesystem::path& file, Scheduler& scheduler,
                         ProgressLine& progress, const ReadOptions& options = {},
                         const RepairArguments& repair = {});

/// Read the files that are named, and find the labels. Throw InvalidInput where one does not fit
/// the mesh.
SizingOptions read_sizing(const SizingArguments& arguments, const LoadedInput& loaded);
FeatureOptions read_features(const FeatureArguments& arguments, const LoadedInput& loaded);

/// About how many vertices such a remesh has; above 0.
std::size_t about_how_many(const LoadedInput& loaded, const RemeshOptions& options,
                           Scheduler& scheduler);

/// A surface remesh, and how long its parts took.
struct TimedRemesh {
  Remesh remesh;
  struct Seconds {
    double prepare = 0;   ///< until sites began to move
    double move = 0;      ///< sites
    double assemble = 0;  ///< the mesh, once they had stopped
  } seconds;
};

/// With the options' progress replaced. Shows progress. An interrupt (interrupt.h) ends the moving
/// of sites.
TimedRemesh time_remesh(const LoadedInput& loaded, RemeshOptions options,
                        const MakeSurfaceEngine& make_engine, Scheduler& scheduler,
                        ProgressLine& progress);

/// The same. `loaded` gives most of its edges back: no further remesh is made from it.
TimedRemesh time_last_remesh(LoadedInput& loaded, RemeshOptions options,
                             const MakeSurfaceEngine& make_engine, Scheduler& scheduler,
                             ProgressLine& progress);

/// What a remesh is judged by.
struct RemeshFigures {
  MeshQuality quality;
  std::optional<MeshQuality> in_metric;           ///< of the field, if there is one
  std::optional<EdgeLengthRatios> length_ratios;  ///< over what was asked for at the ends, in the
                                                  ///< mean; where lengths vary
  std::size_t samples = 0;                        ///< of the input
  std::optional<DistanceFigures> distance;  ///< from the input to the remesh, if that is a surface
  std::optional<double> volume_error;       ///< share of the input's volume; if both are closed
};

/// Takes some tenths of a second, however large the input is.
RemeshFigures judge_remesh(const LoadedInput& loaded, const Remesh& remesh,
                           std::span<const TangentSpace> field, Scheduler& scheduler);

}  // namespace geolloyd
