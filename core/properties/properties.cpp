#include "core/properties/properties.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <set>
#include <type_traits>

#include "core/text/text_cursor.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

void validate(std::span<const Property> properties, std::size_t count, const std::string& what) {
  std::set<std::string_view> names;
  for (const Property& property : properties) {
    const std::string name = "property " + in_quotes(property.name) + " of " + what;
    const bool has_blank = std::any_of(property.name.begin(), property.name.end(),
                                       [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); });
    if (property.name.empty() || has_blank) {
      throw InvalidInput(name + ": a name has no blanks, and is not empty");
    }
    if (!names.insert(property.name).second) {
      throw InvalidInput(name + ": there is another one of this name");
    }
    if (size_of(property) != count) {
      throw InvalidInput(name + ": " + std::to_string(size_of(property)) + " values for " +
                         std::to_string(count));
    }
  }
}

std::vector<Property> pick(const std::vector<Property>& properties,
                           std::span<const std::uint32_t> from) {
  std::vector<Property> picked;
  picked.reserve(properties.size());
  for (const Property& property : properties) {
    picked.push_back({property.name, {}});
    std::visit(
        [&](const auto& values) {
          std::remove_cvref_t<decltype(values)> chosen;
          chosen.reserve(from.size());
          for (const std::uint32_t i : from) chosen.push_back(values[i]);
          picked.back().values = std::move(chosen);
        },
        property.values);
  }
  return picked;
}

}  // namespace

std::size_t size_of(const Property& property) {
  return std::visit([](const auto& values) { return values.size(); }, property.values);
}

std::uint64_t bytes_of(const Properties& properties) {
  std::uint64_t bytes = 0;
  for (const auto* list : {&properties.of_vertices, &properties.of_triangles}) {
    for (const Property& property : *list) {
      bytes += std::visit(
          [](const auto& values) { return std::uint64_t{values.size() * sizeof(values[0])}; },
          property.values);
    }
  }
  return bytes;
}

const char* type_name(const PropertyValues& values) {
  static constexpr std::array<const char*, 8> names = {"char", "uchar", "short", "ushort",
                                                       "int",  "uint",  "float", "double"};
  return names[values.index()];
}

bool has_integers(const Property& property) {
  return std::visit(
      [](const auto& values) {
        return std::is_integral_v<ValueOf<std::remove_cvref_t<decltype(values)>>>;
      },
      property.values);
}

bool is_colour_part(std::string_view name) {
  static constexpr std::array<std::string_view, 7> parts = {"red",       "green", "blue", "alpha",
                                                            "intensity", "grey",  "gray"};
  const std::string_view last = name.substr(name.rfind('_') + 1);
  return std::find(parts.begin(), parts.end(), last) != parts.end();
}

bool is_label(const Property& property) {
  return has_integers(property) && !is_colour_part(property.name);
}

const Property* find_property(std::span<const Property> properties, std::string_view name) {
  for (const Property& property : properties) {
    if (property.name == name) return &property;
  }
  return nullptr;
}

Triple find_triple(std::span<const Property> properties, const std::array<const char*, 3>& names) {
  Triple triple{};
  for (std::size_t i = 0; i < 3; ++i) {
    triple[i] = find_property(properties, names[i]);
    if (triple[i] == nullptr) return {};
  }
  return triple;
}

double value_at(const Property& property, std::size_t i) {
  return std::visit([i](const auto& values) { return static_cast<double>(values[i]); },
                    property.values);
}

double intensity_at(const Property& property, std::size_t i) {
  const double largest = std::visit(
      [](const auto& values) {
        using Limits = std::numeric_limits<ValueOf<std::remove_cvref_t<decltype(values)>>>;
        return Limits::is_integer ? static_cast<double>(Limits::max()) : 1.0;
      },
      property.values);
  return value_at(property, i) / largest;
}

std::span<const Triangle> value_triangles(const Mesh& mesh, const Properties& properties) {
  return properties.corner_values.empty() ? mesh.triangles : properties.corner_values;
}

bool differ(const std::vector<Property>& of_vertices, VertexId a, VertexId b) {
  return std::any_of(of_vertices.begin(), of_vertices.end(), [&](const Property& property) {
    return std::visit(
        [&](const auto& values) {
          // The bits: two NaNs are the same. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
          return std::memcmp(&values[a], &values[b], sizeof(values[a])) != 0;
        },
        property.values);
  });
}

std::string list_names(std::span<const Property> properties) {
  std::string text;
  for (const Property& property : properties) {
    const std::string quoted = in_quotes(property.name);
    text += (text.empty() ? "" : ", ") + quoted.substr(1, quoted.size() - 2);
  }
  return text;
}

Properties follow_origins(const Properties& properties, const Mesh& mesh,
                          std::span<const VertexId> vertex_origin,
                          std::span<const TriangleId> triangle_origin) {
  std::vector<TriangleId> first_at(mesh.vertex_count(), no_id);
  for (std::size_t t = triangle_origin.size(); t-- > 0;) {
    if (triangle_origin[t] == no_id) continue;
    for (const VertexId v : mesh.triangles[t]) first_at[v] = triangle_origin[t];
  }
  std::vector<TriangleId> source(triangle_origin.begin(), triangle_origin.end());
  for (std::size_t t = 0; t < source.size(); ++t) {
    if (source[t] != no_id) continue;
    for (const VertexId v : mesh.triangles[t]) source[t] = std::min(source[t], first_at[v]);
  }
  Properties followed{pick(properties.of_vertices, vertex_origin),
                      pick(properties.of_triangles, source), properties.left_out};
  if (!properties.corner_values.empty()) followed.left_out.emplace_back(one_side_of_seams);
  return followed;
}

void validate(const Properties& properties, const Mesh& mesh) {
  validate(properties.of_vertices, mesh.vertex_count(), "vertices");
  validate(properties.of_triangles, mesh.triangle_count(), "triangles");
  const auto& corners = properties.corner_values;
  if (corners.empty()) return;
  if (corners.size() != mesh.triangle_count()) {
    throw InvalidInput("values of corners: " + std::to_string(corners.size()) + " for " +
                       std::to_string(mesh.triangle_count()) + " triangles");
  }
  for (const auto& corner : corners) {
    if (*std::max_element(corner.begin(), corner.end()) < mesh.vertex_count()) continue;
    throw InvalidInput("values of corners: those of a vertex that the mesh does not have");
  }
}

}  // namespace geolloyd
