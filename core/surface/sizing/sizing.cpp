#include "core/surface/sizing/sizing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/mesh/mesh_measure.h"
#include "core/surface/sizing/field_metric.h"
#include "core/surface/sizing/growth_limit.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

constexpr double root_3 = 1.7320508075688772;

void check_values(const std::vector<double>& values, const Mesh& mesh, const std::string& what) {
  if (values.size() != mesh.vertex_count()) {
    throw InvalidInput(what + ": " + std::to_string(values.size()) + " values, but the mesh has " +
                       std::to_string(mesh.vertex_count()) + " vertices");
  }
  constexpr double most = 1e75;  // as coordinates
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (values[v] > 1 / most && values[v] < most) continue;
    throw InvalidInput(what + ": vertex " + std::to_string(v) + " has " +
                       std::to_string(values[v]) + ": values are numbers above 0");
  }
}

// x^exponent, of an exponent from 0 to 1, the same on all machines: roots of roots.
double power(double x, double exponent) {
  if (exponent >= 1) return x;
  constexpr int bits = 40;
  double result = 1;
  for (int i = 0; i < bits; ++i) {
    x = std::sqrt(x);
    exponent *= 2;
    if (exponent < 1) continue;
    result *= x;
    exponent -= 1;
  }
  return result;
}

// Lengths per vertex, and what they make of the surface.
class LengthField {
 public:
  LengthField(const Mesh& mesh, const MeshEdges& edges, std::span<const double> wanted,
              double growth, Executor& executor)
      : mesh_(mesh),
        edges_(edges),
        wanted_(wanted),
        growth_(growth),
        executor_(executor),
        area_(triangle_areas(mesh, edges.duplicates, executor)),
        lengths_(wanted.begin(), wanted.end()) {
    measure();
  }

  /// As wanted, times a factor.
  void limit(double factor) {
    lengths_.assign(wanted_.begin(), wanted_.end());
    multiply(factor);
    limit_growth(mesh_, edges_, growth_, lengths_, executor_);
    measure();
  }
  void multiply(double factor) {
    for (double& length : lengths_) length *= factor;
    measure();
  }

  [[nodiscard]] double spacing() const { return std::sqrt(area_sum_ / inverse_squares_); }
  [[nodiscard]] double sites() const { return sites_at(area_sum_, spacing()); }
  /// Where they are shorter, there are more of them.
  [[nodiscard]] double mean_length() const { return inverses_ / inverse_squares_; }
  [[nodiscard]] Sizing take_sizing() {
    const double spacing = this->spacing();
    for (double& length : lengths_) length /= spacing;
    return {spacing, std::move(lengths_)};
  }

 private:
  void measure() {
    area_sum_ = 0;
    inverses_ = 0;
    inverse_squares_ = 0;
    for (TriangleId t = 0; t < mesh_.triangle_count(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const double inverse = (1 / lengths_[a] + 1 / lengths_[b] + 1 / lengths_[c]) / 3;
      area_sum_ += area_[t];
      inverses_ += area_[t] * inverse;
      inverse_squares_ += area_[t] * (inverse * inverse);
    }
  }

  const Mesh& mesh_;
  const MeshEdges& edges_;
  std::span<const double> wanted_;
  double growth_;
  Executor& executor_;
  Buffer<double> area_;  // per triangle
  std::vector<double> lengths_;
  double area_sum_ = 0;
  double inverses_ = 0;  // integral of 1 / length
  double inverse_squares_ = 0;
};

// To limit growth takes lengths away, which a larger factor brings back; that has more growth to
// limit. Two rounds are near enough.
template <class Missing>
void scale_until_enough(LengthField& field, Missing&& missing_factor) {
  constexpr int rounds = 2;
  double factor = 1;
  for (int i = 0; i < rounds; ++i) {
    factor *= missing_factor();
    field.limit(factor);
  }
  field.multiply(missing_factor());
}

Sizing checked(Sizing sizing) {
  const auto [least, most] = std::minmax_element(sizing.sizes.begin(), sizing.sizes.end());
  constexpr double widest = 1000;
  if (*most <= widest * *least) return sizing;
  throw InvalidInput("edge lengths: the longest is " + std::to_string(*most / *least) +
                     " times the shortest; 1000 times is the most");
}

}  // namespace

double spacing_of(double area, double sites) {
  return std::sqrt(2 * area / (root_3 * sites));
}

double sites_at(double area, double spacing) {
  return 2 * area / (root_3 * spacing * spacing);
}

std::size_t expected_sites(double area, double spacing) {
  constexpr double most = 1e9;
  const double count = sites_at(area, spacing);
  if (count < most) return std::max<std::size_t>(4, static_cast<std::size_t>(count));
  std::ostringstream message;
  message << "edge length " << spacing << ": the remesh would have more than 1,000,000,000 "
          << "vertices, because the mesh has an area of " << area;
  throw InvalidInput(message.str());
}

std::vector<double> wanted_lengths(const Mesh& mesh, const SizingOptions& options) {
  const int given = (options.edge_lengths.empty() ? 0 : 1) + (options.densities.empty() ? 0 : 1) +
                    (options.adapt == 0 ? 0 : 1) + (options.equal_error ? 1 : 0);
  if (given > 1) {
    throw InvalidInput("edge_lengths, densities, adapt and equal_error: a remesh has one of them");
  }
  if (!(options.adapt >= 0 && options.adapt <= 2)) {
    throw InvalidInput("adapt: " + std::to_string(options.adapt) + ": it is from 0 to 2");
  }
  if (!(options.growth > 1)) {
    throw InvalidInput("growth: " + std::to_string(options.growth) + ": it is above 1");
  }
  if (!options.edge_lengths.empty()) {
    check_values(options.edge_lengths, mesh, "edge_lengths");
    return options.edge_lengths;
  }
  if (options.densities.empty()) return {};
  check_values(options.densities, mesh, "densities");
  std::vector<double> lengths;
  lengths.reserve(options.densities.size());
  for (const double density : options.densities) {
    lengths.push_back(1 / std::sqrt(std::sqrt(density)));
  }
  return lengths;
}

std::vector<double> lengths_of_curvatures(std::span<const double> curvature, double adapt) {
  constexpr double least = 0.1;
  constexpr double most = 100;
  std::vector<double> lengths;
  lengths.reserve(curvature.size());
  for (const double c : curvature) {
    lengths.push_back(1 / power(std::clamp(c, least, most), adapt / 2));
  }
  return lengths;
}

Sizing find_sizing(const Mesh& mesh, const MeshEdges& edges, std::span<const double> lengths,
                   const RemeshOptions& options, Executor& executor) {
  LengthField field(mesh, edges, lengths, options.sizing.growth, executor);
  if (options.vertex_count > 0) {
    const auto count = static_cast<double>(options.vertex_count);
    scale_until_enough(field, [&] { return std::sqrt(field.sites() / count); });
  } else if (options.edge_length > 0) {
    scale_until_enough(field, [&] { return options.edge_length / field.mean_length(); });
  } else {
    field.limit(1);
  }
  return checked(field.take_sizing());
}

Sizing find_sizing(const Mesh& mesh, const MeshEdges& edges, const RemeshOptions& options,
                   Executor& executor) {
  const SizingOptions& sizing = options.sizing;
  std::vector<double> lengths = wanted_lengths(mesh, sizing);
  if (!lengths.empty()) return find_sizing(mesh, edges, lengths, options, executor);
  if (!options.field.empty() && sizing.adapt == 0) {
    lengths = lengths_of(options.field);
    if (options.vertex_count > 0) return find_sizing(mesh, edges, lengths, options, executor);
    LengthField field(mesh, edges, lengths, sizing.growth, executor);
    field.limit(options.edge_length);
    return checked(field.take_sizing());
  }
  if (options.vertex_count == 0) return {options.edge_length, {}};
  double area = 0;
  for (const double a : triangle_areas(mesh, edges.duplicates, executor)) area += a;
  return {spacing_of(area, static_cast<double>(options.vertex_count)), {}};
}

}  // namespace geolloyd
