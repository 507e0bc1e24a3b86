#include "tools/cli/surface_remesh_arguments.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "geolloyd/errors.h"
#include "tools/cli/number_option.h"
#include "tools/words/numbers.h"

namespace geolloyd {
namespace {

constexpr const char* feature_group = "Features";

}  // namespace

CLI::Option* add_vertices_option(CLI::App& command, std::size_t& vertices,
                                 const std::string& what) {
  constexpr std::uint64_t least = 4;
  return whole_number(command.add_option("-n,--vertices", vertices, what), least,
                      std::numeric_limits<std::uint32_t>::max());
}

void add_fineness_options(CLI::App& command, FinenessArguments& fineness) {
  add_vertices_option(command, fineness.vertices,
                      "Number of vertices; there are more only where the topology needs\n"
                      "them");
  positive_number(command.add_option("--edge-length", fineness.edge_length,
                                     "Mean length of edges, instead of --vertices"))
      ->type_name("LENGTH");
  command
      .add_option_function<std::string>(
          "--tolerance",
          [&fineness](const std::string& text) {
            std::string_view number = text;
            fineness.is_percentage = number.ends_with('%');
            if (fineness.is_percentage) number.remove_suffix(1);
            const auto value = parse_number<double>(number);
            if (!value || !std::isfinite(*value) || !(*value > 0)) {
              throw CLI::ValidationError(
                  "--tolerance", "'" + text +
                                     "': give a distance above 0, or like 0.5% of the bounding "
                                     "box's diagonal");
            }
            fineness.tolerance = *value;
          },
          "Largest distance to the input, such as 0.1, or 0.5% of the\n"
          "bounding box's diagonal: searches the fewest vertices for it")
      ->type_name("DISTANCE");
}

void check_fineness(const FinenessArguments& fineness) {
  const int given = (fineness.vertices > 0 ? 1 : 0) + (fineness.edge_length > 0 ? 1 : 0) +
                    (fineness.tolerance > 0 ? 1 : 0);
  if (given == 1) return;
  throw InvalidInput(given == 0 ? "how fine? Give --vertices N, --edge-length LENGTH or "
                                  "--tolerance DISTANCE"
                                : "--vertices, --edge-length and --tolerance exclude each other");
}

void add_feature_options(CLI::App& command, FeatureArguments& features) {
  command
      .add_option_function<std::string>(
          "--features",
          [&features](const std::string& text) {
            const auto angle = parse_number<double>(text);
            if (text == "auto" || text == "off") {
              features.creases = text == "auto" ? Creases::automatic : Creases::none;
            } else if (angle && *angle > 0 && *angle <= 180) {
              features.creases = Creases::by_angle;
              features.crease_angle = *angle;
            } else {
              throw CLI::ValidationError(
                  "--features",
                  "'" + text + "': give auto, off, or an angle above 0 and up to 180 degrees");
            }
          },
          "Sharp edges that the remesh keeps: auto finds those that stand\n"
          "out, an angle in degrees takes all that turn as much")
      ->type_name("auto|off|ANGLE")
      ->default_str("auto")
      ->group(feature_group);
  command
      .add_option("--feature-edges", features.edges_file,
                  "File of further edges to keep: two vertices of the input per\n"
                  "line, counted from 0")
      ->type_name("FILE")
      ->group(feature_group);
  command
      .add_option("--feature-labels", features.labels,
                  "Property of triangles or of vertices, such as region: borders\n"
                  "between its values are kept")
      ->type_name("NAME")
      ->group(feature_group);
  command
      .add_option("--fixed", features.fixed_file,
                  "File of vertices to keep where they are: one vertex of the input\n"
                  "per line, counted from 0")
      ->type_name("FILE")
      ->group(feature_group);
}

std::string name_of_creases(const FeatureArguments& features) {
  if (features.creases == Creases::none) return "off";
  if (features.creases == Creases::automatic) return "auto";
  return fmt::format("{}", features.crease_angle);
}

}  // namespace geolloyd
