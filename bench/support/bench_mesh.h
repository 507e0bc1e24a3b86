#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace geolloyd {

/// A mesh to run benchmarks on, as far as their names and numbers depend on it: it is made or read
/// when the first of them runs.
struct BenchMesh {
  std::string name;
  std::filesystem::path file;            ///< none: a generated creature
  std::size_t triangles = 0;             ///< of a creature, at least
  std::size_t nodes = 0;                 ///< of its vertex graph, at least
  std::vector<std::size_t> seed_ladder;  ///< numbers of seeds, ascending, at least one
  std::size_t usual_seeds = 0;           ///< where only one number of them is tried
};

/// `seeds`: the only number of seeds to try, where given.
BenchMesh generated_mesh(std::size_t triangles, std::optional<std::size_t> seeds);

/// Reads the file, so that nothing in it comes as a surprise later. Throws Error.
BenchMesh mesh_of_file(const std::filesystem::path& file, std::optional<std::size_t> seeds);

}  // namespace geolloyd
