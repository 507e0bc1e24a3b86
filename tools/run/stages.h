#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "parallel/threads/scheduler.h"
#include "tools/run/run_record.h"
#include "tools/system/progress.h"

namespace geolloyd {

/// The threads that the command line asks for.
Scheduler make_scheduler(const RelaxArguments& a);

/// The remesh that the command line asks for.
RemeshOptions remesh_options(const RelaxArguments& a);

/// Reads a mesh. Throws InvalidInput where there is not enough memory (memory_limit.h): judged by
/// the size of the file, then for what comes next in every command, finding its edges.
LoadedMesh read_within_limits(const std::filesystem::path& path);

/// Reads and checks the mesh.
MeshEdges load_mesh(RunRecord& run, Scheduler& scheduler);

/// Of the kind that the arguments say. Throws InvalidInput where the whole run, with so many seeds
/// at first, needs more memory than there is.
void build_graph(RunRecord& run, Scheduler& scheduler, const MeshEdges& edges, std::size_t seeds);

/// All that comes before the relaxation: these two, then chooses or reads the first seeds and
/// returns them. Fills in what `run` has to say of these stages.
std::vector<NodeId> prepare(RunRecord& run, Scheduler& scheduler, ProgressLine& progress);

/// Of the relaxation's seeds and partition.
void find_ground_truth(RunRecord& run, Scheduler& scheduler, ProgressLine& progress);

/// The partition of run.relaxation.seeds as they are. Returns the engine that found it.
std::unique_ptr<Engine> partition_seeds(RunRecord& run, Scheduler& scheduler);

}  // namespace geolloyd
