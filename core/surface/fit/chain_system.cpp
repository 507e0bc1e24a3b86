#include "core/surface/fit/chain_system.h"

#include <array>

namespace geolloyd {
namespace {

// The solution of a system with these columns; zero where it has none.
Vec3 solve_three(const std::array<Vec3, 3>& column, const Vec3& right) {
  const double determinant = dot(column[0], cross(column[1], column[2]));
  if (!(determinant > 0)) return Vec3::Zero();
  return Vec3(dot(right, cross(column[1], column[2])), dot(column[0], cross(right, column[2])),
              dot(column[0], cross(column[1], right))) /
         determinant;
}

}  // namespace

ChainSystem::ChainSystem(std::span<const Vec3> along, std::size_t vertices, double stiffness)
    : stiffness_(stiffness),
      edges_(vertices, {Vec3::Zero(), {}, {}}),
      pull_(vertices, Vec3::Zero()) {
  for (std::size_t i = 0; i < along.size(); ++i) edges_[i].along = along[i];
}

void ChainSystem::add(std::size_t edge, double share, double weight, const Vec3& away) {
  const bool is_inside = share > 0 && share < 1;
  Shares& shares = is_inside ? edges_[edge].inside : edges_[edge].at_ends;
  shares.add(weight, 1 - share, share);
  pull_[edge] += (weight * (1 - share)) * away;
  pull_[after(edge)] += (weight * share) * away;
}

// By Gauss and Seidel: the matrix is that of hat functions, so that a sweep leaves a quarter.
std::vector<Vec3> ChainSystem::solve(std::span<const std::uint8_t> is_held) const {
  constexpr int sweeps = 20;
  std::vector<Vec3> move(pull_.size(), Vec3::Zero());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < move.size(); ++i) {
      if (is_held[i] == 0) move[i] = best_move(i, move);
    }
  }
  return move;
}

Vec3 ChainSystem::apply(const Edge& edge, double inside, double at_ends, const Vec3& move) const {
  return (inside + at_ends) * move -
         ((1 - stiffness_) * inside * dot(edge.along, move)) * edge.along;
}

// While its neighbours move as they do.
Vec3 ChainSystem::best_move(std::size_t i, const std::vector<Vec3>& move) const {
  const Edge& in = edges_[before(i)];
  const Edge& out = edges_[i];
  const Vec3 right = pull_[i] - apply(in, in.inside.both, in.at_ends.both, move[before(i)]) -
                     apply(out, out.inside.both, out.at_ends.both, move[after(i)]);
  std::array<Vec3, 3> column;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 unit = Vec3::Unit(axis);
    column[static_cast<std::size_t>(axis)] = apply(in, in.inside.second, in.at_ends.second, unit) +
                                             apply(out, out.inside.first, out.at_ends.first, unit);
  }
  return solve_three(column, right);
}

}  // namespace geolloyd
