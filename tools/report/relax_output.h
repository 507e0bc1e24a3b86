#pragma once

#include <filesystem>
#include <string>

#include "parallel/threads/scheduler.h"
#include "tools/files/file_group.h"
#include "tools/run/result.h"

namespace geolloyd {

/// Makes the folder and makes sure that the results and the picture can be written, before hours of
/// work depend on it, and that none of them would replace the mesh, the field or the file of the
/// first seeds. Throws Error.
void prepare_output(const RelaxArguments& arguments);

/// The files of the results. Those of another run stay until write_report.
FileGroup open_results(const std::filesystem::path& folder);

/// tessellation.ply: the input mesh with `region` (-1: none) and a colour per vertex, or per face
/// in graphs of triangles, or both in the mixed one; adjacent regions differ in colour. seeds.csv:
/// a line per region. regions.csv: a line per input id. remesh.ply: a vertex per region, those of
/// added seeds last.
void write_results(const Start& start, const Result& result, FileGroup& files,
                   Scheduler& scheduler);

/// The regions, in the colours of tessellation.ply.
void write_picture(const std::filesystem::path& path, const PictureArguments& arguments,
                   const Start& start, const Relaxation& relaxation, Scheduler& scheduler);

/// report.json, with which all of them appear. `text`: of report.h.
void write_report(const std::string& text, FileGroup& files);

}  // namespace geolloyd
