#include "core/surface/flips/patch_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/mesh/mesh_quality.h"

namespace geolloyd {

// First those on curves, then others of no place in the region, then those that move.
PatchFit::Part::Part(const GlidingRemesh& of_whole, const GlidePatch& patch,
                     const GlidePatch::Region& region)
    : whole(of_whole) {
  std::vector<std::uint8_t> moves(patch.vertices().size(), 0);
  for (const VertexId v : region.vertices) moves[v] = patch.vertex(v) >= whole.fit.held ? 1 : 0;
  std::vector<VertexId> number_of(patch.vertices().size(), no_id);
  const auto take = [&](auto&& is_one) {
    for (const TriangleId t : region.triangles) {
      for (const VertexId v : patch.triangles()[t]) {
        if (number_of[v] != no_id || !is_one(v)) continue;
        number_of[v] = static_cast<VertexId>(vertex.size());
        vertex.push_back(patch.vertex(v));
        area.push_back(patch.area_at(v));
        remesh.positions.push_back(patch.position(v));
      }
    }
    return vertex.size();
  };
  on_curves = take([&](VertexId v) { return patch.vertex(v) < whole.fit.on_curves; });
  held = take([&](VertexId v) { return moves[v] == 0; });
  take([&](VertexId) { return true; });
  for (const TriangleId t : region.triangles) {
    const auto& [a, b, c] = patch.triangles()[t];
    remesh.triangles.push_back({number_of[a], number_of[b], number_of[c]});
    triangle.push_back(patch.triangle(t));
    take_samples(patch, t);
  }
  remesh.start = remesh.positions;
  remesh.triangles_at = triangles_at_vertices(remesh.vertex_count(), remesh.triangles);
}

// Of the latest triangle.
void PatchFit::Part::take_samples(const GlidePatch& patch, TriangleId t) {
  for (const TriangleId from : patch.samples_from(t)) {
    for (const PlacedSample& placed : whole.on_triangle[from]) {
      const Sample sample = whole.samples[placed.sample];
      samples.add({sample.point, sample.weight, remesh.triangles.back()[0]}, placed.sample);
      on.push_back(static_cast<TriangleId>(triangle.size() - 1));
    }
  }
}

FitSetting PatchFit::Part::setting() const {
  return {on_curves, held, whole.fit.side, area, whole.fit.whole};
}

PatchFit::PatchFit(const GlidingRemesh& whole, const GlidePatch& patch,
                   const GlidePatch::Region& region)
    : part_(whole, patch, region),
      remesh_(part_.remesh),
      projection_(part_.samples, remesh_, sequential()),
      functional_(remesh_, part_.samples, projection_, {}, part_.setting(), sequential()) {
  start_normals_ = normals_at_vertices(remesh_);
  projection_.begin_at(std::move(part_.on));
  projection_.project();
  functional_.set_price(whole.price);
  functional_.begin_round();
}

void PatchFit::relax(int iterations) {
  constexpr double reluctance = 0.02;
  functional_.set_boost(std::vector<double>(remesh_.triangle_count(), 1), reluctance);
  remesh_.positions = functional_.descend({0.3, iterations, 1e-4});
  projection_.project();
  functional_.begin_round();
}

double PatchFit::sharpest_cosine() const {
  double sharpest = -1;
  for (const Triangle& t : remesh_.triangles) {
    sharpest = std::max(sharpest, cosine_of_smallest_angle(corners_of(remesh_, t)));
  }
  return sharpest;
}

double PatchFit::least_cosine() const {
  const std::vector<Vec3> normals = normals_at_vertices(remesh_);
  double least = 1;
  for (TriangleId t = 0; t < remesh_.triangle_count(); ++t) {
    const Vec3 normal = remesh_.normal_of(t);
    for (const VertexId v : remesh_.triangles[t]) {
      if (v >= part_.on_curves) least = std::min(least, dot(normal, normals[v]));
    }
  }
  return least;
}

double PatchFit::largest_square_distance() const {
  double largest = 0;
  for (std::size_t i = 0; i < part_.samples.size(); ++i) {
    largest = std::max(largest, projection_.square_distance(i));
  }
  return largest;
}

double PatchFit::largest_rise() const {
  double largest = 0;
  for (std::size_t v = part_.held; v < remesh_.vertex_count(); ++v) {
    largest = std::max(largest, std::abs(dot(remesh_.move_of(v), start_normals_[v])));
  }
  return largest;
}

std::vector<std::pair<VertexId, Vec3>> PatchFit::positions() const {
  std::vector<std::pair<VertexId, Vec3>> positions;
  for (std::size_t v = 0; v < part_.vertex.size(); ++v) {
    positions.emplace_back(part_.vertex[v], remesh_.positions[v]);
  }
  return positions;
}

std::vector<std::pair<TriangleId, PlacedSample>> PatchFit::placed_samples() const {
  std::vector<std::pair<TriangleId, PlacedSample>> placed;
  for (std::size_t i = 0; i < part_.samples.size(); ++i) {
    placed.push_back({part_.triangle[projection_.triangles()[i]],
                      {part_.samples.id(i), projection_.square_distance(i)}});
  }
  return placed;
}

}  // namespace geolloyd
