#pragma once

#include <string>

#include "parallel/threads/scheduler.h"
#include "tools/cli/remesh_arguments.h"
#include "tools/files/file_group.h"
#include "tools/files/json.h"
#include "tools/render/surface_colours.h"
#include "tools/run/remesh_run.h"

namespace geolloyd {

/// Makes sure that all files can be written, and that none would replace the input or another,
/// before any work depends on it. Throws Error.
void check_remesh_targets(const RemeshArguments& arguments);

/// The remesh, the map and the report, as far as they are asked for, in this order.
FileGroup open_remesh_files(const RemeshArguments& arguments);
/// All but the report. The map has a line per vertex: vertex, triangle of the input, and the
/// weights of its three corners; -1 and no weights where a vertex has no triangle.
void write_remesh(const RemeshArguments& arguments, const RemeshResult& result, FileGroup& files);
/// JSON with all figures.
std::string remesh_report(const RemeshArguments& arguments, const LoadedInput& loaded,
                          const RemeshResult& result);
/// The report, if it is asked for, with which all files appear.
void write_remesh_report(const RemeshArguments& arguments, const LoadedInput& loaded,
                         const RemeshResult& result, FileGroup& files);

/// The options in force.
Json remesh_options_part(const RemeshArguments& arguments, std::size_t threads);

/// The remesh with its edges.
void write_remesh_picture(const RemeshArguments& arguments, const Mesh& remesh,
                          const SurfaceColours& colours, Scheduler& scheduler);

/// For people.
std::string describe(const RemeshArguments& arguments, const LoadedInput& loaded,
                     const RemeshResult& result);

}  // namespace geolloyd
