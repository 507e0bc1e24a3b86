#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/course/field_source.h"
#include "geolloyd/remesh.h"
#include "geolloyd/repair.h"
#include "tools/files/mesh_reading.h"
#include "tools/files/mesh_target.h"

namespace geolloyd {

/// A remesh of a file that is asked for. Paths and names may be empty: then there is none.
struct RemeshRequest {
  std::filesystem::path mesh;
  MeshReading reading;
  std::optional<RepairOptions> repair;
  RemeshOptions options;       ///< but for what the next ones say
  double tolerance = 0;        ///< largest distance to the input; 0: not given
  bool is_percentage = false;  ///< the tolerance is one of the bounding box's diagonal
  std::filesystem::path lengths_file;
  std::filesystem::path densities_file;
  FieldSource field;
  std::filesystem::path edges_file;
  std::filesystem::path fixed_file;
  std::string labels;  ///< a property, borders between whose values are kept
  bool carries_properties = true;

  /// The files that are read, some of them empty: no result may replace one.
  [[nodiscard]] std::vector<std::filesystem::path> files() const {
    return {mesh, edges_file, fixed_file, lengths_file, densities_file, field.field_file()};
  }
};

/// The files of a remesh; all but the first may be empty.
struct RemeshFiles {
  MeshTarget remesh;
  std::filesystem::path map;
  std::filesystem::path issues;
  std::filesystem::path report;
  std::filesystem::path picture;
  std::filesystem::path page;
};

}  // namespace geolloyd
