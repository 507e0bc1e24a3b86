#pragma once

#include "core/seeds/seeds.h"

namespace geolloyd {

/// The greedy phase: left out, or with the standard or the extended heuristic (seed_move.h). The
/// precise phase uses the same heuristic, the extended one where there is no greedy phase.
enum class GreedyMode { off, standard, extended };

/// The mode that suits first seeds chosen in this way. Farthest-point seeds are spread so evenly
/// that a greedy phase takes more time than all the rest and often raises the energy; from the
/// others it lowers the energy (bench/README.md, "When the greedy phase pays").
constexpr GreedyMode suggested_greedy_mode(SeedInit init) {
  return init == SeedInit::farthest ? GreedyMode::off : GreedyMode::extended;
}

}  // namespace geolloyd
