#pragma once

#include <cstddef>
#include <cstdint>

#include "geolloyd/mesh.h"

namespace geolloyd {

// Generated meshes: inputs for tests, benchmarks and first tries. Each is the smallest of its
// family with at least `triangles` triangles, and the same for the same arguments on every machine:
// coordinates are float32 values, so that writing and reading a mesh changes nothing. Throws
// InvalidInput for 0 triangles, or more than 32-bit ids can count.

/// Unit square in z = 0, a grid whose inner vertices are moved at random, each cell cut along its
/// shorter diagonal. 45,000 triangles make 150 x 150 cells.
Mesh irregular_plane(std::size_t triangles, std::uint64_t random_seed);

/// Unit sphere: each face of the icosahedron in f^2 triangles, projected.
Mesh icosphere(std::size_t triangles);

/// Torus about the z axis, radii 1 and 0.4, irregular as the plane is.
Mesh torus(std::size_t triangles, std::uint64_t random_seed);

/// Open tube about the z axis, radius 1 and height 2, irregular as the plane is.
Mesh cylinder(std::size_t triangles, std::uint64_t random_seed);

/// Unit cube: each face in 2 f^2 triangles.
Mesh cube(std::size_t triangles);

/// A closed animal-like body of genus 0 with legs, neck, head, ears and tail. `random_seed` varies
/// its posture.
Mesh creature(std::size_t triangles, std::uint64_t random_seed);

}  // namespace geolloyd
