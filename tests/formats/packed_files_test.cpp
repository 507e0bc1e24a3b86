// Files packed by gzip and zstd: the same mesh, a line where they are damaged, and never more than
// is allowed.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "core/formats/mesh_io.h"
#include "core/text/compression.h"
#include "core/text/file_io.h"
#include "core/text/file_writer.h"
#include "geolloyd/errors.h"
#include "tests/support/mesh_files.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {
namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

class PackedFiles : public MeshFiles, public testing::WithParamInterface<const char*> {
 protected:
  // As the writer of files packs it.
  [[nodiscard]] std::string packed(std::string_view bytes) const {
    const std::filesystem::path path = folder_.path() / (std::string("bytes") + GetParam());
    FileWriter out(path);
    // Not all at once: pieces of every size come.
    for (std::size_t i = 0, size = 1; i < bytes.size(); i += size, size = 3 * size + 1) {
      out.text(bytes.substr(i, size));
    }
    out.commit();
    return read_file(path);
  }

  // The message, or nothing where the bytes are accepted.
  [[nodiscard]] static std::string refusal(std::string_view bytes, std::uint64_t most_bytes) {
    try {
      (void)unpack(std::string(bytes), "x", most_bytes);
      return {};
    } catch (const InvalidInput& error) {
      return error.what();
    }
  }

 private:
  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Both, PackedFiles, testing::Values(".gz", ".zst"),
                         [](const auto& which) { return std::string(which.param + 1); });

TEST_P(PackedFiles, ReadBackWhatWasWritten) {
  for (const char* name : {"m.ply", "m.obj", "m.off", "m.stl"}) {
    const std::string file = name + std::string(GetParam());
    const std::string bytes = written(file);
    EXPECT_NE(compression_of(bytes), Compression::none);
    expect_tetrahedron(file, bytes);
    expect_tetrahedron(file, written(name));  // what was unpacked on its way keeps its name
    expect_tetrahedron(name, bytes);
  }
}

TEST_P(PackedFiles, HoldAnyBytes) {
  std::string large(3'000'000, 'x');
  for (std::size_t i = 0; i < large.size(); i += 7) large[i] = static_cast<char>(i * i % 251);
  for (const std::string& bytes : {std::string(), std::string("a"), large}) {
    EXPECT_EQ(unpack(packed(bytes), "x", no_limit), bytes);
  }
}

TEST_P(PackedFiles, InARowAreOne) {
  EXPECT_EQ(unpack(packed("one ") + packed("") + packed("two"), "x", no_limit), "one two");
  const std::string message = refusal(packed("one") + "rest of it", no_limit);
  EXPECT_TRUE(message.starts_with("x: byte ")) << message;
  EXPECT_NE(message.find("damaged"), std::string::npos) << message;
}

TEST_P(PackedFiles, ThatWereCutOffAreRefused) {
  const std::string bytes = packed("0 1 2 3 some bytes 4 5 6 7 some bytes");
  for (std::size_t size = 4; size < bytes.size(); ++size) {
    EXPECT_EQ(refusal(bytes.substr(0, size), no_limit),
              "x: byte " + std::to_string(size) +
                  ": the compressed file ends before its data does; it was cut off");
  }
}

TEST_P(PackedFiles, WithAFlippedBitAreRefusedOrTheSame) {
  const std::string content = "0 1 2 3 some bytes 4 5 6 7 some bytes";
  const std::string bytes = packed(content);
  std::size_t refused = 0;
  for (std::size_t i = 4; i < bytes.size(); ++i) {
    std::string flipped = bytes;
    flipped[i] = static_cast<char>(flipped[i] ^ 4);
    const std::string message = refusal(flipped, no_limit);
    if (message.empty()) {
      EXPECT_EQ(unpack(flipped, "x", no_limit), content) << i;
    } else {
      EXPECT_TRUE(message.starts_with("x: byte ")) << message;
      ++refused;
    }
  }
  EXPECT_GT(refused, bytes.size() / 2);
}

TEST_P(PackedFiles, EndWhereTheyOutgrowWhatIsAllowed) {
  const std::string bomb = packed(std::string(10'000'000, '0'));
  EXPECT_LT(bomb.size(), 20'000U);
  EXPECT_EQ(unpack(bomb, "x", 10'000'000).size(), 10'000'000U);
  const std::string message = refusal(bomb, 9'999'999);
  EXPECT_NE(message.find("unpacked, the file has more than the 9999999 bytes that are allowed"),
            std::string::npos)
      << message;
}

TEST_P(PackedFiles, PackedTwiceAreRefused) {
  EXPECT_EQ(complaint("m.ply", packed(packed("ply\n"))),
            "m.ply: byte 0: the file is compressed more than once; unpack it first");
}

TEST(Compression, IsToldByTheName) {
  EXPECT_EQ(compression_of_name("a.ply.GZ"), Compression::gzip);
  EXPECT_EQ(compression_of_name("a.zst"), Compression::zstd);
  EXPECT_EQ(compression_of_name("a.gz.ply"), Compression::none);
  EXPECT_EQ(name_without_compression("b/a.ply.gz"), "b/a.ply");
  EXPECT_EQ(name_without_compression("b/a.ply"), "b/a.ply");
}

}  // namespace
}  // namespace geolloyd
