#pragma once

#include <cstdint>

#include "bench/zoo/part.h"

// What programs do to a mesh that changes nothing about its shape, or hardly.
namespace geolloyd::zoo {

/// A vertex for each of the directions in which its triangles look, as files with normals have.
Part with_split_vertices(Part part);
/// Three vertices for each triangle.
Part as_soup(Part part);
/// Each triangle beside long edges becomes a fan of so many needles from its corner.
Part with_needles(Part part, std::uint32_t pieces);
/// Each edge of a triangle becomes so many.
Part with_fine_triangles(Part part, std::uint32_t frequency);
/// Turned by a rotation of rational numbers, about none of the axes.
Part turned_aside(Part part);
/// Coordinates as STL has them.
Part with_short_numbers(Part part);

/// Each vertex moved at random by up to so much.
Solid with_noise(Solid solid, double size, std::uint64_t random_seed);

}  // namespace geolloyd::zoo
