#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>
#include <vector>

#include "core/text/compression.h"

namespace geolloyd {
namespace {

constexpr std::size_t piece_size = std::size_t{1} << 17;

class GzipPacker : public Packer {
 public:
  explicit GzipPacker(OutputFile& file) : file_(file) {
    constexpr int gzip = 16 + MAX_WBITS;
    constexpr int memory_level = 8;
    if (deflateInit2(&stream_, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip, memory_level,
                     Z_DEFAULT_STRATEGY) != Z_OK) {
      throw std::bad_alloc();
    }
  }
  GzipPacker(const GzipPacker&) = delete;
  GzipPacker& operator=(const GzipPacker&) = delete;
  ~GzipPacker() override { deflateEnd(&stream_); }

  void write(std::string_view bytes) override {
    constexpr std::size_t most = std::numeric_limits<uInt>::max();
    while (!bytes.empty()) {
      const std::string_view part = bytes.substr(0, most);
      pack(part, Z_NO_FLUSH);
      bytes.remove_prefix(part.size());
    }
  }

  void finish() override { pack({}, Z_FINISH); }

 private:
  void pack(std::string_view bytes, int flush) {
    // zlib does not write there.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(bytes.size());
    do {
      stream_.next_out = reinterpret_cast<Bytef*>(piece_.data());
      stream_.avail_out = static_cast<uInt>(piece_.size());
      deflate(&stream_, flush);
      file_.write({piece_.data(), piece_.size() - stream_.avail_out});
    } while (stream_.avail_out == 0);
  }

  OutputFile& file_;
  z_stream stream_{};
  std::vector<char> piece_ = std::vector<char>(piece_size);
};

class ZstdPacker : public Packer {
 public:
  explicit ZstdPacker(OutputFile& file) : file_(file), context_(ZSTD_createCCtx(), &ZSTD_freeCCtx) {
    if (context_ == nullptr) throw std::bad_alloc();
    ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_checksumFlag, 1);
  }

  void write(std::string_view bytes) override { pack(bytes, ZSTD_e_continue); }
  void finish() override { pack({}, ZSTD_e_end); }

 private:
  void pack(std::string_view bytes, ZSTD_EndDirective directive) {
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    for (bool is_done = false; !is_done;) {
      ZSTD_outBuffer out{piece_.data(), piece_.size(), 0};
      const std::size_t left = ZSTD_compressStream2(context_.get(), &out, &in, directive);
      if (ZSTD_isError(left) != 0) throw std::bad_alloc();
      file_.write({piece_.data(), out.pos});
      is_done = directive == ZSTD_e_end ? left == 0 : in.pos == in.size;
    }
  }

  OutputFile& file_;
  std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context_;
  std::vector<char> piece_ = std::vector<char>(piece_size);
};

}  // namespace

std::unique_ptr<Packer> make_packer(const std::filesystem::path& path, OutputFile& file) {
  switch (compression_of_name(path)) {
    case Compression::gzip:
      return std::make_unique<GzipPacker>(file);
    case Compression::zstd:
      return std::make_unique<ZstdPacker>(file);
    case Compression::none:
      break;
  }
  return nullptr;
}

}  // namespace geolloyd
