#include "core/surface/flips/glide_trial.h"

#include <algorithm>

#include "core/surface/flips/patch_fit.h"

namespace geolloyd {
namespace {

using Region = GlidePatch::Region;
using Side = FlippableTriangles::Side;

class Trial {
 public:
  Trial(const GlidingRemesh& remesh, GlidePatch patch)
      : remesh_(remesh), patch_(std::move(patch)) {}

  std::optional<Glide> run(const FlipPath& path) {
    constexpr std::size_t rings = 2;
    constexpr double price = 1.2;  // of irregularity: in strains of a triangle
    constexpr double hopeless = 3;
    constexpr double hopeless_later = 1;
    constexpr double least_gain = 1e-3;
    std::vector<VertexId> ends;
    for (const auto& edge : path) ends.insert(ends.end(), edge.begin(), edge.end());
    region_ = patch_.region_about(ends, rings);
    if (is_barred()) return {};
    PatchFit before(remesh_, patch_, region_);
    const int irregularity = patch_.irregularity(region_);
    const std::size_t irregular_before = patch_.count_irregular(region_);
    if (!flip(path) || patch_.count_irregular(region_) > irregular_before) return {};
    const double irregular = price * (patch_.irregularity(region_) - irregularity);
    PatchFit after(remesh_, patch_, region_);
    const auto change = [&] { return after.value() - before.value() + irregular; };
    after.relax(iterations);
    if (change() > hopeless) return {};
    relax(after, rounds - 1);
    if (change() > hopeless_later || !is_as_near(before, after) || !is_as_even(before, after)) {
      return {};
    }
    relax(before, rounds);
    if (change() > -least_gain) return {};
    return take_changes(after);
  }

 private:
  static constexpr int rounds = 3;
  static constexpr int iterations = 10;

  [[nodiscard]] bool is_barred() const {
    return std::any_of(region_.vertices.begin(), region_.vertices.end(),
                       [&](VertexId v) { return remesh_.barred[patch_.vertex(v)] != 0; });
  }

  static void relax(PatchFit& fit, int rounds_more) {
    for (int round = 0; round < rounds_more; ++round) fit.relax(iterations);
  }

  // Without a bound, strain that gets much less would pay for any distance. No sample tells how far
  // a vertex is from the surface, so how far it rises is bounded, too.
  [[nodiscard]] bool is_as_near(const PatchFit& before, const PatchFit& after) const {
    constexpr double more = 1;                // strains of a triangle
    constexpr double farther = 1.25;          // times
    constexpr double near_enough = 1.0 / 16;  // of a side
    constexpr double highest = 0.15;          // of a side
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

  bool flip(const FlipPath& path) {
    for (const auto& edge : path) {
      const Side side = patch_.triangles().side_of(edge[0], edge[1]);
      if (!patch_.can_flip(side) || !patch_.is_upright_flipped(side)) return false;
      patch_.flip(side);
      glide_.flips.push_back({patch_.triangle(side.triangle), side.corner});
    }
    return true;
  }

  Glide take_changes(const PatchFit& fit) {
    glide_.positions = fit.positions();
    for (const TriangleId t : region_.triangles) glide_.triangles.push_back(patch_.triangle(t));
    glide_.samples = fit.placed_samples();
    return std::move(glide_);
  }

  const GlidingRemesh& remesh_;
  GlidePatch patch_;
  Region region_;
  Glide glide_;
};

}  // namespace

std::optional<Glide> try_glide(const GlidingRemesh& remesh, GlidePatch patch,
                               const FlipPath& path) {
  return Trial(remesh, std::move(patch)).run(path);
}

}  // namespace geolloyd
