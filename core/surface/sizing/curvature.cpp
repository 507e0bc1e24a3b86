#include "core/surface/sizing/curvature.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/loops.h"
#include "core/fields/tangent_plane.h"
#include "core/surface/substrate/coarse_mesh.h"

namespace geolloyd {
namespace {

// The linear map from steps in the tangent plane to changes of the normal that is nearest to those
// of the neighbours: least squares, the shorter the step the heavier.
class ShapeOperator {
 public:
  explicit ShapeOperator(const Vec3& normal) : normal_(normal), axes_(plane_axes(normal)) {}

  /// Normals that face away from each other are those of triangles of opposite orientations.
  void add(const Vec3& step, const Vec3& normal) {
    const Vec3 change = dot(normal, normal_) < 0 ? Vec3(-normal - normal_) : Vec3(normal - normal_);
    const double square = dot(step, step);
    if (!(square > 0)) return;
    const double x = dot(step, axes_.first);
    const double y = dot(step, axes_.second);
    const double along_first = dot(change, axes_.first);
    const double along_second = dot(change, axes_.second);
    xx_ += x * x / square;
    xy_ += x * y / square;
    yy_ += y * y / square;
    first_x_ += along_first * x / square;
    first_y_ += along_first * y / square;
    second_x_ += along_second * x / square;
    second_y_ += along_second * y / square;
  }

  /// Of its square entries, which is that of the squares of the principal curvatures.
  [[nodiscard]] double sum_of_square_curvatures() const {
    constexpr double little = 1e-3;  // where all steps are in one line
    const double xx = xx_ + little * (xx_ + yy_);
    const double yy = yy_ + little * (xx_ + yy_);
    const double determinant = xx * yy - xy_ * xy_;
    if (!(determinant > 0)) return 0;
    const auto square_of_row = [&](double x, double y) {
      const double a = (x * yy - y * xy_) / determinant;
      const double b = (y * xx - x * xy_) / determinant;
      return a * a + b * b;
    };
    return square_of_row(first_x_, first_y_) + square_of_row(second_x_, second_y_);
  }

 private:
  Vec3 normal_;
  PlaneAxes axes_;
  double xx_ = 0;
  double xy_ = 0;
  double yy_ = 0;
  double first_x_ = 0;
  double first_y_ = 0;
  double second_x_ = 0;
  double second_y_ = 0;
};

class CurvatureFinder {
 public:
  CurvatureFinder(const SurfaceInput& input, double spacing, Executor& executor)
      : fine_(input.fine), executor_(executor) {
    constexpr double cell_share = 1.0 / 3;
    std::vector<std::uint32_t> is_on_feature(fine_.vertex_count(), 0);
    for (const auto& edge : input.feature_edges) {
      for (const VertexId v : edge) is_on_feature[v] = 1;
    }
    std::uint8_t level = 0;
    for (; cell_ > cell_share * spacing && level < 21; cell_ /= 2) ++level;
    const std::vector<std::uint8_t> levels(fine_.vertex_count(), level);
    coarse_ = coarsen(fine_, {is_on_feature, levels}, executor);
    knows_.assign(coarse_.mesh.vertex_count(), 1);
    for (VertexId v = 0; v < fine_.vertex_count(); ++v) {
      if (is_on_feature[v] != 0) knows_[coarse_.vertex_of[v]] = 0;
    }
  }

  /// Squares, per vertex of the fine mesh.
  std::vector<double> run() {
    find_normals();
    measure();
    constexpr int rounds = 4;
    for (int i = 0; i < rounds; ++i) smooth();
    std::vector<double> square(fine_.vertex_count());
    parallel_for(executor_, square.size(), small_items,
                 [&](std::size_t v) { square[v] = interpolate(static_cast<VertexId>(v)); });
    return square;
  }

 private:
  void find_normals() {
    normal_.assign(coarse_.mesh.vertex_count(), Vec3::Zero());
    const std::vector<Vec3>& p = fine_.positions;
    for (const auto& [a, b, c] : fine_.triangles) {
      const Vec3 doubled_area = cross(p[b] - p[a], p[c] - p[a]);
      for (const VertexId v : {a, b, c}) normal_[coarse_.vertex_of[v]] += doubled_area;
    }
    for (Vec3& n : normal_) n = normalized(n);
  }

  void measure() {
    square_.assign(normal_.size(), 0);
    for_vertices([&](VertexId v) {
      if (knows_[v] == 0) return;
      ShapeOperator shape(normal_[v]);
      for (const VertexId u : coarse_.mesh.neighbours(v)) {
        if (knows_[u] == 0) continue;
        shape.add(coarse_.mesh.positions[u] - coarse_.mesh.positions[v], normal_[u]);
      }
      square_[v] = shape.sum_of_square_curvatures();
    });
  }

  // Vertices on features take what their neighbours have.
  void smooth() {
    const std::vector<double> before = square_;
    const std::vector<std::uint8_t> knew = knows_;
    for_vertices([&](VertexId v) {
      double sum = 0;
      double count = 0;
      for (const VertexId u : coarse_.mesh.neighbours(v)) {
        if (knew[u] == 0) continue;
        sum += before[u];
        ++count;
      }
      if (count == 0) return;
      square_[v] = knew[v] != 0 ? (before[v] + sum / count) / 2 : sum / count;
      knows_[v] = 1;
    });
  }

  // Of the coarse vertices about a fine one: the nearer, the more.
  [[nodiscard]] double interpolate(VertexId v) const {
    const VertexId own = coarse_.vertex_of[v];
    double sum = 0;
    double weights = 0;
    const auto add = [&](VertexId u) {
      const Vec3 away = coarse_.mesh.positions[u] - fine_.positions[v];
      const double near = 1 / (dot(away, away) + cell_ * cell_ / 4);
      sum += near * near * square_[u];
      weights += near * near;
    };
    add(own);
    for (const VertexId u : coarse_.mesh.neighbours(own)) add(u);
    return sum / weights;
  }

  template <class Visit>
  void for_vertices(Visit&& visit) {
    parallel_for(executor_, normal_.size(), small_items,
                 [&](std::size_t v) { visit(static_cast<VertexId>(v)); });
  }

  const FineMesh& fine_;
  Executor& executor_;
  double cell_ = 2;  // edge of the grid's
  CoarseMesh coarse_;
  std::vector<std::uint8_t> knows_;  // per vertex: whether its curvature is known
  std::vector<Vec3> normal_;
  std::vector<double> square_;
};

}  // namespace

std::vector<double> relative_curvatures(const Mesh& mesh, const SurfaceInput& input, double spacing,
                                        Executor& executor) {
  const FineMesh& fine = input.fine;
  const std::vector<double> square = CurvatureFinder(input, spacing, executor).run();
  std::vector<double> curvature(mesh.vertex_count(), 0);
  std::vector<double> area(mesh.vertex_count(), 0);
  double whole = 0;
  for (TriangleId t = 0; t < fine.triangle_count(); ++t) {
    const auto& [a, b, c] = fine.triangles[t];
    const double of_triangle = fine.area(t);
    const double sum = of_triangle * ((square[a] + square[b] + square[c]) / 3);
    whole += sum;
    for (const VertexId v : mesh.triangles[input.origin[t]]) {
      curvature[v] += sum;
      area[v] += of_triangle;
    }
  }
  const double mean = whole / fine.whole_area;
  constexpr double noise = 1e-14;  // of rounding
  const bool is_flat = !(mean * spacing * spacing > noise);
  for (std::size_t v = 0; v < curvature.size(); ++v) {
    curvature[v] = area[v] > 0 && !is_flat ? std::sqrt(curvature[v] / area[v] / mean) : 1;
  }
  return curvature;
}

}  // namespace geolloyd
