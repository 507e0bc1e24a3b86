#include "core/remesh/dual_mesh.h"

#include <algorithm>
#include <map>

#include "core/remesh/surface_scan.h"

namespace geolloyd {
namespace {

using Pair = std::array<RegionId, 2>;
using Triple = std::array<RegionId, 3>;

Triple sorted(Triple t) {
  std::sort(t.begin(), t.end());
  return t;
}

// One of the two orders in which a triangle may name three regions.
bool is_even(const Triangle& t) {
  return (t[0] < t[1]) == ((t[1] < t[2]) == (t[0] < t[2]));
}

// How two regions meet: its ends are corners, and places on the boundary.
struct Contact {
  std::size_t ends = 0;
  std::size_t outer_ends = 0;

  // A curve with two ends; it comes to the boundary with at most one.
  [[nodiscard]] bool is_simple() const { return ends == 2 && outer_ends <= 1; }
};

// What is known of a region, for its Euler characteristic and for that of its share of the
// boundary; both doubled, as an inner edge counts half from either side.
struct Shape {
  std::int64_t doubled_euler = 0;
  std::int64_t doubled_outer_euler = 0;
  bool has_corner = false;

  // Connected it is (RegionSurface), so this is all. Its share of the boundary is nothing, or one
  // curve with ends.
  [[nodiscard]] bool is_disc() const {
    return doubled_euler == 2 && (doubled_outer_euler == 0 || doubled_outer_euler == 2);
  }
};

class DualBuilder {
 public:
  DualBuilder(const RegionSurface& surface, const SurfaceScan& scan)
      : surface_(surface), shapes_(surface.region_count) {
    for (std::size_t r = 0; r < shapes_.size(); ++r) {
      shapes_[r].doubled_euler = scan.doubled_euler[r];
    }
    for (const std::uint32_t i : scan.borders) visit_border(i);
  }

  DualMesh run() {
    visit_irregular_edges();
    collect_triangles();
    find_violations();
    return std::move(dual_);
  }

 private:
  [[nodiscard]] RegionId region(PointId p) const { return surface_.region[p]; }

  void visit_border(std::uint32_t i) {
    const Triangle& t = surface_.triangles[i];
    const Triple r = {region(t[0]), region(t[1]), region(t[2])};
    const bool is_corner = r[0] != r[1] && r[1] != r[2] && r[2] != r[0];
    if (is_corner) corners_[sorted(r)].push_back(i);
    for (std::size_t c = 0; c < 3; ++c) {
      const RegionId a = r[c];
      const RegionId b = r[(c + 1) % 3];
      if (a == b) {
        shapes_[a].doubled_euler -= 1;
      } else {
        contacts_[ascending(a, b)].ends += is_corner ? 1 : 0;
      }
    }
  }

  // Every edge has been counted half for each of its triangles.
  void visit_irregular_edges() {
    std::vector<VertexId> outer;
    for (const IrregularEdge& edge : surface_.irregular_edges) {
      const RegionId a = region(edge.ends[0]);
      const RegionId b = region(edge.ends[1]);
      const std::int64_t missing = 2 - static_cast<std::int64_t>(edge.triangles);
      if (edge.triangles == 1) outer.insert(outer.end(), edge.ends.begin(), edge.ends.end());
      if (a == b) {
        shapes_[a].doubled_euler -= missing;
        if (edge.triangles == 1) shapes_[a].doubled_outer_euler -= 2;
      } else if (edge.triangles == 1) {
        ++contacts_[ascending(a, b)].ends;
        ++contacts_[ascending(a, b)].outer_ends;
      }
    }
    std::sort(outer.begin(), outer.end());
    outer.erase(std::unique(outer.begin(), outer.end()), outer.end());
    for (const VertexId v : outer) shapes_[region(v)].doubled_outer_euler += 2;
  }

  void collect_triangles() {
    for (const auto& [triple, places] : corners_) {
      std::array<std::uint32_t, 2> first = {no_id, no_id};  // of each order
      for (const std::uint32_t i : places) {
        std::uint32_t& kept = first[is_even(regions_at(i)) ? 1 : 0];
        if (kept == no_id) {
          kept = i;
        } else {
          ++dual_.repeated;
        }
      }
      for (const std::uint32_t i : first) {
        if (i == no_id) continue;
        dual_.triangles.push_back(regions_at(i));
        dual_.corner.push_back(i);
      }
      if (first[0] != no_id && first[1] != no_id) ++dual_.folded;
      for (const RegionId r : triple) shapes_[r].has_corner = true;
    }
  }

  [[nodiscard]] Triangle regions_at(std::uint32_t i) const {
    const Triangle& t = surface_.triangles[i];
    return {region(t[0]), region(t[1]), region(t[2])};
  }

  void find_violations() {
    for (RegionId r = 0; r < shapes_.size(); ++r) {
      if (!shapes_[r].is_disc()) add(ViolationKind::region, {r, no_id, no_id});
    }
    for (const auto& [pair, contact] : contacts_) {
      if (!contact.is_simple()) add(ViolationKind::contact, {pair[0], pair[1], no_id});
    }
    for (const auto& [triple, places] : corners_) {
      if (places.size() > 1) add(ViolationKind::triple, triple);
    }
    for (RegionId r = 0; r < shapes_.size(); ++r) {
      if (!shapes_[r].has_corner) add(ViolationKind::isolation, {r, no_id, no_id});
    }
  }

  void add(ViolationKind kind, const Triple& regions) {
    dual_.violations.push_back({kind, regions});
  }

  const RegionSurface& surface_;
  std::vector<Shape> shapes_;  // per region
  std::map<Triple, std::vector<std::uint32_t>> corners_;
  std::map<Pair, Contact> contacts_;
  DualMesh dual_;
};

}  // namespace

std::size_t count(std::span<const ClosedBallViolation> violations, ViolationKind kind) {
  return static_cast<std::size_t>(
      std::count_if(violations.begin(), violations.end(),
                    [kind](const ClosedBallViolation& v) { return v.kind == kind; }));
}

DualMesh make_dual(const RegionSurface& surface, Executor& executor) {
  return DualBuilder(surface, scan_surface(surface, executor)).run();
}

}  // namespace geolloyd
