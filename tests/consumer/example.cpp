#include <geolloyd/geolloyd.h>

#include <cstdio>

int main() try {
  const geolloyd::Mesh scan = geolloyd::read("scan.ply").mesh;
  const geolloyd::Remesh remesh = geolloyd::remesh(scan, {.vertex_count = 2048});
  geolloyd::write("remesh.ply", remesh.mesh);
} catch (const geolloyd::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
