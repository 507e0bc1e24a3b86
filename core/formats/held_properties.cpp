#include "core/formats/held_properties.h"

#include <algorithm>
#include <cstdint>
#include <variant>

namespace geolloyd {
namespace {

Numbers numbers_of(std::span<const Property> properties, const std::vector<const char*>& names) {
  Numbers numbers;
  for (const char* name : names) {
    const Property* property = find_property(properties, name);
    if (property == nullptr) return {};
    numbers.push_back(property);
  }
  return numbers;
}

// OBJ knows no alpha.
Numbers colours_of(std::span<const Property> properties, MeshFormat format) {
  Numbers colours = numbers_of(properties, {"red", "green", "blue"});
  const Property* alpha = find_property(properties, "alpha");
  if (!colours.empty() && alpha != nullptr && format != MeshFormat::obj) colours.push_back(alpha);
  return colours;
}

// The first of these that has integers.
const Property* label_of(std::span<const Property> properties,
                         const std::vector<const char*>& names) {
  for (const char* name : names) {
    const Property* property = find_property(properties, name);
    if (property != nullptr && has_integers(*property)) return property;
  }
  return nullptr;
}

}  // namespace

HeldProperties::HeldProperties(MeshFormat format, const Properties& properties) {
  if (format == MeshFormat::stl) return;
  const bool has_labels = format == MeshFormat::medit || format == MeshFormat::gmsh;
  if (format == MeshFormat::medit) vertex_label = label_of(properties.of_vertices, {"ref"});
  if (has_labels) {
    triangle_label = label_of(properties.of_triangles, {"ref", "physical", "entity", "region"});
    return;
  }
  const std::span<const Property> vertices = properties.of_vertices;
  colours = colours_of(vertices, format);
  normals = numbers_of(vertices, {"nx", "ny", "nz"});
  for (const auto& names : {std::vector{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
    if (texture.empty()) texture = numbers_of(vertices, names);
  }
  if (format == MeshFormat::off) triangle_colours = colours_of(properties.of_triangles, format);
}

bool HeldProperties::hold(const Property& property) const {
  if (&property == vertex_label || &property == triangle_label) return true;
  const std::array<const Numbers*, 4> lists = all();
  return std::any_of(lists.begin(), lists.end(), [&](const Numbers* numbers) {
    return std::find(numbers->begin(), numbers->end(), &property) != numbers->end();
  });
}

bool are_bytes(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](const Property* p) {
    return std::holds_alternative<std::vector<std::uint8_t>>(p->values);
  });
}

}  // namespace geolloyd
