#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "geolloyd/remesh.h"
#include "tools/cli/relax_arguments.h"
#include "tools/cli/repair_arguments.h"

namespace geolloyd {

/// How fine a remesh is to be: one of three, or none where a file tells the edge lengths.
struct FinenessArguments {
  std::size_t vertices = 0;    ///< 0: not given
  double edge_length = 0;      ///< mesh units; 0: not given
  double tolerance = 0;        ///< largest distance to the input; 0: not given
  bool is_percentage = false;  ///< the tolerance is one of the bounding box's diagonal
};

/// Where edges are to be longer than elsewhere.
struct SizingArguments {
  std::filesystem::path lengths_file;    ///< empty: none
  std::filesystem::path densities_file;  ///< empty: none
  double adapt = 0;
  double growth = 1.12;

  [[nodiscard]] bool varies() const {
    return !lengths_file.empty() || !densities_file.empty() || adapt > 0;
  }
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
struct RemeshArguments {
  std::filesystem::path mesh;
  std::optional<MeshFormat> format;  ///< where the name of the mesh does not tell it
  RepairArguments repair;
  FinenessArguments fineness;
  SizingArguments sizing;
  FeatureArguments features;
  FieldSource field;
  bool no_fit = false;
  bool carries_properties = true;
  EngineKind engine = EngineKind::parallel;
  ThreadArguments threads;
  PictureLook picture;
  std::filesystem::path output;        ///< the remesh
  std::filesystem::path report_file;   ///< empty: none
  std::filesystem::path map_file;      ///< empty: none
  std::filesystem::path picture_file;  ///< empty: none
  std::filesystem::path page_file;     ///< empty: none

  /// The files that are read, some of them empty: no result may replace one.
  [[nodiscard]] std::vector<std::filesystem::path> inputs() const {
    return {mesh,
            features.edges_file,
            features.fixed_file,
            sizing.lengths_file,
            sizing.densities_file,
            field.field_file()};
  }
};

/// The options below, as the help groups them.
inline constexpr const char* sizing_group = "Sizes";
inline constexpr const char* feature_group = "Features";

/// --vertices, with this description.
CLI::Option* add_vertices_option(CLI::App& command, std::size_t& vertices, const std::string& what);
/// --vertices, --edge-length and --tolerance.
void add_fineness_options(CLI::App& command, FinenessArguments& fineness);
/// --vfield, in the same group, with this description.
void add_field_option(CLI::App& command, FieldSource& field, const std::string& what);
/// Throws InvalidInput where the field has no magnitudes: it would change nothing.
void check_has_magnitudes(const FieldSource& field);
/// --sizing and --density: files that belong to one mesh.
void add_size_file_options(CLI::App& command, SizingArguments& sizing);
/// --adapt and --growth.
void add_adapt_options(CLI::App& command, SizingArguments& sizing);
/// Throws InvalidInput unless what is given says how fine a remesh is to be, and does so once.
void check_fineness(const FinenessArguments& fineness, const SizingArguments& sizing);

/// --features and --feature-labels.
void add_feature_options(CLI::App& command, FeatureArguments& features);
/// --feature-edges and --fixed: files that belong to one mesh.
void add_feature_file_options(CLI::App& command, FeatureArguments& features);
/// --no-fit.
void add_no_fit_option(CLI::App& command, bool& no_fit);
/// As --features has it.
std::string name_of_creases(const FeatureArguments& features);

}  // namespace geolloyd
