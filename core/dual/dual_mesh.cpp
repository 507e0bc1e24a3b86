#include "core/dual/dual_mesh.h"

#include <algorithm>
#include <compare>
#include <span>
#include <tuple>

#include "core/dual/surface_scan.h"

namespace geolloyd {
namespace {

using Pair = std::array<RegionId, 2>;
using RegionTriple = std::array<RegionId, 3>;

RegionTriple sorted(RegionTriple t) {
  std::sort(t.begin(), t.end());
  return t;
}

// One of the two orders in which a triangle may name three regions.
bool is_even(const Triangle& t) {
  return (t[0] < t[1]) == ((t[1] < t[2]) == (t[0] < t[2]));
}

// A triangle in which three regions meet.
struct Corner {
  RegionTriple regions;  // ascending
  std::uint32_t triangle;

  friend bool operator<(const Corner& a, const Corner& b) {
    return std::tie(a.regions, a.triangle) < std::tie(b.regions, b.triangle);
  }
};

// How two regions meet: the ends are corners, and places on the boundary.
struct Contact {
  Pair regions{};  // ascending
  std::uint32_t ends = 0;
  std::uint32_t outer_ends = 0;

  Contact& operator+=(const Contact& other) {
    ends += other.ends;
    outer_ends += other.outer_ends;
    return *this;
  }

  // A curve with two ends; it comes to the boundary with at most one.
  [[nodiscard]] bool is_simple() const { return ends == 2 && outer_ends <= 1; }
};

// What is known of a region, for its Euler characteristic and for that of its share of the
// boundary; both doubled, as an inner edge counts half from either side.
struct Shape {
  std::int64_t doubled_euler = 0;
  std::int64_t doubled_outer_euler = 0;
  bool has_corner = false;
  bool has_non_manifold_edge = false;  // or an end of one

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
    sort_and_merge();
    collect_triangles();
    find_violations();
    return std::move(dual_);
  }

 private:
  [[nodiscard]] RegionId region(PointId p) const { return surface_.region[p]; }

  void visit_border(std::uint32_t i) {
    const Triangle& t = surface_.triangles[i];
    const RegionTriple r = {region(t[0]), region(t[1]), region(t[2])};
    const bool is_corner = r[0] != r[1] && r[1] != r[2] && r[2] != r[0];
    if (is_corner) corners_.push_back({sorted(r), i});
    for (std::size_t c = 0; c < 3; ++c) {
      const RegionId a = r[c];
      const RegionId b = r[(c + 1) % 3];
      if (a == b) {
        shapes_[a].doubled_euler -= 1;
      } else {
        add_contact({ascending(a, b), is_corner ? 1U : 0U, 0});
      }
    }
  }

  // Most triangles come after another at the same border.
  void add_contact(const Contact& contact) {
    if (contacts_.empty() || contacts_.back().regions != contact.regions) {
      contacts_.push_back(contact);
    } else {
      contacts_.back() += contact;
    }
  }

  // Every edge has been counted half for each of its triangles.
  void visit_irregular_edges() {
    std::vector<VertexId> outer;
    for (const IrregularEdge& edge : surface_.irregular_edges) {
      const RegionId a = region(edge.ends[0]);
      const RegionId b = region(edge.ends[1]);
      const std::int64_t missing = 2 - static_cast<std::int64_t>(edge.triangles);
      if (edge.triangles > 2) {
        shapes_[a].has_non_manifold_edge = shapes_[b].has_non_manifold_edge = true;
      }
      if (edge.triangles == 1) outer.insert(outer.end(), edge.ends.begin(), edge.ends.end());
      if (a == b) {
        shapes_[a].doubled_euler -= missing;
        if (edge.triangles == 1) shapes_[a].doubled_outer_euler -= 2;
      } else if (edge.triangles == 1) {
        add_contact({ascending(a, b), 1, 1});
      }
    }
    std::sort(outer.begin(), outer.end());
    outer.erase(std::unique(outer.begin(), outer.end()), outer.end());
    for (const VertexId v : outer) shapes_[region(v)].doubled_outer_euler += 2;
  }

  // Each contact once.
  void sort_and_merge() {
    std::sort(corners_.begin(), corners_.end());
    std::sort(contacts_.begin(), contacts_.end(),
              [](const Contact& a, const Contact& b) { return a.regions < b.regions; });
    std::size_t kept = 0;
    for (const Contact& contact : contacts_) {
      if (kept == 0 || contacts_[kept - 1].regions != contact.regions) {
        contacts_[kept++] = contact;
      } else {
        contacts_[kept - 1] += contact;
      }
    }
    contacts_.resize(kept);
  }

  // Calls visit(corners) with the corners of each three regions.
  template <class Visit>
  void for_each_triple(Visit&& visit) const {
    for (auto first = corners_.begin(); first != corners_.end();) {
      const auto last = std::find_if(first, corners_.end(), [&](const Corner& corner) {
        return corner.regions != first->regions;
      });
      visit(std::span(first, last));
      first = last;
    }
  }

  void collect_triangles() {
    for_each_triple([this](std::span<const Corner> corners) {
      std::array<std::uint32_t, 2> first = {no_id, no_id};  // of each order
      for (const Corner& corner : corners) {
        std::uint32_t& kept = first[is_even(regions_at(corner.triangle)) ? 1 : 0];
        if (kept == no_id) {
          kept = corner.triangle;
        } else {
          ++dual_.repeated;
        }
      }
      for (const std::uint32_t i : first) {
        if (i == no_id) continue;
        dual_.triangles.push_back(regions_at(i));
        dual_.corner.push_back(i);
      }
      if (first[0] != no_id && first[1] != no_id) ++dual_.back_to_back;
      for (const RegionId r : corners.front().regions) shapes_[r].has_corner = true;
    });
  }

  [[nodiscard]] Triangle regions_at(std::uint32_t i) const {
    const Triangle& t = surface_.triangles[i];
    return {region(t[0]), region(t[1]), region(t[2])};
  }

  void find_violations() {
    for (RegionId r = 0; r < shapes_.size(); ++r) {
      if (!shapes_[r].is_disc()) add(ViolationKind::region, {r, no_id, no_id});
    }
    for (const Contact& contact : contacts_) {
      const auto [a, b] = contact.regions;
      if (!contact.is_simple()) add(ViolationKind::contact, {a, b, no_id});
    }
    for_each_triple([this](std::span<const Corner> corners) {
      if (corners.size() > 1) add(ViolationKind::triple, corners.front().regions);
    });
    for (RegionId r = 0; r < shapes_.size(); ++r) {
      if (!shapes_[r].has_corner) add(ViolationKind::isolation, {r, no_id, no_id});
    }
  }

  void add(ViolationKind kind, const RegionTriple& regions) {
    std::size_t clean = 0;
    for (const RegionId r : regions) {
      if (r != no_id && !shapes_[r].has_non_manifold_edge) ++clean;
    }
    const bool is_of_input = clean == 0 || (kind == ViolationKind::triple && clean == 1);
    dual_.violations.push_back({kind, regions, is_of_input});
  }

  const RegionSurface& surface_;
  std::vector<Shape> shapes_;  // per region
  std::vector<Corner> corners_;
  std::vector<Contact> contacts_;
  DualMesh dual_;
};

}  // namespace

std::size_t count(std::span<const ClosedBallViolation> violations, ViolationKind kind) {
  return static_cast<std::size_t>(
      std::count_if(violations.begin(), violations.end(),
                    [kind](const ClosedBallViolation& v) { return v.kind == kind; }));
}

bool any_removable(std::span<const ClosedBallViolation> violations) {
  return std::any_of(violations.begin(), violations.end(),
                     [](const ClosedBallViolation& v) { return !v.is_of_input; });
}

DualMesh make_dual(const RegionSurface& surface, Executor& executor) {
  return DualBuilder(surface, scan_surface(surface, executor)).run();
}

}  // namespace geolloyd
