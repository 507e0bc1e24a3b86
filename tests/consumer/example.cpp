#include <geolloyd/geolloyd.h>
#include <cstdio>

int main() try {
  const geolloyd::Mesh mesh = geolloyd::read_mesh("scan.ply").mesh;
  geolloyd::Threads threads;  // all that this process may use; they never change a result
  geolloyd::TessellateOptions options;
  options.seed_count = 256;
  const geolloyd::Tessellation tessellation = geolloyd::tessellate(mesh, options, threads);
  const geolloyd::Remesh remesh = geolloyd::remesh(mesh, tessellation, {}, threads);
  geolloyd::write_mesh("remesh.ply", remesh.mesh);
  std::printf("%zu regions, energy %g\n", tessellation.regions.size(), tessellation.energy);
} catch (const geolloyd::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
