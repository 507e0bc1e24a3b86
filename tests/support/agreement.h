#pragma once

#include "core/lloyd/reference_engine.h"
#include "core/lloyd/relaxation.h"
#include "parallel/engine/parallel_engine.h"
#include "tests/support/same_relaxation.h"

namespace geolloyd {

inline constexpr Backend all_backends[] = {Backend::tbb, Backend::openmp};
inline constexpr Frontier all_frontiers[] = {Frontier::heap, Frontier::delta, Frontier::regions,
                                             Frontier::automatic};

inline Relaxation relax_by_reference(const Graph& graph, const std::vector<NodeId>& seeds,
                                     const RelaxationOptions& options) {
  const auto engine = make_reference_engine(graph);
  return relax(graph, *engine, seeds, options);
}

inline Relaxation relax_in_parallel(Scheduler& scheduler, Frontier frontier, const Graph& graph,
                                    const std::vector<NodeId>& seeds,
                                    const RelaxationOptions& options) {
  const auto engine = make_parallel_engine(scheduler, graph, frontier);
  return relax(graph, *engine, seeds, options);
}

}  // namespace geolloyd
