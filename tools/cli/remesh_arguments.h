#pragma once

#include <cstddef>
#include <string>

#include "tools/cli/relax_arguments.h"
#include "tools/cli/repair_arguments.h"
#include "tools/files/remesh_request.h"

namespace geolloyd {

/// All of `remesh`.
struct RemeshArguments {
  RemeshRequest request;
  RepairArguments repair;
  EngineKind engine = EngineKind::parallel;
  ThreadArguments threads;
  PictureLook picture;
  RemeshFiles files;
  bool is_strict = false;  ///< warnings are told by the exit status, too
};

/// The options below, as the help groups them.
inline constexpr const char* sizing_group = "Sizes";
inline constexpr const char* feature_group = "Features";

/// --vertices, with this description.
CLI::Option* add_vertices_option(CLI::App& command, std::size_t& vertices, const std::string& what);
/// --vertices, --edge-length and --tolerance.
void add_fineness_options(CLI::App& command, RemeshRequest& request);
/// --vfield, in the same group, with this description.
void add_field_option(CLI::App& command, RemeshRequest& request, const std::string& what);
/// Throws InvalidInput where the field has no magnitudes: it would change nothing.
void check_has_magnitudes(const FieldSource& field);
/// --sizing and --density: files that belong to one mesh.
void add_size_file_options(CLI::App& command, RemeshRequest& request);
/// --adapt, --equal-error and --growth.
void add_adapt_options(CLI::App& command, RemeshRequest& request);
/// Throws InvalidInput unless what is given says how fine a remesh is to be, and does so once.
void check_fineness(const RemeshRequest& request);

/// --features and --feature-labels.
void add_feature_options(CLI::App& command, RemeshRequest& request);
/// --feature-edges and --fixed: files that belong to one mesh.
void add_feature_file_options(CLI::App& command, RemeshRequest& request);
/// --no-fit.
void add_no_fit_option(CLI::App& command, RemeshRequest& request);
/// Completes the request. Throws InvalidInput where options contradict each other.
void check_remesh(RemeshArguments& arguments);
/// As --features has it.
std::string name_of_creases(const FeatureOptions& features);

}  // namespace geolloyd
