#include "tools/report/written_mesh.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/files/json.h"
#include "tools/system/build_facts.h"
#include "tools/words/facts_text.h"

namespace geolloyd {

void print_written_mesh(const std::string& command, const MeshTarget& target, const Mesh& mesh,
                        const Console& console) {
  if (console.wants_json()) {
    console.print_json(json_text({{"program", program_name()},
                                  {"command", command},
                                  {"output", target.file.string()},
                                  {"vertices", mesh.vertex_count()},
                                  {"triangles", mesh.triangle_count()}}));
  }
  fmt::print("{}: {} vertices, {} triangles\n", target.name(), grouped(mesh.vertex_count()),
             grouped(mesh.triangle_count()));
}

}  // namespace geolloyd
