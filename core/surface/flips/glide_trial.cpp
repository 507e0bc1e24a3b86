#include "core/surface/flips/glide_trial.h"

#include <algorithm>
#include <initializer_list>

#include "core/surface/flips/patch_fit.h"

namespace geolloyd {
namespace {

using Region = GlidePatch::Region;
using Side = FlippableTriangles::Side;

class Trial {
 public:
  Trial(const GlidingRemesh& remesh, GlidePatch patch, double most)
      : remesh_(remesh), before_(std::move(patch)), patch_(before_), most_(most) {}

  std::optional<Glide> run(const PatchChange& changed) {
    constexpr std::size_t rings = 2;
    constexpr double price = 1.2;  // of irregularity: in strains of a triangle
    constexpr double hopeless = 3;
    constexpr double hopeless_later = 1;
    region_ = before_.region_about(ends_of(changed), rings);
    if (is_barred() || !apply(changed)) return {};
    now_ = patch_.region_now(region_);
    glide_.fewer = static_cast<int>(before_.count_irregular(region_)) -
                   static_cast<int>(patch_.count_irregular(now_));
    if (glide_.fewer < 0) return {};
    const double irregular = price * (patch_.irregularity(now_) - before_.irregularity(region_));
    PatchFit before(remesh_, before_, region_);
    PatchFit after(remesh_, patch_, now_);
    const auto change = [&] { return after.value() - before.value() + irregular; };
    after.relax(iterations);
    if (change() > most_ + hopeless) return {};
    relax(after, rounds - 1);
    if (change() > most_ + hopeless_later || !is_as_near(before, after) ||
        !is_as_even(before, after)) {
      return {};
    }
    relax(before, rounds);
    glide_.change = change();
    if (glide_.change > most_) return {};
    return take_changes(after);
  }

 private:
  static constexpr int rounds = 3;
  static constexpr int iterations = 10;

  // Of the patch before.
  [[nodiscard]] std::vector<VertexId> ends_of(const PatchChange& changed) const {
    std::vector<VertexId> ends;
    const auto add = [&](std::initializer_list<VertexId> vertices) {
      for (const VertexId v : vertices) {
        if (v < before_.vertices().size()) ends.push_back(v);
      }
    };
    const auto& [b, c] = changed.collapse;
    const auto& [v, a, d] = changed.split;
    add({b, c, v, a, d});
    for (const auto& edge : changed.flips) add({edge[0], edge[1]});
    return ends;
  }

  [[nodiscard]] bool is_barred() const {
    return std::any_of(region_.vertices.begin(), region_.vertices.end(),
                       [&](VertexId v) { return remesh_.barred[before_.vertex(v)] != 0; });
  }

  static void relax(PatchFit& fit, int rounds_more) {
    for (int round = 0; round < rounds_more; ++round) fit.relax(iterations);
  }

  // Without a bound, strain that gets much less would pay for any distance. No sample tells how far
  // a vertex is from the surface, so how far it rises is bounded, too.
  [[nodiscard]] bool is_as_near(const PatchFit& before, const PatchFit& after) const {
    constexpr double more = 1;                //  strains of a triangle
    constexpr double farther = 1.25;          //  times
    constexpr double near_enough = 1.0 / 16;  // of a side
    constexpr double highest = 0.15;          //  of a side
    const double near = near_enough * remesh_.fit.side;
    const double here = before.largest_square_distance();
    const double allowed =
        std::max({std::min(farther * farther * here, remesh_.largest_square), here, near * near});
    return after.distances() <= before.distances() + more &&
           after.largest_square_distance() <= allowed &&
           after.largest_rise() <= highest * remesh_.fit.side;
  }

  static bool is_as_even(const PatchFit& before, const PatchFit& after) {
    constexpr double flat = 0.6;
    constexpr double cosine_of_30 = 0.8660254037844386;
    return after.least_cosine() >= std::min(flat, before.least_cosine()) &&
           after.sharpest_cosine() <= std::max(before.sharpest_cosine(), cosine_of_30);
  }

  bool apply(const PatchChange& changed) {
    if (changed.collapses()) {
      const Side side = patch_.triangles().side_of(changed.collapse[0], changed.collapse[1]);
      glide_.gone = patch_.vertex(patch_.triangles().quad_of(side).c);
      patch_.collapse(side);
    }
    if (changed.splits()) {
      patch_.split(changed.split);
      glide_.area_at_new = patch_.area_at(changed.split.vertex);
    }
    return flip(changed.flips);
  }

  bool flip(const FlipPath& path) {
    for (const auto& edge : path) {
      const Side side = patch_.triangles().side_of(edge[0], edge[1]);
      if (!patch_.can_flip(side) || !patch_.is_upright_flipped(side)) return false;
      patch_.flip(side);
    }
    return true;
  }

  Glide take_changes(const PatchFit& fit) {
    glide_.positions = fit.positions();
    const auto add = [&](TriangleId t) {
      Triangle corners = patch_.triangles()[t];
      for (VertexId& v : corners) v = v != no_id ? patch_.vertex(v) : no_id;
      glide_.triangles.push_back({patch_.triangle(t), corners});
    };
    for (const TriangleId t : region_.triangles) {
      if (!patch_.triangles().exists(t)) add(t);
    }
    for (const TriangleId t : now_.triangles) add(t);
    glide_.samples = fit.placed_samples();
    return std::move(glide_);
  }

  const GlidingRemesh& remesh_;
  GlidePatch before_;
  GlidePatch patch_;
  double most_;
  Region region_;  // before
  Region now_;
  Glide glide_;
};

}  // namespace

std::optional<Glide> try_glide(const GlidingRemesh& remesh, GlidePatch patch,
                               const PatchChange& change, double most) {
  return Trial(remesh, std::move(patch), most).run(change);
}

void take_glide(const Glide& glide, GlidingRemesh& remesh) {
  remesh.triangles.replace(glide.triangles);
  for (const auto& [v, position] : glide.positions) remesh.positions[v] = position;
  for (const auto& [t, corners] : glide.triangles) remesh.on_triangle[t].clear();
  for (const auto& [t, sample] : glide.samples) remesh.on_triangle[t].push_back(sample);
}

}  // namespace geolloyd
