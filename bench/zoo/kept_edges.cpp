#include "bench/zoo/kept_edges.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_measure.h"
#include "core/surface/creases/edge_angles.h"

namespace geolloyd::zoo {
namespace {

constexpr double near_share = 0.002;            // of the diagonal
constexpr double crease_cosine = 0.9063077870;  // of 25 degrees: a little rounder than the truth
constexpr double most_samples = 3000;

double mean_edge(const Mesh& mesh) {
  double area = 0;
  for (const double a : triangle_areas(mesh, {})) area += a;
  return std::sqrt(4 / std::sqrt(3.0) * area / static_cast<double>(mesh.triangle_count()));
}

double clamped(double share) {
  return std::min(1.0, std::max(0.0, share));
}

double distance_to(const Segment& segment, const Vec3& p) {
  const Vec3 along = segment[1] - segment[0];
  const double square = dot(along, along);
  const double share = square > 0 ? clamped(dot(p - segment[0], along) / square) : 0;
  return norm(p - segment[0] - share * along);
}

// Ericson, Real-Time Collision Detection, 5.1.9.
double distance_between(const Segment& s, const Segment& t) {
  const Vec3 d1 = s[1] - s[0];
  const Vec3 d2 = t[1] - t[0];
  const Vec3 r = s[0] - t[0];
  const double a = dot(d1, d1);
  const double e = dot(d2, d2);
  const double b = dot(d1, d2);
  const double c = dot(d1, r);
  const double f = dot(d2, r);
  const double determinant = a * e - b * b;
  const double first = determinant > 1e-12 * a * e ? clamped((b * f - c * e) / determinant) : 0;
  const double second = clamped((b * first + f) / e);
  return distance_to(s, t[0] + second * d2);
}

double length_of(const Segment& segment) {
  return norm(segment[1] - segment[0]);
}

}  // namespace

KeptEdges::KeptEdges(const Truth& truth, const Mesh& remesh, double diagonal)
    : truth_(truth), near_(near_share * diagonal), spacing_(mean_edge(remesh)) {
  const MeshEdges edges = find_edges(remesh);
  const EdgeAngles angles(remesh, edges);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!angles.is_as_sharp(static_cast<EdgeId>(e), crease_cosine)) continue;
    const auto [a, b] = edges.ends[e];
    creases_.push_back({remesh.positions[a], remesh.positions[b]});
  }
  for (const Sample& sample : samples_of(truth.sharp)) {
    if (is_on_narrow_rim(sample.place) || !is_beside_wide_faces(sample)) continue;
    ++counted_;
    kept_ += has_crease(sample.place) ? 1 : 0;
  }
  count_on_rims(remesh);
}

std::optional<double> KeptEdges::share() const {
  if (counted_ == 0) return std::nullopt;
  return static_cast<double>(kept_) / static_cast<double>(counted_);
}

// Evenly spaced along all of them, as if they were one line.
std::vector<KeptEdges::Sample> KeptEdges::samples_of(const std::vector<SharpEdge>& sharp) const {
  double length = 0;
  for (const SharpEdge& edge : sharp) length += length_of(edge.ends);
  const double step = std::max(near_ / 2, length / most_samples);
  std::vector<Sample> samples;
  double next = step / 2;
  for (const SharpEdge& edge : sharp) {
    const double end = length_of(edge.ends);
    for (; next < end; next += step) {
      samples.push_back({edge.ends[0] + (edge.ends[1] - edge.ends[0]) * (next / end), edge.into});
    }
    next -= end;
  }
  return samples;
}

// No other sharp edge is met within an edge's length on the straight way across either face.
bool KeptEdges::is_beside_wide_faces(const Sample& sample) const {
  constexpr double begin = 0.05;
  constexpr double met = 0.02;
  return std::all_of(sample.into.begin(), sample.into.end(), [&](const Vec3& into) {
    const Segment way = {sample.place + begin * spacing_ * into, sample.place + spacing_ * into};
    return std::none_of(truth_.sharp.begin(), truth_.sharp.end(), [&](const SharpEdge& edge) {
      const Vec3 between = (edge.ends[0] + edge.ends[1] - way[0] - way[1]) / 2;
      const double reach = spacing_ + length_of(edge.ends) / 2;
      return dot(between, between) < reach * reach &&
             distance_between(way, edge.ends) < met * spacing_;
    });
  });
}

bool KeptEdges::is_on_narrow_rim(const Vec3& place) const {
  return std::any_of(truth_.rims.begin(), truth_.rims.end(), [&](const std::vector<Vec3>& rim) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : rim) middle += p / static_cast<double>(rim.size());
    const double radius = norm(rim[0] - middle);
    return 2 * radius < spacing_ && norm(place - middle) < 1.001 * radius;
  });
}

bool KeptEdges::has_crease(const Vec3& place) const {
  return std::any_of(creases_.begin(), creases_.end(),
                     [&](const Segment& crease) { return distance_to(crease, place) <= near_; });
}

void KeptEdges::count_on_rims(const Mesh& remesh) {
  for (const std::vector<Vec3>& rim : truth_.rims) {
    double length = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) length += norm(rim[(i + 1) % rim.size()] - rim[i]);
    if (length < spacing_) continue;
    const double near = length / 60;  // so far off a circle are six edges that are closest to it
    std::size_t count = 0;
    for (const Vec3& p : remesh.positions) {
      bool is_near = false;
      for (std::size_t i = 0; i < rim.size() && !is_near; ++i) {
        is_near = distance_to({rim[i], rim[(i + 1) % rim.size()]}, p) <= near;
      }
      count += is_near ? 1 : 0;
    }
    least_on_rim_ = std::min(count, least_on_rim_.value_or(count));
  }
}

}  // namespace geolloyd::zoo
