// The library inside a shared object of somebody else's.
#include <geolloyd/geolloyd.h>

extern "C" int regions_of_a_tetrahedron() {
  geolloyd::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  geolloyd::Threads threads(2);
  geolloyd::RelaxOptions options;
  options.seed_count = 2;
  return static_cast<int>(geolloyd::relax(mesh, options, threads).regions.size());
}
