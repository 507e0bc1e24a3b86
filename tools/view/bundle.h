#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/mesh/mesh.h"
#include "tools/files/json.h"

namespace geolloyd {

/// Where a viewer has a mesh: its bounding box in the middle of a ball of radius 1, so that float32
/// and 16 bits suffice for meshes of any size, anywhere.
struct Placement {
  Vec3 origin = Vec3::Zero();  ///< mesh units
  double scale = 1;            ///< mesh units per unit of the viewer; above 0

  [[nodiscard]] Vec3 operator()(const Vec3& p) const { return (p - origin) / scale; }
};

Placement placement_of(const Mesh& mesh);

/// A named array of a bundle.
struct BundleArray {
  std::string name;
  std::variant<std::vector<float>, std::vector<std::uint32_t>, std::vector<std::uint16_t>,
               std::vector<std::uint8_t>>
      values;
  std::size_t components = 1;  ///< of an entry: divides the number of values
  std::string per;             ///< "vertex", "triangle" or "both", one after the other: whose
                               ///< entries they are; else empty
  bool is_quantised = false;   ///< 16 bits that stand for -1 to 1
};

/// What the viewer is told at once: named arrays of numbers, and facts about them. Places are those
/// of a placement, other numbers are in mesh units.
struct Bundle {
  std::string title;
  Placement placement;
  std::vector<BundleArray> arrays;
  Json info = Json::object();
  Json frames = Json::array();  ///< the timeline: label, energy, and names of arrays

  /// Three floats for each place.
  void add_places(std::string name, std::span<const Vec3> places, std::string per = "");
  /// Ids below `count`, or no_id: 16 bits each where these suffice, and all ones stand for none.
  void add_ids(std::string name, std::vector<std::uint32_t> ids, std::size_t count,
               std::string per = "");
};

/// Places take 16 bits a coordinate from then on: a step of 1/32767 of the viewer's ball.
void quantise(BundleArray& array);

/// "GLLB", the length of the header, the header as JSON, padded with blanks, and the arrays; each
/// begins at a multiple of 8 bytes. Little endian. What is not UTF-8 gets replacement characters.
std::string encode(const Bundle& bundle);

}  // namespace geolloyd
