#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "bench/zoo/solids.h"
#include "bench/zoo/zoo.h"

namespace geolloyd::zoo {
namespace {

/// Of radius 1 about the z axis.
Solid spring(const Polygon& profile, double pitch, std::uint32_t turns, std::uint32_t steps) {
  const auto curve = [=](double share) {
    const double angle = 2 * std::numbers::pi * share * turns;
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    const double rise = pitch / (2 * std::numbers::pi);
    const Vec3 along = normalized(Vec3(-out.y(), out.x(), rise));
    return Stand{out + Vec3(0, 0, rise * angle), out, cross(along, out)};
  };
  return swept(curve, turns * steps, profile, false);
}

/// A rounded oblong in the plane of x and y, or of x and z.
Solid chain_link(double thickness, bool is_upright) {
  const auto curve = [=](double share) {
    const double angle = 2 * std::numbers::pi * share;
    const Vec3 round(std::cos(angle), std::sin(angle), 0);
    const Vec3 shift((std::abs(share - 0.5) < 0.25 ? -0.5 : 0.5), 0, 0);
    const Vec3 down(0, 0, -1);
    const auto place = [&](const Vec3& p) { return is_upright ? Vec3(p.x(), -p.z(), p.y()) : p; };
    return Stand{place(round + shift), place(round), place(down)};
  };
  return swept(curve, 46, circle({0, 0}, thickness, 12), true);
}

Solid chain(std::uint32_t links) {
  std::vector<Solid> all;
  for (std::uint32_t k = 0; k < links; ++k) {
    all.push_back(moved(chain_link(0.2, k % 2 == 1), {2.3 * k, 0, 0}));
  }
  return together(all);
}

Solid bent_rod(const Polygon& profile) {
  const auto curve = [](double share) {
    const double angle = std::numbers::pi * (1.5 * share - 0.5);
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    return Stand{out, out, Vec3(0, 0, -1)};
  };
  return swept(curve, 72, profile, false);
}

/// A trefoil; its profile stands straight on it.
Solid knot() {
  const auto at = [](double share) {
    const double t = 2 * std::numbers::pi * share;
    return Vec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                -std::sin(3 * t));
  };
  const auto curve = [at](double share) {
    const Vec3 along = normalized(at(share + 1e-4) - at(share - 1e-4));
    const Vec3 x = normalized(cross(Vec3(0, 0, 1), along));
    return Stand{at(share), x, cross(along, x)};
  };
  return swept(curve, 240, circle({0, 0}, 0.35, 16), true);
}

Solid coarse_thread() {
  return threaded({{1, 0}, {1, 0.1}, {1.25, 0.22}, {1.25, 0.28}}, 0.4, 6, 48);
}

Solid fine_thread() {
  return threaded({{1, 0}, {1.06, 0.05}}, 0.1, 20, 48);
}

Solid square_thread() {
  return threaded({{1, 0}, {1, 0.248}, {1.2, 0.25}, {1.2, 0.498}}, 0.5, 5, 64);
}

}  // namespace

void add_curves(Cages& cages) {
  const auto add = [&](const std::string& name, const std::string& kind, auto make) {
    cages.push_back(cage(name, kind, make));
  };
  const std::string kind = "screw or spring";
  add("spring_round", kind, [] { return spring(circle({0, 0}, 0.15, 16), 0.5, 5, 40); });
  add("spring_wire", kind, [] { return spring(circle({0, 0}, 0.03, 8), 0.2, 8, 40); });
  add("spring_square", kind, [] {
    return spring(rectangle({-0.12, -0.12}, {0.12, 0.12}), 0.4, 5, 48);
  });
  add("spring_ribbon", kind, [] {
    return spring(rectangle({-0.2, -0.02}, {0.2, 0.02}), 0.3, 4, 60);
  });
  add("thread_coarse", kind, coarse_thread);
  add("thread_fine", kind, fine_thread);
  add("thread_square", kind, square_thread);
  add("rod_bent", "turned part", [] { return bent_rod(circle({0, 0}, 0.2, 24)); });
  add("bar_bent", "turned part", [] { return bent_rod(rectangle({-0.2, -0.2}, {0.2, 0.2})); });
  add("chain", "many pieces", [] { return chain(7); });
  cages.push_back({"knot", soft_kind, [] { return soft_part_of("knot", knot()); }});
}

}  // namespace geolloyd::zoo
