#include "tools/laboratory/comparison.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

#include "tools/laboratory/experiment.h"
#include "tools/laboratory/measured_run.h"
#include "tools/system/interrupt.h"
#include "tools/system/memory_limit.h"
#include "tools/words/facts_text.h"

namespace geolloyd {
namespace {

// Keeps nothing large: it would count as memory of the next.
void note(const MeasuredRun& measured, Contender& c, std::uint64_t right) {
  const std::uint64_t fingerprint = measured.relaxation.fingerprint;
  if (c.seconds.empty() || c.fingerprint == right) c.fingerprint = fingerprint;
  c.seconds.insert(std::upper_bound(c.seconds.begin(), c.seconds.end(), measured.seconds),
                   measured.seconds);
  c.peak_memory_bytes = std::max(c.peak_memory_bytes, measured.peak_memory_bytes);
}

bool is_parallel(const Contender& c) {
  return c.engine == EngineKind::parallel;
}

}  // namespace

std::optional<double> Comparison::speedup(const Contender& c) const {
  if (is_parallel(contenders.front())) return {};
  return contenders.front().median() / c.median();
}

std::optional<double> Comparison::efficiency(const Contender& c) const {
  for (const Contender& one : contenders) {
    if (one.engine == c.engine && one.frontier == c.frontier && one.backend == c.backend &&
        one.threads == 1) {
      return one.median() / c.median() / static_cast<double>(c.threads);
    }
  }
  return {};
}

Comparison compare(std::vector<Contender> contenders, std::size_t turns, const Graph& graph,
                   const std::vector<NodeId>& seeds, const RelaxationOptions& options,
                   ProgressLine& progress) {
  Comparison comparison;
  comparison.nodes = graph.node_count();
  for (std::size_t turn = 1; turn <= turns && !interrupted(); ++turn) {
    for (Contender& c : contenders) {
      if (turn > 1 && !is_parallel(c)) continue;
      progress.part(fmt::format("{}, turn {} of {}:", title_of(c), turn, turns));
      make_room_for_threads(c.threads);
      Scheduler scheduler(c.threads, c.backend);
      const auto runtime = make_runtime(c.engine, c.frontier, scheduler);
      const MeasuredRun measured =
          measure_run(graph, seeds, options, watcher(progress, seeds.size()), *runtime);
      if (measured.relaxation.stop_reason == StopReason::interrupted) break;
      if (contenders.front().seconds.empty()) comparison.steps = count_steps(measured.relaxation);
      note(measured, c, contenders.front().fingerprint);
    }
  }
  std::erase_if(contenders, [](const Contender& c) { return c.seconds.empty(); });
  comparison.contenders = std::move(contenders);
  return comparison;
}

std::string title_of(const Contender& c) {
  if (!is_parallel(c)) return "reference";
  return fmt::format("{} {}, {}", name_of(frontier_names, c.frontier),
                     name_of(backend_names, c.backend), counted(c.threads, "thread", "threads"));
}

Json rows_of(const Comparison& comparison) {
  const auto nodes = static_cast<double>(comparison.nodes);
  const auto visits = static_cast<double>(comparison.steps.node_visits);
  Json rows = Json::array();
  for (const Contender& c : comparison.contenders) {
    rows.push_back(
        {{"engine", name_of(engine_names, c.engine)},
         {"frontier", frontier_part(c.engine, c.frontier)},
         {"backend", backend_part(c.engine, c.backend)},
         {"threads", c.threads},
         {"turns", c.seconds.size()},
         {"seconds",
          {{"min", c.seconds.front()}, {"median", c.median()}, {"max", c.seconds.back()}}},
         {"node_visits_per_second", visits / c.median()},
         {"nodes_per_second", nodes / c.median()},
         {"speedup", number_or_null(comparison.speedup(c))},
         {"efficiency", number_or_null(comparison.efficiency(c))},
         {"peak_memory_bytes", c.peak_memory_bytes},
         {"fingerprint", fingerprint_text(c.fingerprint)},
         {"equal", comparison.is_equal(c)}});
  }
  return rows;
}

}  // namespace geolloyd
