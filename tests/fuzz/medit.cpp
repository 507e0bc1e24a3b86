#include "tests/fuzz/mesh_target.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return geolloyd::fuzz::try_mesh_file(geolloyd::MeshFormat::medit, data, size);
}
