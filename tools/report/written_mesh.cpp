#include "tools/report/written_mesh.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/files/json.h"
#include "tools/report/report_parts.h"
#include "tools/system/build_facts.h"
#include "tools/words/facts_text.h"

namespace geolloyd {

namespace {

Json part_of(const std::string& command, const MeshTarget& target, const Mesh& mesh) {
  return {{"program", program_name()},
          {"command", command},
          {"output", target.file.string()},
          {"vertices", mesh.vertex_count()},
          {"triangles", mesh.triangle_count()}};
}

std::string describe(const MeshTarget& target, const Mesh& mesh) {
  return fmt::format("{}: {} vertices, {} triangles\n", target.name(), grouped(mesh.vertex_count()),
                     grouped(mesh.triangle_count()));
}

}  // namespace

void print_written_mesh(const std::string& command, const MeshTarget& target, const Mesh& mesh,
                        const Console& console) {
  if (console.wants_json()) console.print_json(json_text(part_of(command, target, mesh)));
  fmt::print("{}", describe(target, mesh));
}

void print_converted_mesh(const MeshTarget& target, const LoadedMesh& loaded,
                          const Console& console) {
  if (console.wants_json()) {
    Json part = part_of("convert", target, loaded.mesh);
    part["polygons_split"] = loaded.polygon_count;
    part["corners_welded"] = loaded.welded_corners;
    part["properties"] = properties_part(loaded.properties);
    console.print_json(json_text(part));
  }
  fmt::print("{}{}{}", describe(target, loaded.mesh), describe_reading(loaded),
             describe(loaded.properties));
}

}  // namespace geolloyd
