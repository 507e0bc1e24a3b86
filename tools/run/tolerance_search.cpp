#include "tools/run/tolerance_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geolloyd/errors.h"
#include "tools/evaluation/surface_distance.h"

namespace geolloyd {
namespace {

double distance_of(const LoadedInput& loaded, const Mesh& remesh, Scheduler& scheduler) {
  constexpr std::size_t samples = 200'000;
  return measure_distance(scheduler, loaded.input.mesh(), remesh, samples).two_sided().largest;
}

}  // namespace

ToleranceSearch search_within(double tolerance, std::size_t most, const LoadedInput& loaded,
                              const std::function<TimedRemesh(std::size_t vertices)>& make,
                              Scheduler& scheduler, ProgressLine& progress) {
  constexpr std::size_t first = 500;
  constexpr std::size_t least = 4;
  constexpr double close = 1.05;
  ToleranceSearch search;
  std::size_t too_few = least - 1;
  std::size_t enough = 0;  // 0: none yet
  double nearest = 0;      // of those that are too far
  std::size_t next = std::clamp(first, least, most);
  while (true) {
    TimedRemesh made = make(next);
    progress.stage("measuring the remesh");
    const std::size_t vertices = made.remesh.mesh.vertex_count();
    const bool is_surface = !made.remesh.mesh.triangles.empty();
    const double distance = is_surface ? distance_of(loaded, made.remesh.mesh, scheduler)
                                       : loaded.input.facts.bounding_diagonal;
    search.trials.push_back({vertices, distance});
    const bool is_interrupted = made.remesh.interrupted;
    const bool is_within = distance <= tolerance;
    if (is_within || enough == 0) search.best = std::move(made);
    if (is_interrupted) {
      search.best.remesh.interrupted = true;
      return search;
    }
    if (is_within) {
      enough = next;
    } else {
      too_few = next;
      nearest = distance;
    }
    // Distance falls with the square of edges, so with the number of vertices.
    const double wanted = static_cast<double>(next) * distance / tolerance;
    constexpr double hopeless = 10;
    if (enough == 0 && (next == most || wanted > hopeless * static_cast<double>(most))) {
      throw InvalidInput(fmt::format(
          "--tolerance: the largest distance is {:.3g} with {} vertices, and more than {} are not "
          "tried; give a larger tolerance",
          nearest, next, most));
    }
    const bool is_close = static_cast<double>(enough) <= close * static_cast<double>(too_few) ||
                          enough == too_few + 1;
    if (enough > 0 && is_close) return search;
    // Far from the bounds the middle serves better.
    const auto low = static_cast<double>(too_few);
    const double high = enough > 0 ? static_cast<double>(enough) : 8 * static_cast<double>(next);
    const double guess =
        std::clamp(wanted, low * std::pow(high / low, 0.2), low * std::pow(high / low, 0.8));
    next = std::clamp(static_cast<std::size_t>(std::lround(guess)), too_few + 1,
                      enough > 0 ? enough - 1 : most);
  }
}

}  // namespace geolloyd
