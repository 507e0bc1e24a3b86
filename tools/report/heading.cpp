#include "tools/report/heading.h"

#include <fmt/format.h>

#include "tools/system/machine.h"
#include "tools/words/facts_text.h"
#include "tools/words/names.h"

namespace geolloyd {

void print_heading(const PreparedInput& start) {
  const Graph& graph = start.mesh_graph.graph;
  fmt::print("{}: {} graph, {}, {}, {}\n", start.input.file.string(),
             name_of(graph_kind_names, start.mesh_graph.kind),
             counted(graph.node_count(), "node", "nodes"),
             counted(graph.arc_count(), "arc", "arcs"),
             counted(start.seeds.size(), "seed", "seeds"));
  if (start.seed_fit) fmt::print("{}", describe(*start.seed_fit, start.input.facts));
  print_machine();
}

void print_machine() {
  const Machine machine = this_machine();
  fmt::print("{}, {} at once, {}\n\n", machine.processor,
             counted(machine.threads, "thread", "threads"), machine.compiler);
}

}  // namespace geolloyd
