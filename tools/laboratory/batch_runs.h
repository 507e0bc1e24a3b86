#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/graph/mesh_graph.h"
#include "tools/cli/relax_arguments.h"
#include "tools/laboratory/batch.h"
#include "tools/laboratory/experiment.h"
#include "tools/laboratory/first_seeds.h"
#include "tools/laboratory/measured_run.h"
#include "tools/run/input.h"
#include "tools/system/progress.h"

namespace geolloyd {

inline const std::vector<Named<bool>> switch_names = {{"on", true}, {"off", false}};

struct BatchArguments {
  RunRequest start;  // but for the number of seeds and the kind of graph
  RelaxationArguments limits;
  EngineArguments engine;
  ThreadArguments threads;
  std::vector<std::string> seeds;
  std::size_t batches = 3;
  bool together = false;
  std::vector<GraphKind> graphs = {GraphKind::vertex, GraphKind::vertex_dense, GraphKind::triangle,
                                   GraphKind::triangle_dense, GraphKind::mixed};  // the thesis's
  std::vector<GreedyMode> greedy = values_of(greedy_mode_names);
  std::vector<bool> macrostep_skip = values_of(switch_names);
  std::vector<bool> microstep_skip = values_of(switch_names);
  ExperimentOutput output;
};

/// The runs of the thesis's experiment, which share the first seeds of each batch.
class BatchRuns {
 public:
  /// All must live on. Chooses the first seeds of all batches. Throws InvalidInput where a graph
  /// cannot hold so many.
  BatchRuns(const BatchArguments& arguments, std::vector<std::size_t> ladder,
            const LoadedInput& loaded, Scheduler& scheduler, ProgressLine& progress);

  /// Calls `save` with all rows so far after each graph and number of seeds.
  std::vector<BatchRow> run(const std::function<void(const std::vector<BatchRow>&)>& save);

 private:
  void check_ladder() const;
  MeshGraph build_graph(GraphKind kind);
  std::vector<BatchRow> run_from(const MeshGraph& mesh_graph, std::size_t seeds);
  void run_in_turn(std::vector<BatchRow>& rows, const Graph& graph, const FirstSeeds& start,
                   const std::vector<NodeId>& first);
  void run_together(std::vector<BatchRow>& rows, const Graph& graph, const FirstSeeds& start,
                    const std::vector<NodeId>& first);
  MeasuredRun run_one(const Configuration& c, const Graph& graph, const std::vector<NodeId>& first,
                      Scheduler& scheduler, const ProgressCallback& observer) const;

  const BatchArguments& arguments_;
  std::vector<std::size_t> ladder_;
  const LoadedInput& loaded_;
  Scheduler& scheduler_;
  ProgressLine& progress_;
  std::vector<FirstSeeds> starts_;
  std::uint64_t bytes_of_run_ = 0;  // at most
};

}  // namespace geolloyd
