#include "tools/cli/remesh_arguments.h"

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

// Whose numbers a repair would change; empty: none is given.
std::string option_that_names_vertices(const RemeshArguments& arguments) {
  const RemeshRequest& request = arguments.request;
  if (!request.lengths_file.empty()) return "--sizing";
  if (!request.densities_file.empty()) return "--density";
  if (!request.edges_file.empty()) return "--feature-edges";
  if (!request.fixed_file.empty()) return "--fixed";
  if (!request.field.field_file().empty()) return "--vfield";
  return arguments.files.map.empty() ? "" : "--map";
}

}  // namespace

CLI::Option* add_vertices_option(CLI::App& command, std::size_t& vertices,
                                 const std::string& what) {
  constexpr std::uint64_t least = 4;
  return whole_number(command.add_option("-n,--vertices", vertices, what), least,
                      std::numeric_limits<std::uint32_t>::max());
}

void add_fineness_options(CLI::App& command, RemeshRequest& request) {
  add_vertices_option(command, request.options.vertex_count,
                      "Number of vertices; there are more only where the topology needs\n"
                      "them");
  positive_number(command.add_option("--edge-length", request.options.edge_length,
                                     "Mean length of edges, instead of --vertices"))
      ->type_name("LENGTH");
  command
      .add_option_function<std::string>(
          "--tolerance",
          [&request](const std::string& text) {
            std::string_view number = text;
            request.is_percentage = number.ends_with('%');
            if (request.is_percentage) number.remove_suffix(1);
            const auto value = parse_number<double>(number);
            if (!value || !std::isfinite(*value) || !(*value > 0)) {
              throw CLI::ValidationError(
                  "--tolerance", "'" + text +
                                     "': give a distance above 0, or like 0.5% of the bounding "
                                     "box's diagonal");
            }
            request.tolerance = *value;
          },
          "Largest distance to the input, such as 0.1, or 0.5% of the\n"
          "bounding box's diagonal: searches the fewest vertices for it,\n"
          "by --equal-error unless other sizes are given")
      ->type_name("DISTANCE");
}

void add_field_option(CLI::App& command, RemeshRequest& request, const std::string& what) {
  command.add_option("--vfield", request.field.vfield, what)
      ->type_name("FILE|curvature")
      ->group(sizing_group);
}

void check_has_magnitudes(const FieldSource& field) {
  if (!field.has_cross_field()) return;
  throw InvalidInput(
      "--vfield cross: has directions without magnitudes, which shape no triangles: give "
      "curvature, or a file");
}

void add_size_file_options(CLI::App& command, RemeshRequest& request) {
  command
      .add_option("--sizing", request.lengths_file,
                  "File of edge lengths: one per line, for each vertex of the input\n"
                  "in turn. With --vertices, --edge-length or --tolerance they are\n"
                  "scaled")
      ->type_name("FILE")
      ->group(sizing_group);
  command
      .add_option("--density", request.densities_file,
                  "File of densities, in the same form: lengths of edges are\n"
                  "proportional to density^(-1/4)")
      ->type_name("FILE")
      ->group(sizing_group);
}

void add_adapt_options(CLI::App& command, RemeshRequest& request) {
  command
      .add_option_function<std::string>(
          "--adapt",
          [&request](const std::string& text) {
            const auto value = parse_number<double>(text);
            if (!value || !(*value >= 0 && *value <= 2)) {
              throw CLI::ValidationError("--adapt", "'" + text + "': give a number from 0 to 2");
            }
            request.options.sizing.adapt = *value;
          },
          "Shorter edges where the surface is curved: lengths are\n"
          "proportional to curvature^(-G/2). 0: the same everywhere")
      ->type_name("G")
      ->group(sizing_group);
  command
      .add_flag("--equal-error", request.options.sizing.equal_error,
                "Shorter edges where the remesh would be far from the input, longer\n"
                "ones where it is close: the largest distance gets smaller")
      ->group(sizing_group);
  command
      .add_option_function<std::string>(
          "--growth",
          [&request](const std::string& text) {
            const auto value = parse_number<double>(text);
            if (!value || !std::isfinite(*value) || !(*value > 1)) {
              throw CLI::ValidationError("--growth", "'" + text + "': give a number above 1");
            }
            request.options.sizing.growth = *value;
          },
          "Maximum ratio of the lengths of adjacent edges, where lengths vary")
      ->type_name("FACTOR")
      ->default_str("1.12")
      ->group(sizing_group);
}

// Of equal distances are the fewest vertices.
void choose_sizing(RemeshRequest& request) {
  const bool is_free = request.lengths_file.empty() && request.densities_file.empty() &&
                       request.field.vfield.empty() && !(request.options.sizing.adapt > 0);
  if (request.tolerance > 0 && is_free) request.options.sizing.equal_error = true;
}

void check_fineness(const RemeshRequest& request) {
  const RemeshOptions& options = request.options;
  const int fields = (request.lengths_file.empty() ? 0 : 1) +
                     (request.densities_file.empty() ? 0 : 1) + (options.sizing.adapt > 0 ? 1 : 0) +
                     (options.sizing.equal_error ? 1 : 0);
  if (fields > 1) {
    throw InvalidInput("--sizing, --density, --adapt and --equal-error exclude each other");
  }
  const int given = (options.vertex_count > 0 ? 1 : 0) + (options.edge_length > 0 ? 1 : 0) +
                    (request.tolerance > 0 ? 1 : 0);
  if (given == 1 || (given == 0 && !request.lengths_file.empty())) return;
  throw InvalidInput(given == 0 ? "how fine? Give --vertices N, --edge-length LENGTH or "
                                  "--tolerance DISTANCE"
                                : "--vertices, --edge-length and --tolerance exclude each other");
}

void add_feature_options(CLI::App& command, RemeshRequest& request) {
  command
      .add_option_function<std::string>(
          "--features",
          [&features = request.options.features](const std::string& text) {
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
          "Sharp edges that the remesh keeps: auto finds those between\n"
          "faces, an angle in degrees takes all edges that turn so far")
      ->type_name("auto|off|ANGLE")
      ->default_str("auto")
      ->group(feature_group);
  command
      .add_flag("!--no-small-features", request.options.features.small,
                "Edges as long as elsewhere where holes and walls are smaller\n"
                "than edges, which then lose their shape")
      ->group(feature_group);
  command
      .add_option("--feature-labels", request.labels,
                  "Property of triangles or of vertices, such as region: borders\n"
                  "between its values are kept")
      ->type_name("NAME")
      ->group(feature_group);
}

void add_feature_file_options(CLI::App& command, RemeshRequest& request) {
  command
      .add_option("--feature-edges", request.edges_file,
                  "File of further edges to keep: two vertices of the input per\n"
                  "line, counted from 0")
      ->type_name("FILE")
      ->group(feature_group);
  command
      .add_option("--fixed", request.fixed_file,
                  "File of vertices to keep where they are: one vertex of the input\n"
                  "per line, counted from 0")
      ->type_name("FILE")
      ->group(feature_group);
}

void add_no_fit_option(CLI::App& command, RemeshRequest& request) {
  command.add_flag("!--no-fit", request.options.fit,
                   "Leave vertices on the surface of the input, instead of moving them\n"
                   "off it where that brings the triangles closer");
}

std::string name_of_creases(const FeatureOptions& features) {
  if (features.creases == Creases::none) return "off";
  if (features.creases == Creases::automatic) return "auto";
  return fmt::format("{}", features.crease_angle);
}

void check_remesh(RemeshArguments& arguments) {
  RemeshRequest& request = arguments.request;
  check_fineness(request);
  choose_sizing(request);
  check_has_magnitudes(request.field);
  check_repair(arguments.repair, option_that_names_vertices(arguments));
  request.repair = arguments.repair.wanted();
}

}  // namespace geolloyd
