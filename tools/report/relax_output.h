#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/executor.h"
#include "tools/files/file_group.h"
#include "tools/files/output_folder.h"
#include "tools/run/result.h"

namespace geolloyd {

/// Where the results of `relax` go.
struct RelaxTargets {
  std::filesystem::path folder;
  std::vector<RelaxOutput> only = values_of(relax_output_names);  ///< what goes there
  std::filesystem::path picture_file;                             ///< empty: none
  std::filesystem::path frames;                                   ///< a folder; empty: none
  std::filesystem::path page_file;                                ///< empty: none
  std::filesystem::path vtp_file;                                 ///< empty: none

  [[nodiscard]] bool writes(RelaxOutput what) const {
    return std::find(only.begin(), only.end(), what) != only.end();
  }
};

/// Makes the folder and makes sure that the results and the picture can be written, before hours of
/// work depend on it, and that none of them would replace one of the `inputs`. `is_resumed`: there
/// are frames already. Throws Error.
[[nodiscard]] MadeFolders prepare_output(const RelaxTargets& targets,
                                         std::vector<std::filesystem::path> inputs,
                                         bool is_resumed);

/// The names of the files that are wanted, in the order in which they appear.
std::vector<std::string> names_of_results(const RelaxTargets& targets);

/// The files of the results that are wanted. Those of an earlier run stay until commit().
class ResultFiles {
 public:
  /// `targets` must live on.
  explicit ResultFiles(const RelaxTargets& targets);

  /// Null: not wanted.
  [[nodiscard]] FileWriter* find(RelaxOutput output);
  /// They appear. Files of an earlier run that are not wanted now go: a folder has the files of one
  /// run. Returns their names.
  std::vector<std::string> commit();

 private:
  const RelaxTargets& targets_;
  FileGroup files_;
};

/// tessellation.ply: the input mesh with `region` (-1: none) and a colour per vertex, or per face
/// in graphs of triangles, or both in the mixed one; adjacent regions differ in colour. seeds.csv:
/// a line per region. regions.csv: a line per input id. dual.ply: a vertex per region, those of
/// added seeds last. Writes those of them that are wanted.
void write_results(const PreparedInput& start, const Result& result, ResultFiles& files,
                   Executor& executor);

/// The regions, in the colours of tessellation.ply.
void write_picture(const std::filesystem::path& path, const PictureLook& look,
                   const PreparedInput& start, const Relaxation& relaxation, Executor& executor);

}  // namespace geolloyd
