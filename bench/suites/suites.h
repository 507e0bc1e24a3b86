#pragma once

#include "bench/support/bench_mesh.h"

namespace geolloyd {

// Each registers the benchmarks of some stages on one mesh, in the order of a run. Results are
// verified against what inputs.h holds before they are timed.

/// Reading files: load/FORMAT.
void add_load_benchmarks(const BenchMesh& mesh);
/// edges, check, graph/KIND.
void add_graph_benchmarks(const BenchMesh& mesh);
/// First seeds: seeds/INIT.
void add_seeds_benchmarks(const BenchMesh& mesh);
/// Keys alone: search/heap, search/delta. All that a free partition is made of: partition/FRONTIER,
/// and again after all seeds have moved by an arc: repair/FRONTIER.
void add_partition_benchmarks(const BenchMesh& mesh);
/// What is found region by region: sums, scoring, macrostep.
void add_region_benchmarks(const BenchMesh& mesh);
/// relaxation/ENGINE.
void add_relaxation_benchmarks(const BenchMesh& mesh);
/// Surface remeshes: surface/STAGE, and all of it, surface/remesh.
void add_surface_benchmarks(const BenchMesh& mesh);

}  // namespace geolloyd
