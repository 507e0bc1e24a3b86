#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/graph/arc_length.h"
#include "core/graph/mesh_graph.h"
#include "core/lloyd/relaxation.h"
#include "core/seeds/seeds.h"
#include "parallel/engine/parallel_engine.h"
#include "parallel/threads/scheduler.h"
#include "tools/run/remesh.h"

namespace geolloyd {

// The words of the command line and of report.json for each choice. Scripts rely on them.

template <class Choice>
struct Named {
  const char* name;
  Choice value;
};

/// Makes a generated mesh (shapes.h).
using Shape = Mesh (*)(std::size_t triangles, std::uint64_t random_seed);
extern const std::vector<Named<Shape>> shape_names;

extern const std::vector<Named<GraphKind>> graph_kind_names;
extern const std::vector<Named<Norm>> norm_names;
extern const std::vector<Named<GreedyMode>> greedy_mode_names;
/// Those of --greedy: nothing leaves the choice to the program.
extern const std::vector<Named<std::optional<GreedyMode>>> greedy_choice_names;
extern const std::vector<Named<SeedInit>> seed_init_names;
extern const std::vector<Named<StopReason>> stop_reason_names;
extern const std::vector<Named<Frontier>> frontier_names;
extern const std::vector<Named<Backend>> backstop_reason_names;
extern const std::vector<Named<Phase>> phase_names;
extern const std::vector<Named<RemeshVertices>> remesh_vertices_names;
extern const std::vector<Named<double KernelSeconds::*>> kernel_names;

enum class EngineKind { parallel, reference };
extern const std::vector<Named<EngineKind>> engine_names;

template <class Choice>
std::vector<std::string> names_of(const std::vector<Named<Choice>>& choices) {
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const auto& choice : choices) names.emplace_back(choice.name);
  return names;
}

/// `name` must be one of the names.
template <class Choice>
Choice value_of(const std::vector<Named<Choice>>& choices, const std::string& name) {
  auto choice = choices.begin();
  while (choice->name != name) ++choice;
  return choice->value;
}

template <class Choice>
std::string name_of(const std::vector<Named<Choice>>& choices, Choice value) {
  auto choice = choices.begin();
  while (choice->value != value) ++choice;
  return choice->name;
}

}  // namespace geolloyd
