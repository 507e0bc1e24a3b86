#include "tools/cli/repair_arguments.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdint>
#include <string_view>

#include "geolloyd/errors.h"
#include "tools/words/facts_text.h"
#include "tools/words/numbers.h"

namespace geolloyd {
namespace {

constexpr const char* repair_group = "Repair";

// Throws ValidationError where the text is no size of holes.
RepairOptions parse_hole_size(const std::string& text) {
  RepairOptions options;
  options.hole_share = 0;
  if (text == "off") return options;
  std::string_view number = text;
  if (number.ends_with('%')) {
    number.remove_suffix(1);
    const auto percent = parse_number<double>(number);
    if (percent && std::isfinite(*percent) && *percent > 0) {
      options.hole_share = *percent / 100;
      return options;
    }
  } else if (const auto edges = parse_number<std::uint32_t>(number); edges && *edges > 0) {
    options.hole_edges = *edges;
    return options;
  }
  throw CLI::ValidationError(
      "--fill-holes", "'" + text +
                          "': give a number of edges, such as 12, a length, such as 5% of the "
                          "component's diagonal, or off");
}

}  // namespace

void add_hole_option(CLI::App& command, RepairArguments& repair) {
  command
      .add_option_function<std::string>(
          "--fill-holes",
          [&repair](const std::string& text) {
            repair.options = parse_hole_size(text);
            repair.has_hole_size = true;
          },
          "Largest holes to fill: a number of edges, or a length around in %\n"
          "of the diagonal of their component's bounding box")
      ->type_name("EDGES|LENGTH%|off")
      ->default_str(name_of_hole_size({}))
      ->group(repair_group);
}

void add_repair_options(CLI::App& command, RepairArguments& repair) {
  command
      .add_flag("--repair", repair.is_wanted,
                "Repair the mesh first: duplicates, cracks, slivers, orientations,\n"
                "small holes. The result is one of the repaired mesh")
      ->group(repair_group);
  add_hole_option(command, repair);
}

void check_repair(const RepairArguments& repair, const std::string& option) {
  if (repair.has_hole_size && !repair.is_wanted) {
    throw InvalidInput("--fill-holes belongs to a repair: give --repair, too");
  }
  if (repair.is_wanted && !option.empty()) {
    throw InvalidInput("--repair and " + option +
                       " exclude each other, because a repair renumbers vertices and triangles: "
                       "write the repaired mesh with geolloyd repair and use that");
  }
}

}  // namespace geolloyd
