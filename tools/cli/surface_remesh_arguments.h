#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "geolloyd/remesh.h"
#include "tools/cli/relax_arguments.h"

namespace geolloyd {

/// How fine a remesh is to be: one of three.
struct FinenessArguments {
  std::size_t vertices = 0;    ///< 0: not given
  double edge_length = 0;      ///< mesh units; 0: not given
  double tolerance = 0;        ///< largest distance to the input; 0: not given
  bool is_percentage = false;  ///< the tolerance is one of the bounding box's diagonal
};

/// What of the input is kept.
struct FeatureArguments {
  Creases creases = Creases::automatic;
  double crease_angle = 0;           ///< degrees
  std::filesystem::path edges_file;  ///< empty: none
  std::filesystem::path fixed_file;  ///< empty: none
  std::string labels;                ///< a property, borders between whose values are kept; or ""
};

/// All of `remesh`.
struct SurfaceRemeshArguments {
  std::filesystem::path mesh;
  FinenessArguments fineness;
  FeatureArguments features;
  bool no_fit = false;
  bool carries_properties = true;
  EngineKind engine = EngineKind::parallel;
  ThreadArguments threads;
  PictureArguments picture;
  std::filesystem::path output;        ///< the remesh
  std::filesystem::path report_file;   ///< empty: none
  std::filesystem::path map_file;      ///< empty: none
  std::filesystem::path picture_file;  ///< empty: none

  /// The files that are read, some of them empty: no result may replace one.
  [[nodiscard]] std::vector<std::filesystem::path> inputs() const {
    return {mesh, features.edges_file, features.fixed_file};
  }
};

/// --vertices, with this description.
CLI::Option* add_vertices_option(CLI::App& command, std::size_t& vertices, const std::string& what);
/// --vertices, --edge-length and --tolerance.
void add_fineness_options(CLI::App& command, FinenessArguments& fineness);
/// Throws InvalidInput unless one of the three is given.
void check_fineness(const FinenessArguments& fineness);

/// --features, --feature-edges, --feature-labels and --fixed.
void add_feature_options(CLI::App& command, FeatureArguments& features);
/// As --features has it.
std::string name_of_creases(const FeatureArguments& features);

}  // namespace geolloyd
