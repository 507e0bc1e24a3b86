#pragma once

// What the writers of mesh files share; not for users of the library.

#include <array>
#include <span>
#include <vector>

#include "core/formats/mesh_formats.h"
#include "core/properties/properties.h"

namespace geolloyd {

/// Numbers that stand in a row.
using Numbers = std::vector<const Property*>;

/// What a format other than PLY has a place for; each empty where it is missing.
struct HeldProperties {
  Numbers colours;  ///< of vertices: red, green, blue, perhaps alpha
  Numbers normals;  ///< of vertices
  Numbers texture;  ///< of vertices
  Numbers triangle_colours;
  const Property* vertex_label = nullptr;    ///< "ref"
  const Property* triangle_label = nullptr;  ///< "ref", "physical", "entity" or "region"

  HeldProperties(MeshFormat format, const Properties& properties);

  [[nodiscard]] bool hold(const Property& property) const;

 private:
  [[nodiscard]] std::array<const Numbers*, 4> all() const {
    return {&colours, &normals, &texture, &triangle_colours};
  }
};

/// That all numbers of a colour are bytes.
bool are_bytes(const Numbers& numbers);

}  // namespace geolloyd
