#pragma once

#include <span>
#include <string>

#include "tools/files/file_group.h"
#include "tools/files/json.h"
#include "tools/files/remesh_request.h"
#include "tools/render/surface_colours.h"
#include "tools/render/view.h"
#include "tools/run/remesh_run.h"

namespace geolloyd {

/// Makes sure that all files can be written, and that none would replace an input or another,
/// before any work depends on it. Throws Error.
void prepare_remesh_targets(RemeshFiles& names, const RemeshRequest& request, Console& console);

/// The remesh, the map, the issues and the report, as far as they are asked for, in this order.
FileGroup open_remesh_files(const RemeshFiles& names);
/// All but the report. The map has a line per vertex: vertex, triangle of the input, and the
/// weights of its three corners; -1 and no weights where a vertex has no triangle.
void write_remesh(const RemeshFiles& names, const RemeshResult& result, FileGroup& files);
/// JSON with all figures.
std::string remesh_report(const RemeshRequest& request, const RemeshedInput& done);
/// The report, if it is asked for, with which all files appear.
void write_remesh_report(const RemeshFiles& names, const RemeshRequest& request,
                         const RemeshedInput& done, FileGroup& files);

/// The options in force.
Json remesh_options_part(const RemeshRequest& request, const RemeshWorkers& workers);

/// The remesh with its edges, as the camera of the input sees it.
void write_remesh_picture(const std::filesystem::path& file, const PictureLook& look,
                          const RemeshedInput& done, const SurfaceColours& colours,
                          Executor& executor);

/// For people.
std::string describe(const RemeshFiles& names, const RemeshedInput& done);

}  // namespace geolloyd
