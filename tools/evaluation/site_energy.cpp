#include "tools/evaluation/site_energy.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "core/base/buffer.h"
#include "core/base/loops.h"
#include "core/mesh/mesh_measure.h"
#include "tools/evaluation/distances/point_queries.h"

namespace geolloyd {
namespace {

// A point, and the site nearest to it.
struct Corner {
  Vec3 position;
  std::uint32_t site;
};

// A convex part of a triangle: its corners in order, and a site in whose cell it may be.
struct Piece {
  std::vector<Corner> corners;
  std::uint32_t site;
};

// Integral of the squared distance to `site` over a triangle.
double second_moment(const Vec3& site, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = a - site;
  const Vec3 v = b - site;
  const Vec3 w = c - site;
  const Vec3 sum = u + v + w;
  const double squares = dot(u, u) + dot(v, v) + dot(w, w) + dot(sum, sum);
  return norm(cross(b - a, c - a)) / 24 * squares;
}

// Squared distance to the first site, less that to the second. Linear in `p`, 0 on the bisector.
// Computed without the squares, whose difference would be lost between sites that are close.
double difference_of_squares(const Vec3& p, const Vec3& first, const Vec3& second) {
  return dot(second - first, (p - first) + (p - second));
}

// The energy of one triangle after another, for one thread.
class TriangleEnergy {
 public:
  TriangleEnergy(const NearestSite& nearest, std::span<const Vec3> sites)
      : nearest_(nearest), sites_(sites) {}

  double of(const Corner& a, const Corner& b, const Corner& c) {
    // A cell is convex: it has all of a triangle whose corners it has.
    if (a.site == b.site && b.site == c.site) {
      return second_moment(sites_[a.site], a.position, b.position, c.position);
    }
    reach_ = norm(a.position) + norm(b.position) + norm(c.position);
    pieces_.push_back({{a, b, c}, a.site});
    double energy = 0;
    while (!pieces_.empty()) {
      Piece piece = std::move(pieces_.back());
      pieces_.pop_back();
      for (;;) {
        const std::uint32_t other = site_to_cut_by(piece);
        if (other == piece.site) break;
        pieces_.push_back(cut_off(piece, other));
      }
      energy += energy_of_cell(piece);
    }
    return energy;
  }

 private:
  // The site whose bisector a corner is farthest beyond; the piece's own where none is. A corner
  // that rounding may have put there is not beyond it, or cuts would not come to an end.
  [[nodiscard]] std::uint32_t site_to_cut_by(const Piece& piece) const {
    constexpr double rounding = 0x1p-44;  // points on a bisector are off by some 2^-51 of all
    const Vec3& own = sites_[piece.site];
    std::uint32_t farthest = piece.site;
    double most = 0;
    for (const Corner& corner : piece.corners) {
      if (corner.site == piece.site) continue;
      const Vec3& other = sites_[corner.site];
      const double difference = difference_of_squares(corner.position, own, other);
      if (difference <= most) continue;
      if (difference <= rounding * norm(other - own) * (reach_ + norm(own))) continue;
      most = difference;
      farthest = corner.site;
    }
    return farthest;
  }

  // Takes from `piece` what is nearer to `other`, and returns that.
  Piece cut_off(Piece& piece, std::uint32_t other) {
    Piece beyond{{}, other};
    kept_.clear();
    const auto beyond_by = [&](const Corner& corner) {
      return difference_of_squares(corner.position, sites_[piece.site], sites_[other]);
    };
    const Corner* from = &piece.corners.back();
    double before = beyond_by(*from);
    for (const Corner& to : piece.corners) {
      const double after = beyond_by(to);
      if ((before > 0) != (after > 0)) {
        const double share = before / (before - after);
        const Vec3 crossing = from->position + share * (to.position - from->position);
        const Corner corner{crossing, nearest_.find(crossing, other)};
        kept_.push_back(corner);
        beyond.corners.push_back(corner);
      }
      (after > 0 ? beyond.corners : kept_).push_back(to);
      from = &to;
      before = after;
    }
    piece.corners.swap(kept_);
    return beyond;
  }

  [[nodiscard]] double energy_of_cell(const Piece& piece) const {
    double energy = 0;
    for (std::size_t i = 2; i < piece.corners.size(); ++i) {
      energy += second_moment(sites_[piece.site], piece.corners[0].position,
                              piece.corners[i - 1].position, piece.corners[i].position);
    }
    return energy;
  }

  const NearestSite& nearest_;
  std::span<const Vec3> sites_;
  double reach_ = 0;  // no coordinate of the triangle is larger
  std::vector<Piece> pieces_;
  std::vector<Corner> kept_;
};

Buffer<std::uint32_t> nearest_sites(const Mesh& mesh, const NearestSite& nearest,
                                    Executor& executor) {
  Buffer<std::uint32_t> site(mesh.vertex_count());
  parallel_for_ranges(executor, site.size(), small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        std::uint32_t guess = 0;
                        for (std::size_t v = begin; v < end; ++v) {
                          guess = nearest.find(mesh.positions[v], guess);
                          site[v] = guess;
                        }
                      });
  return site;
}

}  // namespace

// Sums over fixed ranges, then over these in order, so that threads do not matter.
double site_energy(const Mesh& mesh, std::span<const TriangleId> duplicates,
                   std::span<const Vec3> sites, Executor& executor) {
  const NearestSite nearest(sites, executor.threads());
  const Buffer<std::uint32_t> site = nearest_sites(mesh, nearest, executor);
  const Buffer<double> area = triangle_areas(mesh, duplicates, executor);
  const auto corner = [&](VertexId v) { return Corner{mesh.positions[v], site[v]}; };
  std::vector<double> of_range(mesh.triangle_count() / small_items + 1, 0);
  parallel_for_ranges(executor, mesh.triangle_count(), small_items,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        TriangleEnergy triangle(nearest, sites);
                        double energy = 0;
                        for (std::size_t t = begin; t < end; ++t) {
                          if (area[t] == 0) continue;
                          const auto& [a, b, c] = mesh.triangles[t];
                          energy += triangle.of(corner(a), corner(b), corner(c));
                        }
                        of_range[begin / small_items] = energy;
                      });
  return std::accumulate(of_range.begin(), of_range.end(), 0.0);
}

}  // namespace geolloyd
