#include "tools/cli/surface_remesh_arguments.h"

#include <CLI/App.hpp>

#include <cstdint>
#include <limits>

#include "tools/cli/number_option.h"

namespace geolloyd {

CLI::Option* add_vertices_option(CLI::App& command, std::size_t& vertices,
                                 const std::string& what) {
  constexpr std::uint64_t least = 4;
  return whole_number(command.add_option("-n,--vertices", vertices, what), least,
                      std::numeric_limits<std::uint32_t>::max());
}

}  // namespace geolloyd
