#include "tools/evaluation/tolerance_search.h"

#include <algorithm>
#include <utility>

#include "core/base/bounding_box.h"
#include "core/library/heeding_runtime.h"
#include "tools/evaluation/distances/distance_bounds.h"
#include "tools/evaluation/vertex_search.h"

namespace geolloyd {
namespace {

// Of both ways. A remesh without triangles is as far as the mesh is large.
DistanceBounds bounds_between(const Mesh& mesh, const Mesh& remesh, double tolerance,
                              Executor& executor) {
  if (remesh.triangles.empty()) {
    const BoundingBox box = bounding_box(referenced_positions(mesh, executor));
    return {norm(box.extent()), norm(box.extent())};
  }
  return certify_distance(executor, mesh, remesh, tolerance).two_sided();
}

class Searcher {
 public:
  Searcher(double tolerance, RemeshCourse course)
      : tolerance_(tolerance),
        given_(std::move(course)),
        runtime_(given_.runtime, [this] { give_up_if_told(); }),
        search_(tolerance, std::max<std::size_t>(100'000, 4 * given_.mesh.vertex_count())) {}

  ToleranceSearch run() {
    try {
      while (const auto vertices = search_.next()) {
        made_ = geolloyd::run(course_of(*vertices));
        if (made_.remesh.interrupted) throw GivenUp();
        add();
      }
    } catch (const GivenUp&) {
      if (!has_best_) found_.best = std::move(made_);
      found_.best.remesh.interrupted = true;
    }
    found_.trials = search_.trials();
    return std::move(found_);
  }

 private:
  [[nodiscard]] RemeshCourse course_of(std::size_t vertices) {
    RemeshCourse course{given_.mesh,  given_.edges, given_.options,      runtime_,
                        given_.hooks, given_.bytes, given_.release_edges};
    course.options.vertex_count = vertices;
    return course;
  }

  void add() {
    if (given_.hooks.stage) given_.hooks.stage("measuring the remesh");
    const Mesh& remesh = made_.remesh.mesh;
    is_whole_ = true;
    const DistanceBounds bounds =
        bounds_between(given_.mesh, remesh, tolerance_, runtime_.executor());
    if (search_.add({remesh.vertex_count(), bounds.upper, bounds.lower})) {
      found_.best = std::move(made_);
      found_.bounds = bounds;
    }
    has_best_ = true;
  }

  // Before there is a whole remesh, the first one is ended in good order.
  void give_up_if_told() const {
    const auto& keep_going = given_.hooks.keep_going;
    if (is_whole_ && keep_going && !keep_going()) throw GivenUp();
  }

  double tolerance_;
  RemeshCourse given_;
  HeedingRuntime runtime_;
  VertexSearch search_;
  TimedRemesh made_;
  ToleranceSearch found_;
  bool is_whole_ = false;  // one at least
  bool has_best_ = false;
};

}  // namespace

ToleranceSearch search_within(double tolerance, RemeshCourse course) {
  return Searcher(tolerance, std::move(course)).run();
}

}  // namespace geolloyd
