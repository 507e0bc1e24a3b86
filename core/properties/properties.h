#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/mesh/mesh.h"
#include "geolloyd/properties.h"

namespace geolloyd {

/// The number type of a property is T, the element of its vector.
template <class Values>
using ValueOf = typename Values::value_type;

std::size_t size_of(const Property& property);
/// Memory that the values take.
std::uint64_t bytes_of(const Properties& properties);

/// "uchar", as PLY calls it.
const char* type_name(const PropertyValues& values);

bool has_integers(const Property& property);
/// A part of a colour: red, green, blue, alpha, also as the end of a longer name (diffuse_red), or
/// a shade: intensity, grey, gray.
bool is_colour_part(std::string_view name);
/// Integers that are no parts of colours.
bool is_label(const Property& property);

/// The property of this name, or nullptr.
const Property* find_property(std::span<const Property> properties, std::string_view name);

/// Properties that are one vector; each nullptr where one of them is missing.
using Triple = std::array<const Property*, 3>;
Triple find_triple(std::span<const Property> properties, const std::array<const char*, 3>& names);
inline constexpr std::array<const char*, 3> colour_names = {"red", "green", "blue"};
inline constexpr std::array<const char*, 3> normal_names = {"nx", "ny", "nz"};

/// Value i as a double, exactly.
double value_at(const Property& property, std::size_t i);
/// A part of a colour between 0 and 1: integers are shares of the largest of their type.
double intensity_at(const Property& property, std::size_t i);

/// The vertices whose values the corners of triangles have.
std::span<const Triangle> value_triangles(const Mesh& mesh, const Properties& properties);
/// Whether a property of two vertices has not the same bits.
bool differ(const std::vector<Property>& of_vertices, VertexId a, VertexId b);

/// "red, green, blue"; fit for one line, however odd the names are.
std::string list_names(std::span<const Property> properties);

/// What people are told where corner_values come to be values of vertices.
inline constexpr const char* one_side_of_seams =
    "where welded vertices had several values (a seam), those of one side are kept";

/// Those of a mesh made of another one, of which each vertex and triangle was one. A triangle that
/// was none (no_id) has what the first triangle at its corners has.
Properties follow_origins(const Properties& properties, const Mesh& mesh,
                          std::span<const VertexId> vertex_origin,
                          std::span<const TriangleId> triangle_origin);

/// Throws InvalidInput where properties do not fit the mesh, or names are not as they have to be.
void validate(const Properties& properties, const Mesh& mesh);

}  // namespace geolloyd
