#include "core/regions/dual_place_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <tuple>

#include "core/mesh/mesh_measure.h"

namespace geolloyd {
namespace {

constexpr double least_flatness_of_a_place = 0.01;
constexpr double no_flatness = 1e-6;  // in one line, but for rounding

std::array<double, 3> as_key(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

// Something with a number, and the region it belongs to.
using OfRegion = std::pair<RegionId, std::uint32_t>;

std::span<const OfRegion> of_region(const std::vector<OfRegion>& ascending, RegionId r) {
  const auto first = std::lower_bound(ascending.begin(), ascending.end(), OfRegion{r, 0});
  const auto last = std::upper_bound(first, ascending.end(), OfRegion{r, no_id});
  return {first, last};
}

// A triangle without area or turned over, and a place of several vertices, weigh more than all
// triangles that are merely low.
constexpr std::ptrdiff_t grave = 1 << 20;

// What is wrong at a vertex.
struct Flaws {
  std::ptrdiff_t weight = 0;
  double flattest = std::numeric_limits<double>::max();
};

// A vertex that goes elsewhere. The smaller move is the better one.
struct PlaceMove {
  std::ptrdiff_t more_weight = 0;
  bool leaves_turn = false;
  double flattest = 0;
  RegionId region = no_id;
  Vec3 to = Vec3::Zero();

  [[nodiscard]] bool is_better_than(const PlaceMove& other) const {
    return std::tuple(more_weight, leaves_turn, -flattest) <
           std::tuple(other.more_weight, other.leaves_turn, -other.flattest);
  }
};

class PlaceRepair {
 public:
  PlaceRepair(const Mesh& mesh, const RegionSurface& surface, const DualMesh& dual,
              const PlaceChoices& choices, std::vector<Vec3>& place)
      : mesh_(mesh), surface_(surface), dual_(dual), choices_(choices), place_(place) {}

  void run() {
    constexpr int most_passes = 8;
    find_taken();
    for (int pass = 0; pass < most_passes; ++pass) {
      bool has_moved = false;
      for (const RegionId r : regions_in_one_place()) has_moved |= move_one_of({&r, 1});
      for (std::size_t t = 0; t < dual_.triangles.size(); ++t) {
        if (is_to_mend(t)) has_moved |= move_one_of(dual_.triangles[t]);
      }
      if (!has_moved) return;
    }
  }

 private:
  void find_taken() {
    std::vector<std::array<double, 3>> keys;
    for (const Vec3& p : place_) keys.push_back(as_key(p));
    std::sort(keys.begin(), keys.end());
    for (const auto& key : keys) ++taken_.emplace_hint(taken_.end(), key, 0)->second;
    for (std::uint32_t t = 0; t < dual_.triangles.size(); ++t) {
      for (const RegionId r : dual_.triangles[t]) triangles_at_.emplace_back(r, t);
    }
    std::sort(triangles_at_.begin(), triangles_at_.end());
  }

  [[nodiscard]] std::vector<RegionId> regions_in_one_place() const {
    std::vector<RegionId> found;
    for (auto r = static_cast<RegionId>(place_.size()); r-- > 0;) {
      if (is_shared(place_[r])) found.push_back(r);
    }
    return found;
  }

  [[nodiscard]] bool is_shared(const Vec3& p) const { return taken_.at(as_key(p)) > 1; }

  [[nodiscard]] bool is_all_outer(std::size_t t) const {
    const Triangle& regions = dual_.triangles[t];
    return std::all_of(regions.begin(), regions.end(),
                       [this](RegionId r) { return choices_.is_outer[r] != 0; });
  }

  [[nodiscard]] bool is_to_mend(std::size_t t) const {
    const double flat = flatness_of(t);
    return std::abs(flat) < no_flatness || (flat < least_flatness_of_a_place && is_all_outer(t));
  }

  [[nodiscard]] double flatness_of(std::size_t t) const {
    return signed_flatness(mesh_, surface_, dual_, t, place_);
  }

  [[nodiscard]] Flaws flaws_at(RegionId r) const {
    Flaws flaws;
    if (is_shared(place_[r])) flaws.weight += grave;
    for (const auto& [region, triangle] : of_region(triangles_at_, r)) {
      const double flat = flatness_of(triangle);
      if (flat < least_flatness_of_a_place) flaws.weight += flat < no_flatness ? grave : 1;
      flaws.flattest = std::min(flaws.flattest, flat);
    }
    return flaws;
  }

  // Around a vertex of very many triangles, as where all regions meet at a hub of the mesh, each of
  // them would try all places, and look at all triangles for each.
  [[nodiscard]] bool can_move(RegionId r) const {
    constexpr std::size_t most_triangles = 256;
    return of_region(triangles_at_, r).size() <= most_triangles;
  }

  void put(RegionId r, const Vec3& p) {
    const auto old = taken_.find(as_key(place_[r]));
    if (--old->second == 0) taken_.erase(old);
    ++taken_[as_key(p)];
    place_[r] = p;
  }

  void try_move(RegionId r, const Vec3& to, PlaceMove& best) {
    const Vec3 from = place_[r];
    const Flaws before = flaws_at(r);
    put(r, to);
    const Flaws after = flaws_at(r);
    put(r, from);
    const PlaceMove move{after.weight - before.weight, choices_.is_at_turn[r] != 0, after.flattest,
                         r, to};
    if (move.is_better_than(best)) best = move;
  }

  // Moves one of the vertices to where fewer flaws are left by it, if there is such a place.
  bool move_one_of(std::span<const RegionId> all) {
    PlaceMove best;
    std::vector<RegionId> regions;
    std::copy_if(all.begin(), all.end(), std::back_inserter(regions),
                 [this](RegionId r) { return can_move(r); });
    for (const RegionId r : regions) {
      try_move(r, choices_.site[r], best);
      for (const auto& [region, v] : of_region(choices_.boundary, r)) {
        try_move(r, mesh_.positions[v], best);
      }
    }
    if (best.more_weight >= 0) {
      for (const RegionId r : regions) try_points(r, best);
    }
    if (best.more_weight >= 0) return false;
    put(best.region, best.to);
    return true;
  }

  // Points of the region, some of them where there are many.
  void try_points(RegionId r, PlaceMove& best) {
    constexpr std::size_t most_tries = 64;
    if (points_.empty()) {
      for (PointId p = 0; p < surface_.region.size(); ++p) {
        if (surface_.region[p] != no_id) points_.emplace_back(surface_.region[p], p);
      }
      std::sort(points_.begin(), points_.end());
    }
    const auto points = of_region(points_, r);
    const std::size_t step = points.size() / most_tries + 1;
    for (std::size_t i = 0; i < points.size(); i += step) {
      try_move(r, surface_.position(mesh_, points[i].second), best);
    }
  }

  const Mesh& mesh_;
  const RegionSurface& surface_;
  const DualMesh& dual_;
  const PlaceChoices& choices_;
  std::vector<Vec3>& place_;
  std::map<std::array<double, 3>, std::size_t> taken_;  // by how many vertices
  std::vector<OfRegion> triangles_at_;                  // ascending
  std::vector<OfRegion> points_;                        // ascending; found when first asked for
};

}  // namespace

double signed_flatness(const Mesh& mesh, const RegionSurface& surface, const DualMesh& dual,
                       std::size_t triangle, const std::vector<Vec3>& place) {
  const auto& [a, b, c] = dual.triangles[triangle];
  const Triangle& corner = surface.triangles[dual.corner[triangle]];
  const auto at = [&](std::size_t i) { return surface.position(mesh, corner[i]); };
  const double flat = flatness(place[a], place[b], place[c]);
  const Vec3 normal = cross(place[b] - place[a], place[c] - place[a]);
  return dot(normal, cross(at(1) - at(0), at(2) - at(0))) < 0 ? -flat : flat;
}

void repair_places(const Mesh& mesh, const RegionSurface& surface, const DualMesh& dual,
                   const PlaceChoices& choices, std::vector<Vec3>& place) {
  PlaceRepair(mesh, surface, dual, choices, place).run();
}

}  // namespace geolloyd
