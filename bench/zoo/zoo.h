#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/zoo/part.h"

// Parts of all the kinds that CAD programs, modellers and games write, with what is true of them.
namespace geolloyd::zoo {

struct Cage {
  std::string name;
  std::string kind;
  std::function<Part()> make;
};

/// All of them, by kind. Names differ.
std::vector<Cage> zoo();

// Its rooms.
using Cages = std::vector<Cage>;
void add_plates(Cages& cages);
void add_blocks(Cages& cages);
void add_turned_parts(Cages& cages);
void add_curves(Cages& cages);
void add_awkward_files(Cages& cages);
void add_soft_shapes(Cages& cages);

/// One whose solid is made when it is asked for.
Cage cage(const std::string& name, const std::string& kind, std::function<Solid()> make);

}  // namespace geolloyd::zoo
