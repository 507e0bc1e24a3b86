#include "core/course/run_plan.h"

namespace geolloyd {

MeshGraphOptions graph_options(const GraphPlan& plan, const Mesh& mesh, const MeshEdges& edges,
                               Executor& executor) {
  return {plan.kind, plan.norm, find_field(plan, mesh, edges, executor), plan.averaging};
}

GreedyMode greedy_mode(std::optional<GreedyMode> asked, bool are_given, SeedInit init) {
  return asked.value_or(are_given ? GreedyMode::extended : suggested_greedy_mode(init));
}

}  // namespace geolloyd
