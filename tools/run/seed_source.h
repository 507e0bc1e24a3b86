#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/course/run_plan.h"

namespace geolloyd {

/// A file of seeds that has been read, before there is a graph that it is for.
class SeedSource {
 public:
  /// Reads the file of --seeds-file; a name with the extension of a mesh that is read makes it one.
  /// Throws InvalidInput where a mesh is not taken by position, and as read_within_limits().
  explicit SeedSource(const SeedFile& file);

  /// How many seeds it gives at most.
  [[nodiscard]] std::size_t most() const;
  /// Throws as parse_seeds() and seeds_at().
  [[nodiscard]] GivenSeeds find(const MeshGraph& mesh_graph, const Components& components) const;

 private:
  std::string name_;
  SeedsBy by_;
  bool is_mesh_;
  std::string text_;             // of a file that is no mesh
  std::vector<Vec3> positions_;  // of a mesh's vertices
};

/// The seeds of a file that is read when they are asked for.
FindSeeds seeds_of(const SeedFile& file);

}  // namespace geolloyd
