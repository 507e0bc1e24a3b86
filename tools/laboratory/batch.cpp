#include "tools/laboratory/batch.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "geolloyd/errors.h"
#include "tools/words/names.h"
#include "tools/words/numbers.h"

namespace geolloyd {
namespace {

Json statistics_json(const Statistics& values) {
  return {{"min", values.min()}, {"avg", values.mean()}, {"max", values.max()}};
}

std::size_t seed_count(std::string_view text, const std::string& item) {
  const auto count = parse_number<std::size_t>(text);
  if (count && *count > 0) return *count;
  throw InvalidInput("--seeds " + item +
                     ": not a number of seeds; give 1024, or 4..1024 for 4, 8, "
                     "16... 1024");
}

}  // namespace

void BatchRow::add(const Relaxation& relaxation, double elapsed) {
  const StepCounts steps = count_steps(relaxation);
  ++batches;
  converged += relaxation.stop_reason == StopReason::converged ? 1 : 0;
  seconds.add(elapsed);
  greedy_steps.add(static_cast<double>(steps.greedy));
  macrosteps.add(static_cast<double>(steps.macro));
  microsteps.add(static_cast<double>(steps.micro));
  partitions.add(static_cast<double>(steps.partitions));
  node_visits.add(static_cast<double>(steps.node_visits));
  energy.add(relaxation.energy);
}

Json row_json(const BatchRow& row) {
  const Configuration& c = row.configuration;
  return {{"graph", name_of(graph_kind_names, c.graph)},
          {"seeds", c.seeds},
          {"greedy", name_of(greedy_mode_names, c.greedy)},
          {"macrostep_skip", c.macrostep_skip},
          {"microstep_skip", c.microstep_skip},
          {"batches", row.batches},
          {"converged", row.converged},
          {"seconds", statistics_json(row.seconds)},
          {"greedy_steps", statistics_json(row.greedy_steps)},
          {"macrosteps", statistics_json(row.macrosteps)},
          {"microsteps", statistics_json(row.microsteps)},
          {"partitions", statistics_json(row.partitions)},
          {"node_visits", statistics_json(row.node_visits)},
          {"energy", statistics_json(row.energy)}};
}

std::vector<std::size_t> seed_ladder(const std::vector<std::string>& items) {
  std::vector<std::size_t> ladder;
  for (const std::string& item : items) {
    const std::string_view text = item;
    const std::size_t dots = text.find("..");
    const std::size_t first = seed_count(text.substr(0, dots), item);
    const std::size_t last =
        dots == std::string_view::npos ? first : seed_count(text.substr(dots + 2), item);
    if (last < first) throw InvalidInput("--seeds " + item + ": the first number is the larger");
    for (std::size_t k = first; k <= last; k *= 2) {
      ladder.push_back(k);
      if (k > last / 2) break;
    }
  }
  std::sort(ladder.begin(), ladder.end());
  ladder.erase(std::unique(ladder.begin(), ladder.end()), ladder.end());
  return ladder;
}

}  // namespace geolloyd
