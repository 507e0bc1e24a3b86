#include "core/surface/fit/curve_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/segment.h"
#include "core/surface/fit/chain_system.h"

namespace geolloyd {

CurveChain::CurveChain(const FineMesh& mesh, const FeatureCurve& curve,
                       std::span<const RegionId> labels, const std::vector<Vec3>& remesh_positions)
    : is_loop_(curve.is_loop) {
  std::vector<std::size_t> place;
  add_vertices(curve, labels, place);
  is_held_.assign(vertices_.size(), 0);
  for (const VertexId v : vertices_) start_.push_back(remesh_positions[v]);
  positions_ = start_;
  if (vertices_.size() < 3) return;  // nothing that could move
  add_samples(mesh, curve, place);
  find_feet();
  largest_allowed_ = largest_square();
}

// `place`: per vertex of the curve, that of its label.
void CurveChain::add_vertices(const FeatureCurve& curve, std::span<const RegionId> labels,
                              std::vector<std::size_t>& place) {
  for (const VertexId v : curve.vertices) {
    if (vertices_.empty() || vertices_.back() != labels[v]) vertices_.push_back(labels[v]);
    place.push_back(vertices_.size() - 1);
  }
  if (!is_loop_ || vertices_.size() < 2 || vertices_.front() != vertices_.back()) return;
  vertices_.pop_back();
  std::replace(place.begin(), place.end(), vertices_.size(), std::size_t{0});
}

// Weights are those of the trapezoidal rule.
void CurveChain::add_samples(const FineMesh& mesh, const FeatureCurve& curve,
                             const std::vector<std::size_t>& place) {
  constexpr double samples_per_edge = 8;
  double length = 0;
  for (std::size_t i = 0; i < edges(); ++i) length += edge_length(i);
  const double step = length / (samples_per_edge * static_cast<double>(edges()));
  for (std::size_t e = 0; e + 1 < curve.vertices.size(); ++e) {
    const Vec3& a = mesh.positions[curve.vertices[e]];
    const Vec3& b = mesh.positions[curve.vertices[e + 1]];
    const auto pieces = static_cast<std::size_t>(std::max(1.0, std::ceil(norm(b - a) / step)));
    const double weight = norm(b - a) / static_cast<double>(pieces);
    for (std::size_t k = 0; k <= pieces; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(pieces);
      const std::size_t near = std::min(place[2 * k < pieces ? e : e + 1], edges() - 1);
      const bool is_end = k == 0 || k == pieces;
      samples_.push_back({a + (b - a) * share, is_end ? weight / 2 : weight, near});
    }
  }
}

void CurveChain::fit() {
  constexpr double stiff = 1;
  constexpr double slack = 0.03;
  constexpr double good_difference = 0.75;
  if (samples_.empty() || is_straight()) return;
  fit_from_start(stiff);
  const std::vector<Vec3> even = positions_;
  const double squares = sum_of_squares();
  fit_from_start(slack);
  if (sum_of_squares() > good_difference * squares) positions_ = even;
  put_back_far();
}

bool CurveChain::is_straight() const {
  constexpr double straight = 1e-6;  // of the longest edge
  double longest = 0;
  for (std::size_t i = 0; i < edges(); ++i) longest = std::max(longest, edge_length(i));
  return largest_allowed_ <= straight * straight * longest * longest;
}

void CurveChain::fit_from_start(double stiffness) {
  constexpr int rounds = 8;
  positions_ = start_;
  find_feet();
  for (int round = 0; round < rounds; ++round) {
    move_vertices(stiffness);
    find_feet();
  }
}

void CurveChain::move_vertices(double stiffness) {
  std::vector<Vec3> along;
  for (std::size_t i = 0; i < edges(); ++i) {
    along.push_back(normalized(positions_[after(i)] - positions_[i]));
  }
  ChainSystem system(along, vertices_.size(), stiffness);
  for (const Sample& sample : samples_) {
    system.add(sample.edge, sample.share, sample.weight, sample.away);
  }
  const std::vector<Vec3> moves = system.solve(is_held_);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (is_held_[i] == 0) positions_[i] = within_reach(i, positions_[i] + moves[i]);
  }
}

// Not far along the curve from where it was at first: edges along it stay about as long as they
// are.
Vec3 CurveChain::within_reach(std::size_t i, const Vec3& position) const {
  constexpr double share = 0.15;  // of the shorter edge there
  const Vec3 along = normalized(start_[after(i)] - start_[before(i)]);
  const double reach = share * std::min(edge_length(i), edge_length(before(i)));
  const double way = dot(position - start_[i], along);
  return position + (std::clamp(way, -reach, reach) - way) * along;
}

void CurveChain::find_feet() {
  for (Sample& sample : samples_) find_foot(sample);
}

// From edge to edge, as long as the next one is nearer.
void CurveChain::find_foot(Sample& sample) const {
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](std::size_t i) {
    const Vec3& a = positions_[i];
    const Vec3& b = positions_[after(i)];
    const double share = closest_share(sample.point, a, b);
    const Vec3 away = sample.point - (a + share * (b - a));
    if (!(dot(away, away) < least)) return;
    least = dot(away, away);
    sample.edge = i;
    sample.share = share;
    sample.away = away;
  };
  std::size_t from = sample.edge;
  offer(from);
  do {
    from = sample.edge;
    if (is_loop_ || from > 0) offer(before(from));
    if (is_loop_ || from + 1 < edges()) offer(after(from));
  } while (sample.edge != from);
}

double CurveChain::largest_square() const {
  double largest = 0;
  for (const Sample& sample : samples_) largest = std::max(largest, dot(sample.away, sample.away));
  return largest;
}

double CurveChain::sum_of_squares() const {
  double sum = 0;
  for (const Sample& sample : samples_) sum += sample.weight * dot(sample.away, sample.away);
  return sum;
}

bool CurveChain::put_back(std::size_t i) {
  if (positions_[i] == start_[i]) return false;
  positions_[i] = start_[i];
  return true;
}

void CurveChain::put_back_far() {
  bool any = true;
  while (any) {
    any = false;
    find_feet();
    for (const Sample& sample : samples_) {
      if (dot(sample.away, sample.away) <= largest_allowed_) continue;
      any = put_back(sample.edge) || any;
      any = put_back(after(sample.edge)) || any;
    }
  }
}

Vec3 CurveChain::point_near(std::size_t i) const {
  Vec3 nearest = start_[i];
  for (std::size_t k = 0; k + 1 < samples_.size(); ++k) {
    if (samples_[k].edge != i && after(samples_[k].edge) != i) continue;
    const Vec3 p = closest_on_segment(positions_[i], samples_[k].point, samples_[k + 1].point);
    const Vec3 away = p - positions_[i];
    const Vec3 least = nearest - positions_[i];
    if (dot(away, away) < dot(least, least)) nearest = p;
  }
  return nearest;
}

}  // namespace geolloyd
