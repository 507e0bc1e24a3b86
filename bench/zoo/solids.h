#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "bench/zoo/part.h"
#include "bench/zoo/polygon.h"

// The ways to make a solid. Volumes come from formulas, but for those of threads and curves.
namespace geolloyd::zoo {

struct Ring {
  Polygon outline;
  double height = 0;
};

/// A wall over a line, and the flat face inside it. The rings have corner for corner quadrilaterals
/// between them, which are to be plane.
struct Terrace {
  std::vector<Ring> rings;        ///< from the height outside to that inside
  std::vector<Terrace> inside{};  ///< on the face, apart
  bool is_round = false;          ///< first and last ring are rims
};

/// A wall that goes straight up or down.
Terrace wall(const Polygon& outline, double from, double to);
Terrace round_wall(const Polygon& outline, double from, double to);
/// One that ends in a chamfer or a fillet of so many edges: toward its inside, from a wall to the
/// face within it. `edges` 1: a chamfer.
Terrace filleted_wall(const Polygon& outline, double from, double to, double radius,
                      std::uint32_t edges);

/// The outermost terrace rises from the bottom. One inside that goes down to the bottom is a hole
/// through all.
Solid terraces(const Terrace& outermost);

/// The profile goes counterclockwise, in radius and height, from the axis to the axis, or around.
/// Faces at its ends are fans from the axis, or from a corner. Of as many sides.
struct Turning {
  Polygon profile;
  std::uint32_t sides = 64;
  bool is_ring = false;      ///< closed, off the axis
  bool from_corner = false;  ///< both flat ends
};
Solid turned(const Turning& turning);

/// A rod with a ridge that winds around it: radius by height, over one turn, ascending.
Solid threaded(const Polygon& profile, double pitch, std::uint32_t turns, std::uint32_t sides);

/// Where a profile stands that is drawn along a curve.
struct Stand {
  Vec3 middle;
  Vec3 x;
  Vec3 y;
};
/// A convex profile; ends are fans from a corner.
Solid swept(const std::function<Stand(double share)>& curve, std::uint32_t steps,
            const Polygon& profile, bool is_closed);

/// Several, apart, as one.
Solid together(const std::vector<Solid>& solids);
Solid moved(Solid solid, const Vec3& by);
/// Within its hull there is another one, as the hollow of a ball.
Solid with_hollow(Solid hull, const Solid& hollow);

}  // namespace geolloyd::zoo
