// How far arc lengths are from those in a tangent field that is known everywhere, by each way of
// averaging: averaging_error [TRIANGLES] prints a table in Markdown.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/graph/arc_length.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/mesh/tangent_field.h"
#include "core/shapes/shapes.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

constexpr std::size_t usual_triangles = 20'000;
constexpr std::uint64_t random_seed = 1;
constexpr int samples = 64;  // of an edge
constexpr double pi = 3.14159265358979323846;

using Field = std::function<TangentSpace(const Vec3&)>;

TangentSpace at_angle(double angle, double along, double across) {
  return {
      {std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, along, across};
}

struct Case {
  const char* name;
  Field field;  // on the unit square about the origin
};

// `edge` is the mean length of an edge.
std::vector<Case> cases(double edge) {
  const auto turning = [=](double degrees) {
    return [=](const Vec3& p) { return at_angle(p.x() / edge * degrees * pi / 180, 4, 1); };
  };
  const auto angle = [](const Vec3& p) { return std::atan2(p.y(), p.x()); };
  return {
      {"4 : 1, turning by 2° an edge", turning(2)},
      {"4 : 1, turning by 10° an edge", turning(10)},
      {"4 : 1, turning by 30° an edge", turning(30)},
      {"4 : 1, turning by 60° an edge", turning(60)},
      {"one magnitude linear, 1 to 16",
       [](const Vec3& p) { return at_angle(0.3, 1 + 15 * (p.x() + 0.5), 1); }},
      {"one magnitude doubled every 4 edges",
       [=](const Vec3& p) { return at_angle(0.3, std::exp2(p.x() / (4 * edge)), 1); }},
      {"one magnitude 0.4 to 2.5 within 3 edges, turning by 5°",
       [=](const Vec3& p) {
         return at_angle(p.x() / edge * 5 * pi / 180, std::exp2(std::sin(p.x() / edge) * 1.3), 1);
       }},
      {"4 : 1 around a point (index 1)", [=](const Vec3& p) { return at_angle(angle(p), 4, 1); }},
      {"4 : 1, index 1/2", [=](const Vec3& p) { return at_angle(angle(p) / 2, 4, 1); }},
      {"umbilic: 1 : 1 at a point, index 1/2",
       [=](const Vec3& p) {
         const double away = std::min(1.0, 10 * norm(p));
         return at_angle(angle(p) / 2, 1 + 3 * away, 1);
       }},
      {"1 : 1 on half, directions at random, else 4 : 1",
       [=](const Vec3& p) {
         const double turn =
             p.x() < 0 ? random_unit(random_seed, static_cast<std::uint64_t>(1e9 * (p.y() + 1)))
                       : 0.1;
         return at_angle(turn * pi, p.x() < 0 ? 1 : 1 + 3 * std::min(1.0, p.x() / (5 * edge)), 1);
       }},
  };
}

double true_length(const Field& field, const Vec3& a, const Vec3& b) {
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    sum += measure((b - a) / samples, field(a + (b - a) * ((i + 0.5) / samples)), Norm::geodesic);
  }
  return sum;
}

// Of logarithms of ratios to the truth: the root of the mean square, and the largest.
class Errors {
 public:
  void add(double found, double truth) {
    const double error = std::abs(std::log(found / truth));
    squares_ += error * error;
    largest_ = std::max(largest_, error);
    ++count_;
  }
  [[nodiscard]] double rms() const { return 100 * std::sqrt(squares_ / count_); }
  [[nodiscard]] double largest() const { return 100 * largest_; }

 private:
  double squares_ = 0;
  double largest_ = 0;
  double count_ = 0;
};

constexpr std::array ways = {Averaging::pairwise, Averaging::metric};

void print_row(const Case& c, const Mesh& mesh, const MeshEdges& edges) {
  std::vector<TangentSpace> spaces;
  spaces.reserve(mesh.vertex_count());
  for (const Vec3& p : mesh.positions) spaces.push_back(c.field(p));
  std::printf("| %s |", c.name);
  for (const Averaging averaging : ways) {
    Errors of_arcs;
    for (const auto& [a, b] : edges.ends) {
      const Vec3 d = mesh.positions[b] - mesh.positions[a];
      of_arcs.add(measure(d, average(spaces[a], spaces[b], averaging), Norm::geodesic),
                  true_length(c.field, mesh.positions[a], mesh.positions[b]));
    }
    std::printf(" %.2f | %.1f |", of_arcs.rms(), of_arcs.largest());
  }
  for (const Averaging averaging : ways) {
    Errors of_triangles;
    for (TriangleId t = 0; t < mesh.triangle_count(); ++t) {
      const TangentSpace found = triangle_space(mesh.triangles[t], spaces, averaging);
      const TangentSpace truth = c.field(barycentre(mesh, t));
      for (int i = 0; i < 8; ++i) {
        const Vec3 d(std::cos(i * pi / 8), std::sin(i * pi / 8), 0);
        of_triangles.add(measure(d, found, Norm::geodesic), measure(d, truth, Norm::geodesic));
      }
    }
    std::printf(" %.2f | %.1f |", of_triangles.rms(), of_triangles.largest());
  }
  std::printf("\n");
}

void print_table(std::size_t triangles) {
  Mesh mesh = irregular_plane(triangles, random_seed);
  for (Vec3& p : mesh.positions) p -= Vec3(0.5, 0.5, 0);
  const MeshEdges edges = find_edges(mesh);
  double sum = 0;
  for (const auto& [a, b] : edges.ends) sum += norm(mesh.positions[a] - mesh.positions[b]);
  std::printf(
      "| field | arcs, pairwise: RMS | largest | metric: RMS | largest "
      "| triangles, pairwise: RMS | largest | metric: RMS | largest |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const Case& c : cases(sum / static_cast<double>(edges.size()))) print_row(c, mesh, edges);
}

}  // namespace
}  // namespace geolloyd

int main(int argc, char** argv) try {
  std::size_t triangles = geolloyd::usual_triangles;
  if (argc > 1) {
    const std::string_view text = argv[1];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), triangles);
    if (argc > 2 || error != std::errc() || end != text.data() + text.size() || triangles < 100) {
      std::fprintf(stderr, "usage: averaging_error [TRIANGLES], at least 100\n");
      return 2;
    }
  }
  geolloyd::print_table(triangles);
} catch (const std::exception& error) {
  std::fprintf(stderr, "averaging_error: %s\n", error.what());
  return 1;
}
