#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/graph/mesh_graph.h"
#include "core/lloyd/relaxation.h"
#include "tools/evaluation/statistics.h"
#include "tools/report/report_parts.h"

namespace geolloyd {

/// What is varied in the thesis's experiment (section 6.3), but for the first seeds.
struct Configuration {
  GraphKind graph = GraphKind::vertex;
  std::size_t seeds = 0;
  GreedyMode greedy = GreedyMode::extended;
  bool macrostep_skip = true;
  bool microstep_skip = true;
};

/// The runs of one configuration from several batches of first seeds.
struct BatchRow {
  Configuration configuration;
  std::size_t batches = 0;
  std::size_t converged = 0;
  Statistics seconds;
  Statistics greedy_steps;
  Statistics macrosteps;
  Statistics microsteps;
  Statistics partitions;
  Statistics node_visits;
  Statistics energy;

  void add(const Relaxation& relaxation, double elapsed);
};

Json row_json(const BatchRow& row);

/// Numbers of seeds from a list like "4,16..128,1000", where 16..128 stands for 16, 32, 64, 128;
/// ascending, each once. Throws InvalidInput.
std::vector<std::size_t> seed_ladder(const std::vector<std::string>& items);

}  // namespace geolloyd
