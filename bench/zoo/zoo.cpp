#include "bench/zoo/zoo.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace geolloyd::zoo {

Cage cage(const std::string& name, const std::string& kind, std::function<Solid()> make) {
  return {name, kind, [name, kind, make = std::move(make)] { return part_of(name, kind, make()); }};
}

std::vector<Cage> zoo() {
  Cages cages;
  add_plates(cages);
  add_blocks(cages);
  add_turned_parts(cages);
  add_curves(cages);
  add_awkward_files(cages);
  add_soft_shapes(cages);
  std::vector<std::string> kinds;  // as they come
  for (const Cage& cage : cages) {
    if (std::find(kinds.begin(), kinds.end(), cage.kind) == kinds.end()) kinds.push_back(cage.kind);
  }
  const auto rank = [&](const Cage& cage) {
    return std::find(kinds.begin(), kinds.end(), cage.kind) - kinds.begin();
  };
  std::stable_sort(cages.begin(), cages.end(),
                   [&](const Cage& a, const Cage& b) { return rank(a) < rank(b); });
  return cages;
}

}  // namespace geolloyd::zoo
