#include "core/repair/repair.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/base/sorting.h"
#include "core/mesh/mesh_topology.h"
#include "core/repair/holes.h"
#include "core/repair/loose_components.h"
#include "core/repair/mesh_under_repair.h"
#include "core/repair/orientation.h"
#include "core/repair/slivers.h"
#include "core/seams/cut_apart.h"
#include "core/seams/stitching.h"

namespace geolloyd {
namespace {

class Repairer {
 public:
  Repairer(const Mesh& mesh, const RepairOptions& options, Executor& executor)
      : options_(options), executor_(executor) {
    state_.mesh = mesh;
    state_.vertex_origin.resize(mesh.vertex_count());
    std::iota(state_.vertex_origin.begin(), state_.vertex_origin.end(), VertexId{0});
    state_.triangle_origin.resize(mesh.triangle_count());
    std::iota(state_.triangle_origin.begin(), state_.triangle_origin.end(), TriangleId{0});
  }

  RepairedMesh run() {
    count_unused_vertices();
    remove_repeated_triangles();
    cut();
    remove_loose_components(state_, repairs_);
    stitch();
    try_stage([&] { remove_slivers(state_, repairs_); });
    orient(state_.mesh, repairs_);
    if (!try_stage([&] { fill(Touching::joined); })) try_stage([&] { fill(Touching::left); });
    count_cuts_and_merges();
    const auto& triangles = state_.mesh.triangles;
    repairs_.slivers_left = static_cast<std::size_t>(
        std::count_if(triangles.begin(), triangles.end(),
                      [&](const Triangle& t) { return is_sliver(state_.mesh, t); }));
    remove_unused_vertices(state_);
    return {std::move(state_.mesh), std::move(state_.vertex_origin),
            std::move(state_.triangle_origin), repairs_};
  }

 private:
  void count_unused_vertices() {
    const std::vector<std::uint8_t> is_used = referenced_vertices(state_.mesh, executor_);
    repairs_.unused_vertices =
        static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), 0));
  }

  void remove_repeated_triangles() {
    const Mesh& mesh = state_.mesh;
    std::vector<std::uint8_t> is_removed(mesh.triangle_count(), 0);
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      if (has_three_vertices(mesh.triangles[t])) continue;
      is_removed[t] = 1;
      ++repairs_.repeated_vertex_triangles;
    }
    for (const TriangleId t : find_edges(mesh, executor_).duplicates) {
      is_removed[t] = 1;
      ++repairs_.duplicate_triangles;
    }
    remove_triangles(state_, is_removed);
  }

  void cut() {
    for (const VertexId v : cut_apart(state_.mesh, executor_).copy_of)
      state_.vertex_origin.push_back(v);
    origin_after_cut_ = state_.vertex_origin;
    name_.resize(state_.vertex_origin.size());
    std::iota(name_.begin(), name_.end(), VertexId{0});
  }

  // Follows a renaming of vertices.
  void rename(const std::vector<VertexId>& name) {
    for (VertexId v = 0; v < name.size(); ++v) {
      state_.vertex_origin[name[v]] =
          std::min(state_.vertex_origin[name[v]], state_.vertex_origin[v]);
    }
    for (VertexId& v : name_) v = name[v];
  }

  void stitch() { rename(stitch_boundaries(state_.mesh)); }
  void fill(Touching touching) {
    rename(fill_holes(state_.mesh, options_, touching, repairs_));
    state_.triangle_origin.resize(state_.mesh.triangle_count(), no_id);
  }

  // Does a stage, and takes it back where it left more of what is wrong than there was. Whether it
  // stays.
  template <class Stage>
  bool try_stage(Stage&& stage) {
    const MeshUnderRepair state = state_;
    const Repairs repairs = repairs_;
    const std::vector<VertexId> name = name_;
    stage();
    if (state_.mesh.triangles == state.mesh.triangles) return true;
    const std::array<std::size_t, 3> before = flaws_of(state.mesh);
    const std::array<std::size_t, 3> after = flaws_of(state_.mesh);
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (after[i] <= before[i]) continue;
      state_ = state;
      repairs_ = repairs;
      name_ = name;
      return false;
    }
    return true;
  }
  [[nodiscard]] std::array<std::size_t, 3> flaws_of(const Mesh& mesh) const {
    const MeshTopology topology = find_topology(mesh, find_edges(mesh, executor_));
    return {topology.non_manifold_edges + topology.non_manifold_vertices,
            topology.total().boundary_loops, topology.inconsistent_edges};
  }

  // An input vertex was cut where it is several in the end, and merged where another has the name.
  void count_cuts_and_merges() {
    const std::vector<std::uint8_t> is_used = referenced_vertices(state_.mesh, executor_);
    std::vector<std::array<VertexId, 2>> pairs;  // of the input; what it is now
    for (VertexId v = 0; v < name_.size(); ++v) {
      if (is_used[name_[v]] != 0) pairs.push_back({origin_after_cut_[v], name_[v]});
    }
    sort_and_deduplicate(pairs);
    std::vector<std::uint8_t> is_named(state_.mesh.vertex_count(), 0);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const bool is_first = i == 0 || pairs[i][0] != pairs[i - 1][0];
      const bool is_single = i + 1 == pairs.size() || pairs[i][0] != pairs[i + 1][0];
      if (is_first && !is_single) ++repairs_.vertices_cut;
      std::uint8_t& named = is_named[pairs[i][1]];
      repairs_.vertices_merged += named;
      named = 1;
    }
  }

  const RepairOptions& options_;
  Executor& executor_;
  MeshUnderRepair state_;
  Repairs repairs_;
  std::vector<VertexId> origin_after_cut_;  // per vertex after the cut
  std::vector<VertexId> name_;              // per vertex after the cut: that which it is now
};

}  // namespace

bool Repairs::any() const {
  return repeated_vertex_triangles + duplicate_triangles + vertices_cut + vertices_merged +
             slivers_removed + triangles_turned + holes_filled + unused_vertices >
         0;
}

RepairedMesh make_repaired_mesh(const Mesh& mesh, const RepairOptions& options,
                                Executor& executor) {
  return Repairer(mesh, options, executor).run();
}

}  // namespace geolloyd
