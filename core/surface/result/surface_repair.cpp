#include "core/surface/result/surface_repair.h"

#include <algorithm>
#include <utility>

#include "core/base/sorting.h"
#include "core/dual/seed_insertion.h"
#include "core/mesh/mesh_measure.h"
#include "core/surface/cells/cell_labels.h"
#include "core/surface/result/labelled_surface.h"
#include "core/surface/sites/site_balance.h"

namespace geolloyd {
namespace {

constexpr std::size_t first_iterations = 10;
constexpr std::size_t more_iterations = 5;
constexpr std::size_t most_iterations = 60;
constexpr std::size_t vertex_visits = 5'000'000;  // in more than a few iterations
constexpr std::size_t most_rounds = 200;  // of insertions; some dozens are enough for needles
constexpr std::size_t rounds_after_interrupt = 4;
constexpr double least_flatness = 1e-6;  // of a triangle with an area: height over longest edge

enum class Inserted { free, fixed };

class SurfaceRepair {
 public:
  SurfaceRepair(const DividedSurface& surface, RestingSites resting, std::size_t most_sites,
                SiteRelaxer& relaxer, Executor& executor)
      : input_(surface.input),
        curves_(surface.curves),
        budget_(std::move(resting.budget)),
        wanted_(budget_.total()),
        most_sites_(most_sites),
        level_(fine_level(surface)),
        relaxer_(relaxer),
        executor_(executor) {
    result_.state = std::move(resting.state);
  }

  DualisedSites run() {
    relaxer_.relax(level_, result_.state, first_iterations);
    dualise();
    if (has_violations() && insert(Inserted::free)) {
      relaxer_.relax(level_, result_.state, more_iterations);
      dualise();
    }
    insert_until_none();
    if (is_at_limit()) return std::move(result_);
    if (!has_violations() && goes_on_moving()) spread();
    give_triangles_area();
    return std::move(result_);
  }

 private:
  // After a sweep.
  void dualise() {
    take_cells();
    tidy();
    for (int attempt = 0; attempt < 4 && has_site_without_cell() && goes_on_moving(); ++attempt) {
      balance_sites(level_, budget_.free, result_.cells, result_.state.sites, result_.state.labels);
      relaxer_.relax(level_, result_.state, 0);
      take_cells();
      tidy();
    }
    remove_sites_without_cells();
    surface_ = label_surface(input_, curves_, result_.state, executor_);
    result_.dual = make_dual(surface_, executor_);
  }

  void take_cells() { result_.cells = relaxer_.cells(); }

  void tidy() {
    LabelledSites& state = result_.state;
    keep_one_component(*level_.mesh, state.sites.size(), level_.is_on_curve, state.labels,
                       executor_);
    fill_gaps(*level_.mesh, state.sites.positions, state.labels);
    // A patch that its last site has left gets one again.
    for (VertexId v = 0; v < state.labels.size(); ++v) {
      if (state.labels[v] != no_id) continue;
      state.labels[v] = static_cast<RegionId>(state.sites.size());
      state.sites.add(level_.mesh->positions[v], level_.patch[v]);
      result_.cells.add_empty();
      fill_gaps(*level_.mesh, state.sites.positions, state.labels);
    }
  }

  [[nodiscard]] std::vector<std::uint8_t> sites_without_cells() const {
    std::vector<std::uint8_t> is_without(result_.state.sites.size(), 1);
    for (const RegionId r : result_.state.labels) is_without[r] = 0;
    return is_without;
  }
  [[nodiscard]] bool has_site_without_cell() const {
    const std::vector<std::uint8_t> is_without = sites_without_cells();
    return std::find(is_without.begin(), is_without.end(), 1) != is_without.end();
  }

  void remove_sites_without_cells() {
    const std::vector<std::uint8_t> is_removed = sites_without_cells();
    remove_sites(is_removed, result_.state.sites, result_.state.labels);
    result_.cells.remove(is_removed);
  }

  [[nodiscard]] bool is_at_limit() const { return result_.state.sites.size() > most_sites_; }
  [[nodiscard]] bool has_violations() const { return any_removable(result_.dual.violations); }

  // A site that is inserted at another's place loses its cell again. Where no round brings any
  // more, there are other places to try.
  void insert_until_none() {
    constexpr int most_in_vain = 3;
    for (int in_vain = 0;
         has_violations() && !is_at_limit() && in_vain < most_in_vain && goes_on();) {
      const std::ptrdiff_t before = fixed_sites();  // others make room for them
      if (!(in_vain == 0 && insert(Inserted::fixed)) && !insert_in_regions()) return;
      relaxer_.relax(level_, result_.state, 0);
      dualise();
      in_vain = fixed_sites() > before ? 0 : in_vain + 1;
    }
  }
  [[nodiscard]] std::ptrdiff_t fixed_sites() const {
    const std::vector<std::uint8_t>& is_fixed = result_.state.sites.is_fixed;
    return std::count(is_fixed.begin(), is_fixed.end(), std::uint8_t{1});
  }

  bool goes_on_moving() { return relaxer_.ask(result_.state.sites); }

  // An interrupt leaves some rounds, which are enough where there are few violations.
  bool goes_on() {
    if (goes_on_moving()) return ++rounds_ <= most_rounds;
    return ++rounds_after_interrupt_ <= rounds_after_interrupt && ++rounds_ <= most_rounds;
  }

  // Where all places are on curves, and none can have a site: at the vertex of each region that is
  // farthest from its site, beside curves if there is one. False where there is none.
  bool insert_in_regions() {
    const SurfaceSites& sites = result_.state.sites;
    const std::vector<FarthestVertex> beside = farthest_free_vertices();
    const std::vector<FarthestVertex> anywhere =
        farthest_vertices(*level_.mesh, sites.positions, vertices_of_sites(), result_.state.labels);
    std::vector<RegionId> regions = regions_of_violations();
    sort_and_deduplicate(regions);
    std::vector<VertexId> places;
    for (const RegionId r : regions) {
      const FarthestVertex& place = beside[r].square_distance > 0 ? beside[r] : anywhere[r];
      if (place.square_distance > 0) places.push_back(place.vertex);
    }
    const std::size_t before = sites.size();
    for (const VertexId v : places) insert_at(v);
    return sites.size() > before;
  }
  [[nodiscard]] std::vector<FarthestVertex> farthest_free_vertices() const {
    std::vector<std::uint8_t> is_left_out = vertices_of_sites();
    for (std::size_t v = 0; v < is_left_out.size(); ++v) is_left_out[v] |= level_.is_on_curve[v];
    return farthest_vertices(*level_.mesh, result_.state.sites.positions, is_left_out,
                             result_.state.labels);
  }
  // Where a site is, whosever the cell is there: a second one at its place would have none. On
  // curves it would: there several sheets of the surface may have a vertex each.
  [[nodiscard]] std::vector<std::uint8_t> vertices_of_sites() const {
    constexpr auto is_before = [](const Vec3& a, const Vec3& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::vector<Vec3> places = result_.state.sites.positions;
    std::sort(places.begin(), places.end(), is_before);
    std::vector<std::uint8_t> is_of_site;
    for (std::size_t v = 0; v < level_.is_on_curve.size(); ++v) {
      const bool is_place =
          std::binary_search(places.begin(), places.end(), level_.mesh->positions[v], is_before);
      is_of_site.push_back(is_place && level_.is_on_curve[v] == 0 ? 1 : 0);
    }
    return is_of_site;
  }
  // A site that stays there.
  void insert_at(VertexId v) {
    if (level_.is_on_curve[v] != 0) {
      insert_on_curve(v);
    } else {
      insert_fixed(v);
    }
  }
  void insert_fixed(VertexId v) {
    SurfaceSites& sites = result_.state.sites;
    result_.state.labels[v] = static_cast<RegionId>(sites.size());
    sites.add(input_.fine.positions[v], level_.patch[v]);
    sites.is_fixed.back() = 1;
  }

  // Three sites on a straight curve get a further one beside it, two at one place on either side of
  // a slit one on the curve between them. As it was, if violations come back.
  void give_triangles_area() {
    constexpr int rounds = 4;
    for (int round = 0; round < rounds && !has_violations(); ++round) {
      const DualisedSites before = result_;
      if (!insert_at_triangles_without_area()) return;
      relaxer_.relax(level_, result_.state, 0);
      dualise();
      insert_until_none();
      if (has_violations()) result_ = before;
    }
  }

  bool insert_at_triangles_without_area() {
    const std::size_t count = result_.state.sites.size();
    const std::vector<FarthestVertex> farthest = farthest_free_vertices();
    std::vector<std::uint8_t> is_taken(count, 0);
    std::vector<VertexId> places;
    for (const Triangle& t : result_.dual.triangles) {
      if (has_area(t) || is_taken[t[0]] + is_taken[t[1]] + is_taken[t[2]] > 0) continue;
      VertexId place = place_between_twins(t);
      if (place == no_id) place = farthest_place(t, farthest);
      if (place == no_id) place = farthest_from_line(t);
      if (place == no_id) continue;
      places.push_back(place);
      for (const RegionId r : t) is_taken[r] = 1;
    }
    for (const VertexId v : places) insert_at(v);
    return result_.state.sites.size() > count;
  }

  static VertexId farthest_place(const Triangle& t, const std::vector<FarthestVertex>& farthest) {
    const auto best = *std::max_element(t.begin(), t.end(), [&](RegionId a, RegionId b) {
      return farthest[a].square_distance < farthest[b].square_distance;
    });
    return farthest[best].square_distance > 0 ? farthest[best].vertex : no_id;
  }

  // Of the curves in the cells of three sites in a line: the vertex farthest from that line.
  [[nodiscard]] VertexId farthest_from_line(const Triangle& t) const {
    const std::vector<Vec3>& p = result_.state.sites.positions;
    VertexId best = no_id;
    double largest = least_flatness;
    for (const VertexId v : curves_.vertices) {
      const RegionId r = result_.state.labels[v];
      if (std::find(t.begin(), t.end(), r) == t.end()) continue;
      const Vec3& place = input_.fine.positions[v];
      const double flat =
          std::max({flatness(p[t[0]], p[t[1]], place), flatness(p[t[1]], p[t[2]], place),
                    flatness(p[t[2]], p[t[0]], place)});
      if (!(flat > largest)) continue;
      largest = flat;
      best = v;
    }
    return best;
  }

  // Of two sites of a triangle that are at one place on a curve: the vertex of the curve where
  // their cells meet, of several the one that is farthest from its site.
  [[nodiscard]] VertexId place_between_twins(const Triangle& t) const {
    for (std::size_t c = 0; c < 3; ++c) {
      const RegionId a = t[c];
      const RegionId b = t[(c + 1) % 3];
      if (are_twins(a, b, t[(c + 2) % 3])) return meeting_on_curve(a, b);
    }
    return no_id;
  }
  [[nodiscard]] bool are_twins(RegionId a, RegionId b, RegionId other) const {
    constexpr double near = 1e-6;
    const std::vector<Vec3>& p = result_.state.sites.positions;
    return norm(p[a] - p[b]) <= near * norm(p[a] - p[other]);
  }
  [[nodiscard]] VertexId meeting_on_curve(RegionId a, RegionId b) const {
    const std::vector<RegionId>& label = result_.state.labels;
    VertexId best = no_id;
    double farthest = 0;
    for (const VertexId v : curves_.vertices) {
      if (label[v] != a && label[v] != b) continue;
      const RegionId other = label[v] == a ? b : a;
      const auto around = input_.fine.neighbours(v);
      const bool meets = std::any_of(around.begin(), around.end(), [&](VertexId u) {
        return label[u] == other && level_.is_on_curve[u] != 0;
      });
      const Vec3 away = input_.fine.positions[v] - result_.state.sites.positions[label[v]];
      if (!meets || !(dot(away, away) > farthest)) continue;
      farthest = dot(away, away);
      best = v;
    }
    return best;
  }
  [[nodiscard]] bool has_area(const Triangle& t) const {
    const std::vector<Vec3>& p = result_.state.sites.positions;
    return flatness(p[t[0]], p[t[1]], p[t[2]]) > least_flatness;
  }

  // False where there is no place for any.
  bool insert(Inserted how) {
    SurfaceSites& sites = result_.state.sites;
    const std::vector<VertexId> places = insertion_places();
    if (how == Inserted::free) make_room(places.size());
    const std::size_t before = sites.size();
    for (const VertexId v : places) {
      if (level_.is_on_curve[v] != 0) {
        insert_on_curve(v);
      } else {
        result_.state.labels[v] = static_cast<RegionId>(sites.size());
        sites.add(input_.fine.positions[v], level_.patch[v]);
        sites.is_fixed.back() = how == Inserted::fixed ? 1 : 0;
      }
    }
    return sites.size() > before;
  }

  [[nodiscard]] std::vector<VertexId> insertion_places() const {
    std::vector<VertexId> places;
    for (const SeedInsertion& insertion : leave_out_neighbours(
             find_seed_insertions(surface_, result_.dual), result_.state.sites.size())) {
      places.push_back(insertion.point);
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }

  [[nodiscard]] std::vector<RegionId> regions_of_violations() const {
    std::vector<RegionId> regions;
    for (const ClosedBallViolation& violation : result_.dual.violations) {
      for (const RegionId r : violation.regions) {
        if (r != no_id) regions.push_back(r);
      }
    }
    return regions;
  }

  void spread() {
    if (result_.state.sites.size() > wanted_) try_without_surplus();
    if (!has_violations()) try_without_holding();
  }

  // What is left moves until it is evenly spread. As it was, if violations come back even where the
  // sites hardly move.
  void try_without_surplus() {
    for (int ring = 0; ring < 2; ++ring) hold_neighbours();
    const DualisedSites before = result_;
    const std::size_t many =
        std::clamp(vertex_visits / level_.patch.size(), more_iterations, most_iterations);
    for (const std::size_t iterations : {many, more_iterations, std::size_t{1}}) {
      if (!goes_on_moving()) return;
      make_room(0);
      if (result_.state.sites.size() == before.state.sites.size()) return;
      relaxer_.relax(level_, result_.state, iterations);
      dualise();
      if (!has_violations()) return;
      result_ = before;
    }
  }

  // Sites that were held where they were inserted are seldom at rest. As it was, if violations come
  // back.
  void try_without_holding() {
    std::vector<std::uint8_t>& is_fixed = result_.state.sites.is_fixed;
    const auto first_free =
        is_fixed.begin() + static_cast<std::ptrdiff_t>(result_.state.sites.on_curves);
    if (std::count(first_free, is_fixed.end(), 1) == 0) return;
    const DualisedSites before = result_;
    std::fill(first_free, is_fixed.end(), std::uint8_t{0});
    relaxer_.relax(level_, result_.state, more_iterations);
    dualise();
    if (has_violations() || result_.state.sites.size() != before.state.sites.size()) {
      result_ = before;
    }
  }

  // Neighbours of inserted sites that are fixed.
  void hold_neighbours() {
    SurfaceSites& sites = result_.state.sites;
    std::vector<std::uint8_t> is_fixed = sites.is_fixed;
    const auto is_held = [&](RegionId r) { return r >= sites.on_curves && sites.is_fixed[r] != 0; };
    for (const Triangle& t : result_.dual.triangles) {
      if (!std::any_of(t.begin(), t.end(), is_held)) continue;
      for (const RegionId r : t) is_fixed[r] = 1;
    }
    sites.is_fixed = std::move(is_fixed);
  }

  // Removes sites of least energy so that with `count` more there are as many as wanted: free ones
  // that no violation concerns, in patches with many. A patch keeps two thirds of its sites: from
  // there on there are more than wanted.
  void make_room(std::size_t count) {
    SurfaceSites& sites = result_.state.sites;
    if (sites.size() + count <= wanted_) return;
    constexpr std::size_t few = 16;
    const auto least_in = [&](PatchId p) { return std::max(few, 2 * budget_.free[p] / 3); };
    std::vector<std::size_t> of_patch(budget_.free.size(), 0);
    for (std::size_t r = sites.on_curves; r < sites.size(); ++r) ++of_patch[sites.patch[r]];
    std::vector<std::uint8_t> is_needed = sites.is_fixed;
    for (const RegionId r : regions_of_violations()) is_needed[r] = 1;
    const CellEnergies energies(input_.fine, result_.cells);
    std::vector<std::pair<double, RegionId>> by_energy;
    for (RegionId r = 0; r < sites.size(); ++r) {
      if (is_needed[r] != 0 || of_patch[sites.patch[r]] <= least_in(sites.patch[r])) continue;
      by_energy.emplace_back(energies.at(r, sites.positions[r]), r);
    }
    std::sort(by_energy.begin(), by_energy.end());
    std::vector<std::uint8_t> is_removed(sites.size(), 0);
    std::size_t left = sites.size() + count - wanted_;
    for (const auto& [energy, r] : by_energy) {
      if (left == 0) break;
      if (of_patch[sites.patch[r]] <= least_in(sites.patch[r])) continue;
      is_removed[r] = 1;
      --of_patch[sites.patch[r]];
      --left;
    }
    remove_sites(is_removed, sites, result_.state.labels);
  }

  // A site on a curve, with that vertex alone there.
  void insert_on_curve(VertexId v) {
    LabelledSites& state = result_.state;
    const RegionId old = state.labels[v];
    if (count_curve_vertices(old) < 2) return;
    const auto added = static_cast<RegionId>(state.sites.on_curves);
    const auto at = static_cast<std::ptrdiff_t>(added);
    state.sites.positions.insert(state.sites.positions.begin() + at, input_.fine.positions[v]);
    state.sites.patch.insert(state.sites.patch.begin() + at, no_id);
    state.sites.is_fixed.insert(state.sites.is_fixed.begin() + at, 1);
    ++state.sites.on_curves;
    for (RegionId& label : state.labels) {
      if (label != no_id && label >= added) ++label;
    }
    state.labels[v] = added;
  }

  [[nodiscard]] std::size_t count_curve_vertices(RegionId r) const {
    return static_cast<std::size_t>(
        std::count_if(curves_.vertices.begin(), curves_.vertices.end(),
                      [&](VertexId v) { return result_.state.labels[v] == r; }));
  }

  const SurfaceInput& input_;
  const FeatureCurves& curves_;
  SiteBudget budget_;
  std::size_t wanted_;
  std::size_t most_sites_;
  LevelMesh level_;
  SiteRelaxer& relaxer_;
  Executor& executor_;
  DualisedSites result_;
  RegionSurface surface_;
  std::size_t rounds_ = 0;
  std::size_t rounds_after_interrupt_ = 0;
};

}  // namespace

DualisedSites repair_dual(const DividedSurface& surface, RestingSites resting,
                          std::size_t most_sites, SiteRelaxer& relaxer, Executor& executor) {
  return SurfaceRepair(surface, std::move(resting), most_sites, relaxer, executor).run();
}

}  // namespace geolloyd
