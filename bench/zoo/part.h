#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/mesh.h"
#include "geolloyd/quality.h"

namespace geolloyd::zoo {

/// From end to end.
using Segment = std::array<Vec3, 2>;

/// Of 40 degrees: edges that turn by more are sharp.
inline constexpr double sharp_cosine = 0.7660444431189780;

/// An edge at which a solid turns by more than that.
struct SharpEdge {
  Segment ends;
  std::array<Vec3, 2> into;  ///< across the two faces beside it, of length 1
};

/// What a generator makes: a closed mesh, and what it knows of it without looking at the mesh.
struct Solid {
  Mesh mesh;
  double volume = 0;
  std::vector<PartTopology> parts;      ///< ascending
  std::vector<std::vector<Vec3>> rims;  ///< round edges, each a closed line
};

/// What is true of a part however it is triangulated.
struct Truth {
  double volume = 0;
  std::vector<PartTopology> parts;      ///< ascending
  std::vector<std::vector<Vec3>> rims;  ///< round edges, each a closed line
  std::vector<SharpEdge> sharp;
  double forced_angle = 60;  ///< degrees: no mesh that keeps the sharp edges has a larger smallest
                             ///< angle
};

/// A mesh as users have one, whose truth is known.
struct Part {
  std::string name;
  std::string kind;
  Mesh mesh;
  Truth truth;
  bool is_soft = false;   ///< has no features, whatever its triangles look like
  bool is_split = false;  ///< vertices are there several times, as files have them
};

/// Of shapes without features.
inline constexpr const char* soft_kind = "soft shape";

/// Finds the sharp edges of a solid that is triangulated without any noise.
Part part_of(std::string name, std::string kind, Solid solid);
/// The same for a shape without features.
Part soft_part_of(std::string name, Solid solid);

}  // namespace geolloyd::zoo
