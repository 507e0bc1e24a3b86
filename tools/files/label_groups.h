#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geolloyd/mesh.h"
#include "geolloyd/properties.h"

namespace geolloyd {

/// Per triangle the value of a property of integers: of triangles or, if there is none, of
/// vertices, the majority at its corners, the smallest where they all differ. Throws InvalidInput
/// where the mesh has no such property.
std::vector<std::uint32_t> label_groups(const Mesh& mesh, const Properties& properties,
                                        const std::string& name);

}  // namespace geolloyd
