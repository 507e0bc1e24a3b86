#include "tools/run/seed_source.h"

#include <utility>

#include "core/formats/mesh_formats.h"
#include "core/text/file_io.h"
#include "geolloyd/errors.h"
#include "tools/run/input.h"

namespace geolloyd {

SeedSource::SeedSource(const SeedFile& file)
    : name_(file.path.string()), by_(file.by), is_mesh_(has_mesh_name(file.path)) {
  if (!is_mesh_) {
    text_ = read_file(file.path);
    return;
  }
  if (by_ != SeedsBy::position) {
    throw InvalidInput(name_ + ": a mesh has no ids of seeds: give --by position, too");
  }
  positions_ = std::move(read_within_limits(file.path).mesh.positions);
}

std::size_t SeedSource::most() const {
  return is_mesh_ ? positions_.size() : most_seeds(text_);
}

GivenSeeds SeedSource::find(const MeshGraph& mesh_graph, const Components& components) const {
  if (is_mesh_) return seeds_at(positions_, name_, mesh_graph, components);
  return parse_seeds(text_, name_, by_, mesh_graph, components);
}

FindSeeds seeds_of(const SeedFile& file) {
  return [file](const MeshGraph& mesh_graph, const Components& components) {
    return SeedSource(file).find(mesh_graph, components);
  };
}

}  // namespace geolloyd
