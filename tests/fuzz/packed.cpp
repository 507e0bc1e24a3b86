// A packed file: refused in one line, or no more bytes than are allowed.
#include <string>

#include "core/text/compression.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace geolloyd;
  constexpr std::uint64_t most_bytes = 100'000;
  const std::string packed(fuzz::text_of(data, size));
  const auto bytes =
      fuzz::if_accepted([&] { return unpack(packed, fuzz::input_name, most_bytes); });
  if (!bytes) return 0;
  fuzz::require(bytes->size() <= most_bytes || *bytes == packed, "no more than is allowed");
  return 0;
}
