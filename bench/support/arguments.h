#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace geolloyd {

/// What the command line says besides Google Benchmark's own options.
struct Arguments {
  std::vector<std::filesystem::path> meshes;  ///< none: generated ones
  std::optional<std::size_t> seeds;
  bool help = false;
};

/// Takes its own options out of `argv`; --help stays. Throws InvalidInput.
Arguments take_arguments(int& argc, char** argv);

void print_help();

}  // namespace geolloyd
