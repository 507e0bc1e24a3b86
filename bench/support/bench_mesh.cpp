#include "bench/support/bench_mesh.h"

#include <algorithm>
#include <utility>

#include "core/formats/mesh_io.h"
#include "core/mesh/mesh_check.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// Of its vertex graph, which can have no fewer seeds than components.
struct Size {
  std::size_t nodes;
  std::size_t components;
};

std::vector<std::size_t> ladder_for(const Size& size) {
  constexpr std::size_t least_region = 8;  // smaller ones are mere borders
  std::vector<std::size_t> ladder;
  for (const std::size_t seeds : {4U, 32U, 256U, 2048U, 32768U}) {
    if (seeds >= size.components && seeds * least_region <= size.nodes) ladder.push_back(seeds);
  }
  if (ladder.empty()) ladder.push_back(size.components);
  return ladder;
}

BenchMesh with_seeds(BenchMesh mesh, const Size& size, std::optional<std::size_t> seeds) {
  constexpr std::size_t usual_most = 2048;
  if (seeds && (*seeds < size.components || *seeds > size.nodes)) {
    throw InvalidInput(mesh.name + ": " + std::to_string(*seeds) + " seeds do not fit: choose " +
                       std::to_string(size.components) + " to " + std::to_string(size.nodes));
  }
  mesh.seed_ladder = seeds ? std::vector{*seeds} : ladder_for(size);
  mesh.nodes = size.nodes;
  mesh.usual_seeds = mesh.seed_ladder.front();
  for (const std::size_t count : mesh.seed_ladder) {
    if (count <= usual_most) mesh.usual_seeds = count;
  }
  return mesh;
}

}  // namespace

BenchMesh generated_mesh(std::size_t triangles, std::optional<std::size_t> seeds) {
  BenchMesh mesh;
  mesh.name = "creature-" + std::to_string(triangles);
  mesh.triangles = triangles;
  return with_seeds(std::move(mesh), {triangles / 2, 1}, seeds);  // closed, of genus 0
}

BenchMesh mesh_of_file(const std::filesystem::path& file, std::optional<std::size_t> seeds) {
  const Mesh held = read(file).mesh;
  const MeshFacts facts = check_mesh(held, find_edges(held));
  const std::size_t nodes = facts.vertices - facts.unreferenced_vertices;
  if (nodes == 0) throw InvalidInput(file.string() + ": no usable triangle");
  BenchMesh mesh;
  mesh.name = file.filename().string();
  mesh.file = file;
  return with_seeds(std::move(mesh), {nodes, facts.components}, seeds);
}

}  // namespace geolloyd
