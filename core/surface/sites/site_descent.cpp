#include "core/surface/sites/site_descent.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "core/base/loops.h"

namespace geolloyd {
namespace {

using Vectors = std::vector<Vec3>;

// Ranges of fixed size, added in their order: the same bits on any number of threads.
template <class Term>
double ordered_sum(Executor& executor, std::size_t count, Term&& term) {
  std::vector<double> of_range(count / small_items + 1, 0);
  parallel_for_ranges(executor, count, small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        double sum = 0;
                        for (std::size_t i = begin; i < end; ++i) sum += term(i);
                        of_range[begin / small_items] = sum;
                      });
  double sum = 0;
  for (const double part : of_range) sum += part;
  return sum;
}

// Where the descent stands.
struct State {
  Vectors sites;
  Vectors gradient;
  Cells cells;
  double energy = 0;
};

// A step that was taken, and how the gradient changed by it.
struct StepPair {
  Vectors step;
  Vectors change;
  double curvature;  // step . change, positive
};

class Descent {
 public:
  Descent(const FineMesh& mesh, SurfaceEngine& engine, std::size_t site_count,
          const DescentOptions& options, Executor& executor)
      : mesh_(mesh),
        engine_(engine),
        options_(options),
        executor_(executor),
        site_count_(site_count) {}

  double run(Vectors& sites) {
    constexpr std::size_t window = 10;
    State now = evaluate(std::move(sites));
    double before = now.energy;
    for (std::size_t i = 0; i < options_.most_iterations; ++i) {
      if (i > 0 && i % window == 0) {
        if (before - now.energy < options_.least_gain * before) break;
        before = now.energy;
      }
      State next;
      if (!step_from(now, next)) break;
      remember(now, next);
      now = std::move(next);
      if (options_.keep_going && !options_.keep_going(now.energy, now.sites)) break;
    }
    sites = std::move(now.sites);
    return now.energy;
  }

 private:
  State evaluate(Vectors sites) {
    State state{std::move(sites), {}, {}, 0};
    state.cells = engine_.evaluate(state.sites);
    const CellEnergies energies(mesh_, state.cells);
    const std::size_t count = state.sites.size();
    state.gradient.assign(count, Vec3::Zero());
    state.energy = ordered_sum(executor_, count, [&](std::size_t i) {
      const Vec3& site = state.sites[i];
      if (energies.area(i) > 0 && options_.is_fixed[i] == 0) {
        state.gradient[i] = energies.gradient(i, site);
      }
      return energies.at(i, site);
    });
    return state;
  }

  // False where no step lowers the energy.
  bool step_from(const State& now, State& next) {
    while (true) {
      const Vectors direction = limited(now, downhill(now));
      const double slope = sum_of_dots(direction, now.gradient);
      if (slope < 0 && search_line(now, direction, slope, next)) return true;
      if (pairs_.empty()) return false;
      pairs_.clear();
    }
  }

  bool search_line(const State& now, const Vectors& direction, double slope, State& next) {
    constexpr double sufficient = 1e-4;
    constexpr double shorter = 0.4;
    constexpr int attempts = 6;
    double length = 1;
    for (int i = 0; i < attempts; ++i, length *= shorter) {
      Vectors sites(now.sites.size());
      for_sites([&](std::size_t s) { sites[s] = now.sites[s] + length * direction[s]; });
      next = evaluate(std::move(sites));
      if (next.energy <= now.energy + sufficient * length * slope) return true;
    }
    next = evaluate(now.sites);
    return false;
  }

  // Minus the inverse Hessian, as far as the pairs know it, times the gradient.
  [[nodiscard]] Vectors downhill(const State& now) {
    Vectors q = now.gradient;
    std::vector<double> factor;
    for (const StepPair& pair : pairs_) {
      const double f = sum_of_dots(pair.step, q) / pair.curvature;
      factor.push_back(f);
      for_sites([&](std::size_t i) { q[i] -= f * pair.change[i]; });
    }
    const CellEnergies energies(mesh_, now.cells);
    for_sites([&](std::size_t i) { q[i] = energies.newton_step(i, q[i]); });
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      const StepPair& pair = pairs_[k];
      const double f = factor[k] + sum_of_dots(pair.change, q) / pair.curvature;
      for_sites([&](std::size_t i) { q[i] -= f * pair.step[i]; });
    }
    return q;
  }

  [[nodiscard]] Vectors limited(const State& now, Vectors direction) {
    const CellEnergies energies(mesh_, now.cells);
    for_sites([&](std::size_t i) {
      const double length = energies.mean_length(i, direction[i]);
      const double longest = options_.inverse_sizing.empty()
                                 ? options_.longest_move
                                 : options_.longest_move / options_.inverse_sizing[i];
      if (options_.is_fixed[i] != 0) {
        direction[i].setZero();
      } else if (length > longest) {
        direction[i] *= longest / length;
      }
    });
    return direction;
  }

  void remember(const State& now, const State& next) {
    constexpr std::size_t most_pairs = 7;
    StepPair pair{Vectors(now.sites.size()), Vectors(now.sites.size()), 0};
    for_sites([&](std::size_t i) {
      pair.step[i] = next.sites[i] - now.sites[i];
      pair.change[i] = next.gradient[i] - now.gradient[i];
    });
    pair.curvature = sum_of_dots(pair.step, pair.change);
    if (!(pair.curvature > 0)) return;
    pairs_.push_front(std::move(pair));
    if (pairs_.size() > most_pairs) pairs_.pop_back();
  }

  [[nodiscard]] double sum_of_dots(const Vectors& a, const Vectors& b) {
    return ordered_sum(executor_, a.size(), [&](std::size_t i) { return dot(a[i], b[i]); });
  }

  template <class Visit>
  void for_sites(Visit&& visit) {
    parallel_for(executor_, site_count_, small_items, visit);
  }

  const FineMesh& mesh_;
  SurfaceEngine& engine_;
  const DescentOptions& options_;
  Executor& executor_;
  std::size_t site_count_;
  std::deque<StepPair> pairs_;  // the latest first
};

}  // namespace

double descend(const FineMesh& mesh, SurfaceEngine& engine, std::vector<Vec3>& sites,
               const DescentOptions& options, Executor& executor) {
  return Descent(mesh, engine, sites.size(), options, executor).run(sites);
}

}  // namespace geolloyd
