#include "tools/view/page_contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "core/mesh/mesh_edges.h"
#include "tools/render/surface_colours.h"
#include "tools/report/report_parts.h"
#include "tools/view/layers.h"
#include "tools/words/facts_text.h"
#include "tools/words/names.h"

namespace geolloyd {
namespace {

void add_fact(Bundle& bundle, const char* name, const std::string& text) {
  bundle.info["facts"].push_back(Json::array({name, text}));
}

void add_field_of(const FieldSource& field, const Mesh& mesh, Bundle& bundle, Executor& executor) {
  if (field.vfield.empty()) return;
  add_field(bundle, find_field(field, mesh, find_edges(mesh, executor), executor));
}

// Steps are numbered within their phase, from 1.
std::vector<std::string> labels_of(std::span<const Step> steps) {
  std::vector<std::string> labels;
  labels.reserve(steps.size());
  std::size_t number = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    number = i > 0 && steps[i].phase == steps[i - 1].phase ? number + 1 : 1;
    labels.push_back(fmt::format("{} step {}", name_of(phase_names, steps[i].phase), number));
  }
  return labels;
}

// The start of each step, and the result, whose arrays are there.
void add_frames(const PreparedInput& start, const Relaxation& relaxation,
                std::span<const std::vector<NodeId>> course, Bundle& bundle, Runtime& runtime) {
  const std::span<const Step> steps = std::span(relaxation.steps).last(course.size());
  const std::vector<std::string> labels = labels_of(relaxation.steps);
  const std::size_t stride = (course.size() + most_frames - 1) / most_frames;
  for (std::size_t i = 0; i < course.size(); i += stride) {
    const EnginePartition found = partition_seeds(start.mesh_graph.graph, course[i], runtime);
    add_frame(bundle, labels[labels.size() - course.size() + i], steps[i].energy, start.mesh_graph,
              found.partition, course[i]);
  }
  bundle.frames.push_back({{"label", "result"},
                           {"energy", relaxation.energy},
                           {"seeds", "seeds"},
                           {"region", "region"}});
  if (stride > 1) {
    bundle.info["notes"].push_back(
        fmt::format("The timeline shows one of {} steps of {}.", stride, grouped(course.size())));
  }
}

}  // namespace

Bundle bundle_of(const Input& input) {
  Bundle bundle;
  bundle.title = input.file.filename().string();
  bundle.placement = placement_of(input.mesh());
  add_mesh(bundle, input.mesh(), colours_of(input.loaded.properties));
  add_fact(bundle, "vertices", grouped(input.mesh().vertex_count()));
  add_fact(bundle, "triangles", grouped(input.mesh().triangle_count()));
  return bundle;
}

Bundle relax_contents(const FieldSource& field, const PreparedInput& start, const Result& result,
                      std::span<const std::vector<NodeId>> course, Runtime& runtime) {
  const Relaxation& relaxation = result.relaxation;
  Bundle bundle = bundle_of(start.input);
  add_regions(bundle, start.mesh_graph, relaxation.partition, relaxation.seeds);
  add_region_figures(bundle, result.regions);
  add_trees(bundle, start.mesh_graph, relaxation.partition);
  add_field_of(field, start.input.mesh(), bundle, runtime.executor());
  if (result.ground_truth) add_truth(bundle, start.mesh_graph, *result.ground_truth);
  if (result.dual) add_remesh(bundle, result.dual->mesh);
  add_frames(start, relaxation, course, bundle, runtime);
  add_fact(bundle, "graph", name_of(graph_kind_names, start.mesh_graph.kind));
  add_fact(bundle, "regions", grouped(relaxation.seeds.size()));
  add_fact(bundle, "steps", grouped(relaxation.steps.size()));
  add_fact(bundle, "energy", fmt::format("{:.8g}", relaxation.energy));
  add_fact(bundle, "fingerprint", fingerprint_text(relaxation.fingerprint));
  if (result.dual) {
    add_fact(bundle, "dual", counted(result.dual->mesh.vertex_count(), "vertex", "vertices"));
  }
  return bundle;
}

Bundle remesh_contents(const RemeshedInput& done) {
  const Input& input = done.loaded.input;
  const Remesh& remesh = done.result.made.remesh;
  Bundle bundle = bundle_of(input);
  if (!done.field.empty()) add_field(bundle, done.field);
  add_remesh(bundle, remesh.mesh);
  add_fact(bundle, "remesh", counted(remesh.mesh.vertex_count(), "vertex", "vertices"));
  add_fact(bundle, "", counted(remesh.mesh.triangle_count(), "triangle", "triangles"));
  add_fact(bundle, "fingerprint", fingerprint_text(remesh.fingerprint));
  bundle.info["surface"] = "remesh";
  return bundle;
}

}  // namespace geolloyd
