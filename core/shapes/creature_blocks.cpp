#include "core/shapes/creature_blocks.h"

#include <string_view>
#include <utility>

namespace geolloyd::creature_blocks {
namespace {

// Half of the animal, cut in upright slices and seen from the side; the slices go from the middle
// outwards, the other half is their mirror image.
constexpr std::array<std::string_view, height> slices = {
    ".##......................... ..................##........ ..................##........",
    "###......................... ..................##........ ..................##........",
    "##.................####..... ..................###....... ..................##........",
    "##.................#####.... ..................#####..... ..................###.......",
    "##.................#####.... ..................######.... ...................###......",
    "##.................######### ..................#######... ...................###......",
    "##.................######### ..................#######... ...................###......",
    ".##...............#########. ..................######.... ............................",
    ".##..............#####...... .................#####...... ............................",
    "..##.............####....... .................####....... ............................",
    "..###...........#####....... ................####........ ............................",
    "...#################........ ...################......... ....###.......####..........",
    "...#################........ ..##################........ ...################.........",
    "...################......... ..##################........ ...################.........",
    "...################......... ..##################........ ..#######..########.........",
    ".....#######.#####.......... ..#####..##########......... ..####.........####.........",
    "............................ ..####.........####......... ..####.........###..........",
    "............................ ...##...........##.......... ...##...........##..........",
    "............................ ...##...........##.......... ...##...........##..........",
    "............................ ...##...........##.......... ...##...........##..........",
    "............................ ...###..........###......... ...###..........###.........",
    "............................ ...####.........####........ ...####.........####........",
};

class BlockSurface {
 public:
  BlockSurface() {
    for (int z = 0; z < height; ++z) {
      for (int y = -half_width; y < half_width; ++y) {
        for (int x = 0; x < full_length; ++x) {
          if (is_solid(x, y, z)) add_faces({x, y, z});
        }
      }
    }
  }

  QuadMesh take() { return std::move(surface_); }

 private:
  using Cell = std::array<int, 3>;

  void add_faces(const Cell& block) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell neighbour = block;
        neighbour[axis] += 2 * side - 1;
        if (!is_solid(neighbour[0], neighbour[1], neighbour[2])) add_face(block, axis, side);
      }
    }
  }

  void add_face(Cell corner, std::size_t axis, int side) {
    // Around the face along its two other axes; their order decides which way it looks.
    const std::size_t u = (axis + (side == 1 ? 1 : 2)) % 3;
    const std::size_t v = (axis + (side == 1 ? 2 : 1)) % 3;
    corner[axis] += side;
    std::array<VertexId, 4> quad{};
    for (std::size_t i = 0; i < 4; ++i) {
      Cell at = corner;
      at[u] += i == 1 || i == 2 ? 1 : 0;
      at[v] += i >= 2 ? 1 : 0;
      quad[i] = vertex_at(at);
    }
    surface_.quads.push_back(quad);
  }

  VertexId vertex_at(const Cell& at) {
    const auto [x, y, z] = at;
    const int i = (z * (2 * half_width + 1) + y + half_width) * (full_length + 1) + x;
    VertexId& id = ids_[static_cast<std::size_t>(i)];
    if (id == no_id) {
      id = static_cast<VertexId>(surface_.positions.size());
      surface_.positions.emplace_back(x, y, z);
    }
    return id;
  }

  QuadMesh surface_;
  std::vector<VertexId> ids_ = std::vector<VertexId>(
      std::size_t{full_length + 1} * (2 * half_width + 1) * (height + 1), no_id);
};

}  // namespace

bool is_solid(int x, int y, int z) {
  const int slice = y < 0 ? -1 - y : y;
  if (x < 0 || x >= full_length || slice >= half_width || z < 0 || z >= height) return false;
  const std::string_view row = slices[static_cast<std::size_t>(height - 1 - z)];
  const int column = slice * (full_length + 1) + x;
  return row[static_cast<std::size_t>(column)] == '#';
}

QuadMesh surface() {
  return BlockSurface().take();
}

}  // namespace geolloyd::creature_blocks
