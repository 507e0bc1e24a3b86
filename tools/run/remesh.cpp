#include "tools/run/remesh.h"

#include <string>
#include <utility>
#include <vector>

#include "core/formats/vertex_list.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "tools/files/label_groups.h"
#include "tools/render/picture.h"
#include "tools/run/memory_need.h"
#include "tools/run/stages.h"
#include "tools/system/interrupt.h"

namespace geolloyd {
LoadedInput load_surface(const RemeshRequest& request, Executor& executor, ProgressLine& progress) {
  progress.stage("reading " + request.mesh.string());
  LoadedInput loaded = load_input(
      request.mesh, executor,
      {request.carries_properties || !request.labels.empty(), request.reading}, request.repair);
  if (!(loaded.input.facts.area > 0)) {
    throw InvalidInput(request.mesh.string() + ": no triangle with an area, so nothing to remesh");
  }
  return loaded;
}

RemeshOptions read_options(const RemeshRequest& request, const LoadedInput& loaded,
                           Executor& executor) {
  const Mesh& mesh = loaded.input.mesh();
  const std::vector<VertexId>& welded_to = loaded.input.loaded.welded_to;
  RemeshOptions options = request.options;
  const auto values_in = [&](const std::filesystem::path& file) {
    if (file.empty()) return std::vector<double>();
    return parse_vertex_values(read_file(file), file.string(), mesh.vertex_count());
  };
  options.sizing.edge_lengths = values_in(request.lengths_file);
  options.sizing.densities = values_in(request.densities_file);
  options.field = find_field(request.field, mesh, loaded.edges, executor);
  if (!request.edges_file.empty()) {
    options.features.edges = parse_edge_list(
        read_file(request.edges_file), request.edges_file.string(), mesh, loaded.edges, welded_to);
  }
  if (!request.fixed_file.empty()) {
    options.features.fixed_vertices = parse_vertex_list(
        read_file(request.fixed_file), request.fixed_file.string(), mesh, welded_to);
  }
  if (!request.labels.empty()) {
    options.features.groups = label_groups(mesh, loaded.input.loaded.properties, request.labels);
  }
  return options;
}

std::uint64_t estimate_remesh_memory(const Input& input, const MeshEdges& edges,
                                     std::size_t vertices, const RemeshOptions& options,
                                     const std::optional<PictureLook>& picture,
                                     Executor& executor) {
  WorkSize size = size_of(input.loaded);
  size.sites = vertices;
  if (picture) size.samples = count_samples(input.mesh(), picture->view, picture->size, executor);
  return memory_to_remesh(input.mesh(), edges, input.facts.area, options, size, executor);
}

RemeshCourse remesh_course(const LoadedInput& loaded, RemeshOptions options, Runtime& runtime,
                           ProgressLine& progress, std::function<void(std::uint64_t)> budget,
                           const std::optional<PictureLook>& picture) {
  // Before sites of the remesh move nothing is lost if an interrupt ends the program at once.
  options.progress = [&progress](const RemeshProgress& p) {
    if (!p.finds_sizes) catch_interrupts();
    progress.show(p);
    return true;
  };
  RemeshCourse course{loaded.input.mesh(), loaded.edges, std::move(options), runtime};
  course.hooks = {[&progress](const std::string& stage) { progress.stage(stage); },
                  [] { return !interrupted(); }, std::move(budget)};
  course.bytes = [&loaded, &runtime, picture](std::size_t vertices, const RemeshOptions& asked) {
    return estimate_remesh_memory(loaded.input, loaded.edges, vertices, asked, picture,
                                  runtime.executor());
  };
  return course;
}

}  // namespace geolloyd
