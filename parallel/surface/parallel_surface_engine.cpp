#include "parallel/surface/parallel_surface_engine.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/loops.h"
#include "core/surface/cells/cell_pieces.h"
#include "core/surface/cells/nearest_label.h"
#include "parallel/surface/atomic_bits.h"
#include "parallel/surface/shared_moments.h"

namespace geolloyd {
namespace {

struct LabelChange {
  VertexId vertex;
  RegionId label;
};

// A vertex whose label cannot change until its site and the rival have travelled so far in sum, or
// not much farther: there is one for each vertex, and so it is small.
struct Sleeper {
  RegionId rival = no_id;  // none: the vertex is awake
  float until = 0;
};

float rounded_down(double x) {
  const auto rounded = static_cast<float>(x);
  return rounded <= x ? rounded : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

template <class Measure>
class ParallelSurfaceEngine final : public SurfaceEngine {
 public:
  ParallelSurfaceEngine(const FineMesh& mesh, Executor& executor)
      : mesh_(mesh),
        executor_(executor),
        unit_(moment_unit(mesh)),
        border_vertices_(mesh.vertex_count()),
        border_triangles_(mesh.triangle_count()),
        queued_(mesh.vertex_count()),
        changed_(mesh.vertex_count()) {}

  void assign(std::vector<RegionId> labels, std::span<const std::uint8_t> is_fixed) override {
    if (!std::ranges::equal(is_fixed, is_fixed_)) main_.clear();
    is_fixed_.assign(is_fixed.begin(), is_fixed.end());
    given_.clear();
    (main_.empty() ? labels_ : given_) = std::move(labels);
  }

  const Cells& evaluate(std::span<const Vec3> sites) override {
    if (main_.size() > sites.size() || are_many_given()) {
      if (!given_.empty()) labels_ = std::move(given_);
      main_.clear();
    }
    if (main_.empty()) {
      begin(sites);
    } else {
      add_sites(sites);
      take_given();
    }
    given_.clear();
    travel_to(sites);
    sweep_all(sites);
    update_triangles();
    measure(sites);
    return cells_;
  }

  [[nodiscard]] const std::vector<RegionId>& labels() const override { return labels_; }
  [[nodiscard]] const Cells& cells() const override { return cells_; }

 private:
  using Sum = typename Measure::Sum;

  static constexpr std::size_t grain = 32;  // words of 64 bits

  // Calls visit(begin, end, worker) for ranges of words.
  template <class Visit>
  void for_each_range(AtomicBits& bits, Visit&& visit) {
    parallel_for_ranges(executor_, bits.words(), grain, visit);
  }
  template <class Visit>
  void for_each_bit(AtomicBits& bits, Visit&& visit) {
    for_each_range(bits, [&](std::size_t begin, std::size_t end, std::size_t worker) {
      bits.for_each(begin, end, [&](std::size_t i) { visit(i, worker); });
    });
  }

  void begin(std::span<const Vec3> sites) {
    main_.assign(sites.size(), {});
    before_.assign(sites.begin(), sites.end());
    travelled_.assign(sites.size(), 0);
    sleeper_.assign(mesh_.vertex_count(), {});
    main_site_.resize(mesh_.triangle_count());
    border_triangles_.clear();
    border_vertices_.clear();
    changed_.clear();
    parallel_for_ranges(
        executor_, mesh_.triangle_count(), small_items,
        [&](std::size_t begin, std::size_t end, std::size_t) { begin_triangles(begin, end); });
    parallel_for(executor_, mesh_.vertex_count(), small_items, [&](std::size_t v) {
      if (is_on_border(static_cast<VertexId>(v))) border_vertices_.set(v);
    });
  }

  [[nodiscard]] bool is_on_border(VertexId v) const {
    const auto neighbours = mesh_.neighbours(v);
    return std::any_of(neighbours.begin(), neighbours.end(),
                       [&](VertexId u) { return labels_[u] != labels_[v]; });
  }

  // Runs of triangles with one main site, which are long in spatial order, are added as one.
  void begin_triangles(std::size_t begin, std::size_t end) {
    Sum run;
    RegionId of = no_id;
    for (auto t = static_cast<TriangleId>(begin); t < end; ++t) {
      const RegionId site = main_site(mesh_, t, labels_);
      main_site_[t] = site;
      if (is_cut(t)) border_triangles_.set(t);
      if (site == no_id) continue;
      if (site != of) {
        if (of != no_id) add_shared(main_[of], run);
        run = {};
        of = site;
      }
      run += moments_of<Measure>(mesh_, unit_, t);
    }
    if (of != no_id) add_shared(main_[of], run);
  }

  [[nodiscard]] bool is_cut(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return labels_[a] != labels_[b] || labels_[b] != labels_[c];
  }

  // So many differ, as where sites have other numbers now, that it is quicker to begin anew.
  [[nodiscard]] bool are_many_given() const {
    std::size_t differing = 0;
    for (std::size_t v = 0; v < given_.size(); ++v) differing += given_[v] != labels_[v] ? 1 : 0;
    return differing > given_.size() / 16;
  }

  void add_sites(std::span<const Vec3> sites) {
    main_.resize(sites.size());
    travelled_.resize(sites.size(), 0);
    before_.insert(before_.end(), sites.begin() + static_cast<std::ptrdiff_t>(before_.size()),
                   sites.end());
  }

  // The given labels, as if a sweep had changed those that differ.
  void take_given() {
    for (VertexId v = 0; v < given_.size(); ++v) {
      if (given_[v] == labels_[v]) continue;
      labels_[v] = given_[v];
      changed_.set(v);
      wake(v);
      for (const VertexId u : mesh_.neighbours(v)) wake(u);
    }
  }
  void wake(VertexId v) {
    border_vertices_.set(v);
    sleeper_[v].rival = no_id;
  }

  void travel_to(std::span<const Vec3> sites) {
    parallel_for(executor_, sites.size(), small_items, [&](std::size_t r) {
      travelled_[r] += norm(sites[r] - before_[r]);
      before_[r] = sites[r];
    });
  }

  void sweep_all(std::span<const Vec3> sites) {
    changes_.resize(executor_.threads());
    for_each_bit(border_vertices_, [&](std::size_t v, std::size_t worker) {
      if (is_asleep(static_cast<VertexId>(v))) return;
      if (look_at(static_cast<VertexId>(v), sites, changes_[worker])) border_vertices_.reset(v);
    });
    while (apply_changes()) {
      parallel_for_ranges(executor_, queue_.size(), 256,
                          [&](std::size_t begin, std::size_t end, std::size_t worker) {
                            for (std::size_t i = begin; i < end; ++i) {
                              queued_.reset(queue_[i]);
                              look_at(queue_[i], sites, changes_[worker]);
                            }
                          });
    }
  }

  // Whether the vertex is not on a border, and so cannot change until it is one.
  bool look_at(VertexId v, std::span<const Vec3> sites, std::vector<LabelChange>& changes) {
    if (is_fixed_[v] != 0) return true;
    const NearestLabel nearest = nearest_label(mesh_, labels_, sites, v);
    if (nearest.label != labels_[v]) changes.push_back({v, nearest.label});
    let_sleep(v, nearest);
    return nearest.is_inner;
  }

  // A vertex between two sites keeps its label until they have moved by as much as its own is
  // nearer, or the label of a neighbour changes, which wakes it. In a metric no way is longer than
  // the root of its trace times what it is otherwise. The margin is far above what distances, below
  // 4, and the sums of ways are rounded by.
  void let_sleep(VertexId v, const NearestLabel& nearest) {
    constexpr double margin = 1e-9;
    Sleeper& sleeper = sleeper_[v];
    sleeper.rival = nearest.label == labels_[v] ? nearest.rival : no_id;
    if (sleeper.rival == no_id) return;
    double lead = std::sqrt(nearest.square_rival) - std::sqrt(nearest.square_own);
    if (!mesh_.metric.empty()) lead /= std::sqrt(mesh_.metric[v].trace());
    sleeper.until =
        rounded_down(travelled_[nearest.label] + travelled_[nearest.rival] + lead - margin);
  }
  [[nodiscard]] bool is_asleep(VertexId v) const {
    const Sleeper& sleeper = sleeper_[v];
    return sleeper.rival != no_id &&
           travelled_[labels_[v]] + travelled_[sleeper.rival] < sleeper.until;
  }

  // Whose label may change next: the changed ones and their neighbours.
  bool apply_changes() {
    queue_.clear();
    for (std::vector<LabelChange>& changes : changes_) {
      for (const auto& [v, label] : changes) {
        labels_[v] = label;
        changed_.set(v);
        queue_up(v);
        for (const VertexId u : mesh_.neighbours(v)) queue_up(u);
      }
      changes.clear();
    }
    return !queue_.empty();
  }

  void queue_up(VertexId v) {
    border_vertices_.set(v);
    if (!queued_.set(v)) queue_.push_back(v);
  }

  void update_triangles() {
    for_each_bit(changed_, [&](std::size_t v, std::size_t) {
      for (const TriangleId t : mesh_.triangles_at(static_cast<VertexId>(v))) update(t);
    });
    changed_.clear();
  }

  void update(TriangleId t) {
    if (is_cut(t)) {
      border_triangles_.set(t);
    } else {
      border_triangles_.reset(t);
    }
    const RegionId site = main_site(mesh_, t, labels_);
    const RegionId old = std::atomic_ref(main_site_[t]).exchange(site, std::memory_order_relaxed);
    if (old == site) return;
    const Sum moments = moments_of<Measure>(mesh_, unit_, t);
    if (old != no_id) add_shared(main_[old], Sum{} - moments);
    if (site != no_id) add_shared(main_[site], moments);
  }

  void measure(std::span<const Vec3> sites) {
    of_worker_.resize(executor_.threads());
    std::vector<std::uint8_t> is_used(executor_.threads(), 0);
    for_each_range(border_triangles_, [&](std::size_t begin, std::size_t end, std::size_t worker) {
      std::vector<Sum>& cells = of_worker_[worker];
      if (is_used[worker] == 0) cells.assign(sites.size(), {});
      is_used[worker] = 1;
      border_triangles_.for_each(begin, end, [&](std::size_t t) {
        const RegionId main = main_site_[t];
        for_each_piece<Measure>(mesh_, unit_, static_cast<TriangleId>(t), labels_, sites,
                                [&](RegionId r, const Sum& piece) {
                                  cells[r] += piece;
                                  cells[main] -= piece;
                                });
      });
    });
    std::vector<Sum> sums = main_;
    for (std::size_t worker = 0; worker < is_used.size(); ++worker) {
      if (is_used[worker] == 0) continue;
      parallel_for(executor_, sums.size(), small_items,
                   [&](std::size_t r) { sums[r] += of_worker_[worker][r]; });
    }
    cells_.assign(sums);
  }

  const FineMesh& mesh_;
  Executor& executor_;
  MomentUnit unit_;
  std::vector<RegionId> labels_;
  std::vector<RegionId> given_;  // assigned since the last evaluation; empty: none
  std::vector<std::uint8_t> is_fixed_;
  std::vector<RegionId> main_site_;  // per triangle
  std::vector<Sum> main_;            // per site: of whole triangles of which it is the main one;
                                     // empty: all is to begin anew
  Cells cells_;
  std::vector<std::vector<Sum>> of_worker_;  // what pieces change
  std::vector<Vec3> before_;                 // per site: where it was
  std::vector<double> travelled_;  // per site: the length of its way, since the engine began
  std::vector<Sleeper> sleeper_;   // per vertex
  AtomicBits border_vertices_;
  AtomicBits border_triangles_;
  AtomicBits queued_;
  AtomicBits changed_;
  std::vector<VertexId> queue_;
  std::vector<std::vector<LabelChange>> changes_;  // per worker
};

}  // namespace

std::unique_ptr<SurfaceEngine> make_parallel_surface_engine(const FineMesh& mesh,
                                                            Executor& executor) {
  if (mesh.metric.empty()) {
    return std::make_unique<ParallelSurfaceEngine<EvenMeasure>>(mesh, executor);
  }
  return std::make_unique<ParallelSurfaceEngine<MetricMeasure>>(mesh, executor);
}

}  // namespace geolloyd
