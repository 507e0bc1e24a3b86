#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/text/file_io.h"

namespace geolloyd {

/// Files packed as gzip and zstd have it.
enum class Compression { none, gzip, zstd };

/// Told by the first bytes of a file.
Compression compression_of(std::string_view bytes);

/// Told by the extension: ".gz", ".zst" (case-insensitive).
Compression compression_of_name(const std::filesystem::path& path);

/// "scan.ply" for "scan.ply.gz": the name without an extension that names a compression.
std::filesystem::path name_without_compression(const std::filesystem::path& path);

/// What `bytes` hold, or `bytes` where they are not packed. Several packed streams in a row are
/// one. Throws InvalidInput "NAME: byte N: ..." where a stream is damaged or cut off, or where more
/// than `most_bytes` would come out. Memory grows with what has come out.
std::string unpack(std::string bytes, std::string_view name, std::uint64_t most_bytes);

/// Packs what is written into a file.
class Packer {
 public:
  virtual ~Packer() = default;
  virtual void write(std::string_view bytes) = 0;
  /// Nothing is written after this.
  virtual void finish() = 0;
};

/// As the name of the file has it; null where that names no compression. `file` must live on. The
/// same bytes give the same file with the same version of zlib or zstd.
std::unique_ptr<Packer> make_packer(const std::filesystem::path& path, OutputFile& file);

}  // namespace geolloyd
