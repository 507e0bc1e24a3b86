#include "tools/evaluation/distances/distance_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/bounding_box.h"
#include "core/base/loops.h"
#include "core/mesh/mesh_edges.h"
#include "geolloyd/errors.h"
#include "tools/evaluation/distances/piece_cuts.h"
#include "tools/evaluation/distances/triangle_tree.h"

namespace geolloyd {
namespace {

// What holds for both directions. Lengths are those of the frame.
struct BoundsPlan {
  ExactFrame frame;
  double slack;      // more than all rounding adds up to: each cut rounds coordinates once more
  double tolerance;  // 0: none

  BoundsPlan(const BoundingBox& box, double asked)
      : frame(box),
        slack(1e-12 * norm(box.extent() * frame.scale)),
        tolerance(asked * frame.scale) {}

  // What lower and upper bounds may differ by, less some slack.
  [[nodiscard]] double gap(double lower) const {
    constexpr double share = 0.0099;
    return std::max(share * (tolerance > 0 ? std::max(tolerance, lower) : lower), 4 * slack);
  }
};

BoundingBox box_around(const Mesh& first, const Mesh& second, Executor& executor) {
  GrowingBox box;
  for (const Mesh* mesh : {&first, &second}) {
    const BoundingBox own = bounding_box(
        3 * mesh->triangle_count(),
        [&](std::size_t c) { return mesh->positions[mesh->triangles[c / 3][c % 3]]; }, executor);
    box.add(own.low);
    box.add(own.high);
  }
  return {box.low, box.high};
}

// Of one direction: how far the points of one surface are from another at most. Triangles are cut
// into pieces until each is above one triangle of the other surface, and no corner is farther from
// that than what is allowed beside the farthest corner of all. All that threads find are largest
// values, so the order of their finds is nothing.
class OneWayBounds {
 public:
  OneWayBounds(const Mesh& from, const Mesh& to, const BoundsPlan& plan, Executor& executor)
      : from_(from), tree_(to, plan.frame, executor), plan_(plan), executor_(executor) {}

  DistanceBounds run() {
    try_vertices();
    for (std::size_t next = 0; next < from_.triangle_count() || !open_.empty();) {
      open_.empty() ? take_triangles(next) : cut_some();
      sort_out();
    }
    const double most = std::max(lower_, std::sqrt(rest_));
    const double scale = plan_.frame.scale;
    return {std::max(0.0, lower_ - plan_.slack) / scale,
            (most > 0 ? most + plan_.slack : 0.0) / scale};
  }

 private:
  static constexpr std::size_t batch = 1 << 16;
  static constexpr std::size_t grain = 256;

  [[nodiscard]] Vec3 position(VertexId v) const { return plan_.frame(from_.positions[v]); }

  // The farther of `least` and `p`. A point that is near some triangle needs no more.
  [[nodiscard]] double farther(double least, const Vec3& p, std::uint32_t& near) const {
    const TriangleTree::Found found = tree_.closest({&p, 1}, least * least, near);
    near = found.triangle;
    if (found.square <= least * least) return least;
    return std::max(least, tree_.least_distance(p, std::sqrt(found.square)));
  }

  // Calls body(i, least, near) for i < count, which makes `least` the distance of farther points.
  template <class Body>
  void raise(std::size_t count, Body&& body) {
    std::vector<double> of_worker(executor_.threads(), lower_);
    parallel_for_ranges(executor_, count, grain,
                        [&](std::size_t begin, std::size_t end, std::size_t worker) {
                          std::uint32_t near = 0;
                          for (std::size_t i = begin; i < end; ++i)
                            body(i, of_worker[worker], near);
                        });
    lower_ = *std::max_element(of_worker.begin(), of_worker.end());
  }

  void try_vertices() {
    const std::vector<std::uint8_t> referenced = referenced_vertices(from_, executor_);
    raise(from_.vertex_count(), [&](std::size_t v, double& least, std::uint32_t& near) {
      if (referenced[v] != 0) least = farther(least, position(static_cast<VertexId>(v)), near);
    });
  }

  void take_triangles(std::size_t& next) {
    const std::size_t end = std::min(next + batch, from_.triangle_count());
    for (; next < end; ++next) {
      const auto& [a, b, c] = from_.triangles[next];
      made_.push_back({{position(a), position(b), position(c)}, no_id, 0});
    }
  }

  void cut_some() {
    const std::size_t first = open_.size() - std::min(open_.size(), batch);
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> nears;
    for (std::size_t i = first; i < open_.size(); ++i) {
      cut(open_[i], tree_.triangle(open_[i].near), plan_.slack / 8, made_, corners);
      nears.resize(corners.size(), open_[i].near);
    }
    open_.resize(first);
    raise(corners.size(), [&](std::size_t i, double& least, std::uint32_t&) {
      std::uint32_t near = nears[i];
      least = farther(least, corners[i], near);
    });
  }

  // Leaves those pieces open that are to be cut.
  void sort_out() {
    const double enough = lower_ * lower_;
    const double allowed = lower_ + plan_.gap(lower_);
    std::vector<double> squares(made_.size());
    parallel_for_ranges(
        executor_, made_.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
          std::uint32_t near = 0;
          for (std::size_t i = begin; i < end; ++i) {
            SurfacePiece& piece = made_[i];
            if (piece.near == no_id) piece.near = near;
            const TriangleTree::Found found = tree_.closest(piece.corner, enough, piece.near);
            near = piece.near = found.triangle;
            squares[i] = found.square;
          }
        });
    work_ += made_.size();
    for (std::size_t i = 0; i < made_.size(); ++i) {
      if (squares[i] <= enough) continue;
      const bool is_left = squares[i] <= allowed * allowed || is_cut_enough(made_[i]);
      is_left ? void(rest_ = std::max(rest_, squares[i])) : open_.push_back(made_[i]);
    }
    made_.clear();
  }

  // Two surfaces that are apart by hardly more than rounding could go on for ever.
  [[nodiscard]] bool is_cut_enough(const SurfacePiece& piece) const {
    constexpr std::uint32_t deepest = 100;
    constexpr std::size_t most = 50'000'000;
    return piece.depth >= deepest || work_ >= most + 10 * from_.triangle_count();
  }

  const Mesh& from_;
  TriangleTree tree_;
  const BoundsPlan& plan_;
  Executor& executor_;
  double lower_ = 0;
  double rest_ = 0;       // square: pieces that need no cut are no farther
  std::size_t work_ = 0;  // pieces so far
  std::vector<SurfacePiece> open_;
  std::vector<SurfacePiece> made_;
};

}  // namespace

SurfaceDistanceBounds certify_distance(Executor& executor, const Mesh& first, const Mesh& second,
                                       double tolerance) {
  if (first.triangles.empty() || second.triangles.empty()) {
    throw InvalidInput("a mesh without triangles has no surface");
  }
  const BoundsPlan plan(box_around(first, second, executor), tolerance);
  const auto one_way = [&](const Mesh& from, const Mesh& to) {
    return OneWayBounds(from, to, plan, executor).run();
  };
  return {one_way(first, second), one_way(second, first)};
}

DistanceBounds SurfaceDistanceBounds::two_sided() const {
  return {std::max(from_first.lower, from_second.lower),
          std::max(from_first.upper, from_second.upper)};
}

}  // namespace geolloyd
