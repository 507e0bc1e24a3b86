#include "core/text/compression.h"

#include "core/text/text_cursor.h"

namespace geolloyd {

Compression compression_of(std::string_view bytes) {
  if (bytes.starts_with("\x1f\x8b\x08")) return Compression::gzip;
  if (bytes.starts_with("\x28\xb5\x2f\xfd")) return Compression::zstd;
  return Compression::none;
}

Compression compression_of_name(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".gz") return Compression::gzip;
  if (extension == ".zst") return Compression::zstd;
  return Compression::none;
}

std::filesystem::path name_without_compression(const std::filesystem::path& path) {
  if (compression_of_name(path) == Compression::none) return path;
  return path.parent_path() / path.stem();
}

}  // namespace geolloyd
