#include "core/surface/sites/site_balance.h"

#include <algorithm>

#include "core/surface/cells/cell_labels.h"

namespace geolloyd {
namespace {

class Balance {
 public:
  Balance(const LevelMesh& level, const Cells& cells, const SurfaceSites& sites,
          std::span<const RegionId> labels)
      : level_(level),
        sites_(sites),
        farthest_(farthest_vertices(*level.mesh, sites.positions, level.is_on_curve, labels)),
        energy_(sites.size(), 0),
        is_removed_(sites.size(), 0) {
    const CellEnergies energies(*level.mesh, cells);
    for (RegionId r = 0; r < sites.size(); ++r) {
      if (energies.area(r) > 0) energy_[r] = energies.at(r, sites.positions[r]);
    }
  }

  void run(std::span<const std::size_t> wanted_free) {
    std::vector<std::vector<RegionId>> of_patch(wanted_free.size());
    for (RegionId r = 0; r < sites_.size(); ++r) {
      if (patch_of(r) != no_id) of_patch[patch_of(r)].push_back(r);
    }
    for (std::size_t patch = 0; patch < of_patch.size(); ++patch) {
      balance(of_patch[patch], wanted_free[patch]);
    }
  }

  [[nodiscard]] const std::vector<std::uint8_t>& is_removed() const { return is_removed_; }
  [[nodiscard]] const std::vector<VertexId>& inserted_at() const { return inserted_at_; }

 private:
  // Where a site may be inserted to relieve this one.
  [[nodiscard]] PatchId patch_of(RegionId r) const {
    if (r >= sites_.on_curves) return sites_.patch[r];
    return has_vertex(r) ? level_.patch[farthest_[r].vertex] : no_id;
  }

  void balance(std::vector<RegionId>& sites, std::size_t wanted) {
    std::sort(sites.begin(), sites.end(), [this](RegionId a, RegionId b) {
      return std::pair(energy_[a], a) < std::pair(energy_[b], b);
    });
    std::size_t count = 0;
    for (const RegionId r : sites) {
      if (r < sites_.on_curves) continue;
      if (has_vertex(r)) {
        ++count;
      } else {
        is_removed_[r] = 1;
      }
    }
    const std::size_t needed = count_large_cells(sites);
    for (const RegionId r : sites) {
      if (count + needed <= wanted) break;
      if (sites_.is_fixed[r] != 0 || !has_vertex(r)) continue;
      is_removed_[r] = 1;
      --count;
    }
    for (auto r = sites.rbegin(); r != sites.rend() && count < wanted; ++r) {
      if (is_removed_[*r] != 0 || !(farthest_[*r].square_distance > 0)) continue;
      inserted_at_.push_back(farthest_[*r].vertex);
      ++count;
    }
  }

  [[nodiscard]] bool has_vertex(RegionId r) const { return farthest_[r].vertex != no_id; }

  // An eighth of the sites at most.
  [[nodiscard]] std::size_t count_large_cells(const std::vector<RegionId>& sites) const {
    constexpr double large = 2;
    double mean = 0;
    for (const RegionId r : sites) mean += energy_[r] / static_cast<double>(sites.size());
    const auto count = std::count_if(sites.begin(), sites.end(), [&](RegionId r) {
      return energy_[r] > large * mean && farthest_[r].square_distance > 0;
    });
    return std::min(static_cast<std::size_t>(count), sites.size() / 8);
  }

  const LevelMesh& level_;
  const SurfaceSites& sites_;
  std::vector<FarthestVertex> farthest_;
  std::vector<double> energy_;
  std::vector<std::uint8_t> is_removed_;
  std::vector<VertexId> inserted_at_;
};

}  // namespace

void balance_sites(const LevelMesh& level, std::span<const std::size_t> wanted_free,
                   const Cells& cells, SurfaceSites& sites, std::vector<RegionId>& labels) {
  Balance balance(level, cells, sites, labels);
  balance.run(wanted_free);
  remove_sites(balance.is_removed(), sites, labels);
  for (const VertexId v : balance.inserted_at()) {
    labels[v] = static_cast<RegionId>(sites.size());
    sites.add(level.mesh->positions[v], level.patch[v]);
  }
}

void remove_sites(std::span<const std::uint8_t> is_removed, SurfaceSites& sites,
                  std::vector<RegionId>& labels) {
  if (std::count(is_removed.begin(), is_removed.end(), 0) ==
      static_cast<std::ptrdiff_t>(is_removed.size())) {
    return;
  }
  SurfaceSites kept;
  kept.on_curves = sites.on_curves;
  std::vector<RegionId> number(sites.size(), no_id);
  for (RegionId r = 0; r < sites.size(); ++r) {
    if (is_removed[r] != 0) continue;
    number[r] = static_cast<RegionId>(kept.size());
    kept.add(sites.positions[r], sites.patch[r]);
    kept.is_fixed.back() = sites.is_fixed[r];
  }
  for (RegionId& label : labels) {
    if (label != no_id) label = number[label];
  }
  sites = std::move(kept);
}

}  // namespace geolloyd
