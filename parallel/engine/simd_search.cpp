#include "parallel/engine/simd_search.h"

#include <algorithm>
#include <bit>
#include <limits>

// The kernels are compiled twice, for processors with AVX2 and for all, and chosen between when
// they run: a program built here runs everywhere.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(GEOLLOYD_WITHOUT_AVX2)
#define GEOLLOYD_HAS_AVX2 1
#endif
#define GEOLLOYD_INLINE inline __attribute__((always_inline))

namespace geolloyd {
namespace {

constexpr std::size_t lanes = SimdSearch::lanes;
using Vector = SimdSearch::Vector;

// What the kernels work on, as plain pointers.
struct Work {
  const ArcId* first_arc;
  const NodeId* target;
  const std::uint32_t* length;
  const std::uint32_t* mass;
  std::size_t nodes;
  SimdSearch::Lanes* at;  // per node
  NodeId* queue;  // a ring with room for one more than all nodes: each is in it once at most
  std::uint8_t* is_queued;  // per node; all 0 before and after
};

GEOLLOYD_INLINE bool differ(const Vector& a, const Vector& b) {
  using Quarters [[gnu::vector_size(sizeof(Vector))]] = std::uint64_t;
  static_assert(sizeof(Quarters) == 4 * sizeof(std::uint64_t));
  const auto bits = (Quarters)(a ^ b);
  return ((bits[0] | bits[1]) | (bits[2] | bits[3])) != 0;
}

class Ring {
 public:
  GEOLLOYD_INLINE explicit Ring(const Work& work) : work_(work) {}
  GEOLLOYD_INLINE void push(NodeId v) {
    if (work_.is_queued[v] != 0) return;
    work_.is_queued[v] = 1;
    work_.queue[tail_] = v;
    tail_ = tail_ == work_.nodes ? 0 : tail_ + 1;
  }
  [[nodiscard]] GEOLLOYD_INLINE bool empty() const { return head_ == tail_; }
  GEOLLOYD_INLINE NodeId pop() {
    const NodeId v = work_.queue[head_];
    head_ = head_ == work_.nodes ? 0 : head_ + 1;
    work_.is_queued[v] = 0;
    return v;
  }

 private:
  const Work& work_;
  std::size_t head_ = 0;
  std::size_t tail_ = 0;
};

// One pass pulls through all nodes outward, which leaves little to do; what it changed is then
// pushed on until nothing changes.
GEOLLOYD_INLINE void settle_lanes(const Work& w, const NodeId* order) {
  Ring ring(w);
  for (std::size_t i = 0; i < w.nodes; ++i) {
    const NodeId v = order[i];
    const Vector before = w.at[v].d;
    Vector lowest = before;
    for (ArcId a = w.first_arc[v]; a < w.first_arc[v + 1]; ++a) {
      const Vector offered = w.at[w.target[a]].d + w.length[a];
      lowest = offered < lowest ? offered : lowest;
    }
    if (!differ(lowest, before)) continue;
    w.at[v].d = lowest;
    ring.push(v);
  }
  while (!ring.empty()) {
    const NodeId v = ring.pop();
    const Vector from = w.at[v].d;
    for (ArcId a = w.first_arc[v]; a < w.first_arc[v + 1]; ++a) {
      const NodeId u = w.target[a];
      const Vector before = w.at[u].d;
      const Vector offered = from + w.length[a];
      const Vector lowest = offered < before ? offered : before;
      if (!differ(lowest, before)) continue;
      w.at[u].d = lowest;
      ring.push(u);
    }
  }
}

static_assert(2 * (std::uint64_t{most_distance} - 1) <= std::numeric_limits<std::uint32_t>::max(),
              "a distance and the way between two sources fit into a lane");

// distance^2 * mass has up to 94 bits. Its low 32 and its high part are summed apart, the high
// one for `block` nodes at a time, so that neither overflows.
GEOLLOYD_INLINE void add_scores(const Work& w, std::size_t block, Score* scores) {
  for (std::size_t begin = 0; begin < w.nodes; begin += block) {
    const std::size_t end = std::min(begin + block, w.nodes);
    std::uint64_t low[lanes] = {};
    std::uint64_t high[lanes] = {};
    for (std::size_t v = begin; v < end; ++v) {
      const std::uint64_t mass = w.mass[v];
      for (std::size_t j = 0; j < lanes; ++j) {
        const std::uint64_t d = w.at[v].d[j];
        const std::uint64_t squared = d * d;
        const std::uint64_t low_product = (squared & 0xffffffffu) * mass;
        low[j] += low_product & 0xffffffffu;
        high[j] += (squared >> 32) * mass + (low_product >> 32);
      }
    }
    for (std::size_t j = 0; j < lanes; ++j) scores[j] += (Score{high[j]} << 32) + low[j];
  }
}

#ifdef GEOLLOYD_HAS_AVX2
__attribute__((target("avx2"))) void settle_lanes_avx2(const Work& w, const NodeId* order) {
  settle_lanes(w, order);
}
__attribute__((target("avx2"))) void add_scores_avx2(const Work& w, std::size_t block,
                                                     Score* scores) {
  add_scores(w, block, scores);
}
const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
#endif

void settle_lanes_here(const Work& w, const NodeId* order) {
#ifdef GEOLLOYD_HAS_AVX2
  if (has_avx2) {
    settle_lanes_avx2(w, order);
    return;
  }
#endif
  settle_lanes(w, order);
}

void add_scores_here(const Work& w, std::size_t block, Score* scores) {
#ifdef GEOLLOYD_HAS_AVX2
  if (has_avx2) {
    add_scores_avx2(w, block, scores);
    return;
  }
#endif
  add_scores(w, block, scores);
}

// How many nodes' shares of the high part fit into 64 bits.
std::size_t nodes_a_block(const Work& w) {
  std::uint32_t distance_bits = 1;
  std::uint32_t mass_bits = 1;
  for (std::size_t v = 0; v < w.nodes; ++v) {
    for (std::size_t j = 0; j < lanes; ++j) distance_bits |= w.at[v].d[j];
    mass_bits |= w.mass[v];
  }
  const auto product_bits =
      static_cast<int>(2 * std::bit_width(distance_bits) + std::bit_width(mass_bits));
  static_assert(2 * std::bit_width(most_distance - 1) + std::bit_width(most_mass) - 32 + 1 <= 64);
  const int high_bits = std::max(product_bits - 32, 0) + 1;
  return std::size_t{1} << std::clamp(64 - high_bits, 0, 30);
}

}  // namespace

void SimdSearch::run(const Graph& graph, std::span<const NodeId> sources, const Bounds& bounds,
                     std::span<const NodeId> order) {
  const std::size_t nodes = graph.node_count();
  if (is_queued_.size() < nodes) {  // the last to grow
    at_.resize(nodes);
    queue_.resize(nodes + 1);
    is_queued_.resize(nodes, 0);
  }
  const auto last = static_cast<std::uint32_t>(bounds.offset.size() - 1);
  // So high that nothing is higher, so low that adding an arc's length keeps to 32 bits.
  const Vector highest = Vector{} + most_distance;
  for (std::size_t v = 0; v < nodes; ++v) {
    const Vector bound =
        bounds.offset[std::min(bounds.branch_of[v], last)].d + distance_of(bounds.known[v]);
    at_[v].d = bound < highest ? bound : highest;
  }
  for (std::size_t j = 0; j < sources.size(); ++j) at_[sources[j]].d[j] = 0;
  settle_lanes_here({graph.first_arc.data(), graph.target.data(), graph.length.data(),
                     graph.mass.data(), nodes, at_.data(), queue_.data(), is_queued_.data()},
                    order.data());
}

std::array<Score, SimdSearch::lanes> SimdSearch::scores(const Graph& graph) {
  const Work work{graph.first_arc.data(), graph.target.data(), graph.length.data(),
                  graph.mass.data(),      graph.node_count(),  at_.data(),
                  queue_.data(),          is_queued_.data()};
  std::array<Score, lanes> scores{};
  add_scores_here(work, nodes_a_block(work), scores.data());
  return scores;
}

}  // namespace geolloyd
