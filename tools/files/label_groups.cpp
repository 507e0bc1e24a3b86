#include "tools/files/label_groups.h"

#include <algorithm>
#include <array>

#include "core/properties/properties.h"
#include "core/text/text_cursor.h"
#include "geolloyd/errors.h"

namespace geolloyd {

std::vector<std::uint32_t> label_groups(const Mesh& mesh, const Properties& properties,
                                        const std::string& name) {
  const Property* of_triangles = find_property(properties.of_triangles, name);
  const Property* of_vertices = find_property(properties.of_vertices, name);
  const Property* labels = of_triangles != nullptr ? of_triangles : of_vertices;
  const std::string option = "--feature-labels " + in_quotes(name) + ": ";
  if (labels == nullptr) {
    const auto names = [](const std::vector<Property>& all) {
      return all.empty() ? std::string("none") : list_names(all);
    };
    throw InvalidInput(option + "the mesh has no such property; its vertices have " +
                       names(properties.of_vertices) + ", its triangles " +
                       names(properties.of_triangles));
  }
  if (!has_integers(*labels)) {
    throw InvalidInput(option + "its type is " + type_name(labels->values) +
                       ", and labels are integers");
  }
  if (!is_label(*labels)) throw InvalidInput(option + "it is a part of a colour, and no label");
  const auto value = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(value_at(*labels, i)));
  };
  const std::span<const Triangle> corners = value_triangles(mesh, properties);
  std::vector<std::uint32_t> groups(mesh.triangle_count());
  for (std::size_t t = 0; t < groups.size(); ++t) {
    if (of_triangles != nullptr) {
      groups[t] = value(t);
      continue;
    }
    std::array<std::int64_t, 3> corner{};
    for (std::size_t c = 0; c < 3; ++c) {
      corner[c] = static_cast<std::int64_t>(value_at(*labels, corners[t][c]));
    }
    std::sort(corner.begin(), corner.end());
    groups[t] = static_cast<std::uint32_t>(corner[1] == corner[2] ? corner[1] : corner[0]);
  }
  return groups;
}

}  // namespace geolloyd
