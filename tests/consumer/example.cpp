#include <geolloyd/geolloyd.h>

#include <cstdio>

int main() try {
  const geolloyd::Mesh mesh = geolloyd::read("scan.ply").mesh;
  geolloyd::RemeshOptions options;
  options.vertex_count = 2048;
  geolloyd::Threads threads;  // all that this process may use; they never change a result
  const geolloyd::Remesh remesh = geolloyd::remesh(mesh, options, threads);
  geolloyd::write("remesh.ply", remesh.mesh);
  std::printf("%zu vertices\n", remesh.mesh.vertex_count());
} catch (const geolloyd::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
