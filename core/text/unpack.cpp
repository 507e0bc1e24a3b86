#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>
#include <vector>

#include "core/text/compression.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// Collects what comes out of a packed file, piece by piece.
class Unpacked {
 public:
  Unpacked(std::string_view packed, std::string_view name, std::uint64_t most_bytes)
      : packed_(packed), name_(name), most_bytes_(most_bytes) {}

  // A promise of the file: no more than is likely from so many bytes, and room only.
  void reserve(std::uint64_t promised) {
    constexpr std::uint64_t likely_ratio = 1024;
    bytes_.reserve(
        static_cast<std::size_t>(std::min({promised, most_bytes_, likely_ratio * packed_.size()})));
  }

  [[nodiscard]] std::vector<char>& piece() { return piece_; }

  // The first `count` bytes of the piece; the packed file was read up to `offset`.
  void take(std::size_t count, std::size_t offset) {
    if (count > most_bytes_ - bytes_.size()) {
      fail(offset, "unpacked, the file has more than the " + std::to_string(most_bytes_) +
                       " bytes that are allowed");
    }
    bytes_.append(piece_.data(), count);
  }

  [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
    throw InvalidInput(std::string(name_) + ": byte " + std::to_string(offset) + ": " + message);
  }
  [[noreturn]] void fail_at_end() const {
    fail(packed_.size(), "the compressed file ends before its data does; it was cut off");
  }
  [[noreturn]] void fail_damaged(std::size_t offset, const char* why) const {
    fail(offset, std::string("the compressed file is damaged: ") + why);
  }

  std::string release() { return std::move(bytes_); }

 private:
  std::string_view packed_;
  std::string_view name_;
  std::uint64_t most_bytes_;
  std::vector<char> piece_ = std::vector<char>(std::size_t{1} << 17);
  std::string bytes_;
};

class Inflater {
 public:
  Inflater() {
    constexpr int gzip_only = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, gzip_only) != Z_OK) throw std::bad_alloc();
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream_); }

  void run(std::string_view packed, Unpacked& unpacked) {
    std::size_t offset = 0;
    while (offset < packed.size()) {
      const int status = step(packed, offset, unpacked);
      if (status == Z_STREAM_END && offset == packed.size()) return;
      if (status == Z_STREAM_END) begin_next(packed.substr(offset), offset, unpacked);
    }
    unpacked.fail_at_end();
  }

 private:
  int step(std::string_view packed, std::size_t& offset, Unpacked& unpacked) {
    constexpr std::size_t most = std::numeric_limits<uInt>::max();
    const std::string_view rest = packed.substr(offset);
    const auto given = static_cast<uInt>(std::min(rest.size(), most));
    std::vector<char>& piece = unpacked.piece();
    // zlib does not write there.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest.data()));
    stream_.avail_in = given;
    stream_.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream_.avail_out = static_cast<uInt>(piece.size());
    const int status = inflate(&stream_, Z_NO_FLUSH);
    offset += given - stream_.avail_in;
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status != Z_OK && status != Z_STREAM_END) {
      unpacked.fail_damaged(offset, stream_.msg != nullptr ? stream_.msg : "no valid data");
    }
    unpacked.take(piece.size() - stream_.avail_out, offset);
    return status;
  }

  // What stands behind a stream: another one.
  void begin_next(std::string_view rest, std::size_t offset, const Unpacked& unpacked) {
    if (compression_of(rest) != Compression::gzip) {
      unpacked.fail_damaged(offset, "what stands behind its end is no gzip");
    }
    inflateReset(&stream_);
  }

  z_stream stream_{};
};

std::string unpack_gzip(std::string_view packed, std::string_view name, std::uint64_t most_bytes) {
  Unpacked unpacked(packed, name, most_bytes);
  // The size of the last stream stands at the end, modulo 2^32.
  std::uint64_t promised = 0;
  for (std::size_t i = 0; i < 4 && packed.size() > 4; ++i) {
    promised = promised << 8 | static_cast<unsigned char>(packed[packed.size() - 1 - i]);
  }
  unpacked.reserve(promised);
  Inflater().run(packed, unpacked);
  return unpacked.release();
}

std::string unpack_zstd(std::string_view packed, std::string_view name, std::uint64_t most_bytes) {
  Unpacked unpacked(packed, name, most_bytes);
  const unsigned long long promised = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (promised != ZSTD_CONTENTSIZE_UNKNOWN && promised != ZSTD_CONTENTSIZE_ERROR) {
    unpacked.reserve(promised);
  }
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(),
                                                                        &ZSTD_freeDCtx);
  if (context == nullptr) throw std::bad_alloc();
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  while (true) {
    std::vector<char>& piece = unpacked.piece();
    ZSTD_outBuffer out{piece.data(), piece.size(), 0};
    const std::size_t status = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(status) != 0) unpacked.fail_damaged(in.pos, ZSTD_getErrorName(status));
    unpacked.take(out.pos, in.pos);
    const bool is_all_read = in.pos == in.size;
    if (status == 0 && is_all_read) return unpacked.release();
    // Where the piece is full, more may come.
    if (is_all_read && out.pos < out.size) unpacked.fail_at_end();
  }
}

}  // namespace

std::string unpack(std::string bytes, std::string_view name, std::uint64_t most_bytes) {
  switch (compression_of(bytes)) {
    case Compression::gzip:
      return unpack_gzip(bytes, name, most_bytes);
    case Compression::zstd:
      return unpack_zstd(bytes, name, most_bytes);
    case Compression::none:
      break;
  }
  return bytes;
}

}  // namespace geolloyd
