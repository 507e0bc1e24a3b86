#include "bench/zoo/zoo.h"

#include <utility>

namespace geolloyd::zoo {

Cage cage(const std::string& name, const std::string& kind, std::function<Solid()> make) {
  return {name, [name, kind, make = std::move(make)] { return part_of(name, kind, make()); }};
}

std::vector<Cage> zoo() {
  Cages cages;
  add_plates(cages);
  add_blocks(cages);
  add_turned_parts(cages);
  add_curves(cages);
  add_awkward_files(cages);
  add_soft_shapes(cages);
  return cages;
}

}  // namespace geolloyd::zoo
