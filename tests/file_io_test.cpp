#include "core/file_io.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include "core/errors.h"
#include "tests/temporary_folder.h"

namespace geolloyd {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(FileIo, ReadsWhatWasWritten) {
  const TemporaryFolder folder;
  std::string bytes(3'000'000, 'x');
  bytes[17] = '\0';
  OutputFile file(folder.path() / "with space ü.bin");
  file.write(bytes);
  file.commit();
  EXPECT_EQ(read_file(folder.path() / "with space ü.bin"), bytes);
  EXPECT_EQ(read_file(folder.write("empty", "")), "");
}

TEST(FileIo, LeavesTheOldFileUntilTheNewOneIsComplete) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a", "old");
  {
    OutputFile file(path);
    file.write("ne");
    EXPECT_EQ(read_file(path), "old");
  }
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(files_in(folder.path()), 1U);
  OutputFile file(path);
  file.write("new");
  file.commit();
  EXPECT_EQ(read_file(path), "new");
  EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(FileIo, SaysWhichFileCannotBeUsedAndWhy) {
  const TemporaryFolder folder;
  const auto message = [](auto&& action) {
    try {
      action();
    } catch (const IoError& error) {
      return std::string(error.what());
    }
    return std::string("nothing thrown");
  };
  const fs::path missing = folder.path() / "missing" / "file";
  EXPECT_EQ(message([&] { read_file(missing); }),
            missing.string() + ": cannot open: No such file or directory");
  EXPECT_EQ(message([&] { read_file(folder.path()); }),
            folder.path().string() + ": cannot read: Is a directory");
  EXPECT_EQ(message([&] { const OutputFile file(missing); }),
            missing.string() + ": cannot write: No such file or directory");
  EXPECT_EQ(message([&] { const OutputFile file(folder.path()); }),
            folder.path().string() + ": cannot write: Is a directory");
  EXPECT_EQ(message([] { const OutputFile file("/dev/null"); }),
            "/dev/null: cannot write: not a regular file");
}

TEST(FileIo, NoticesAFullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  // The temporary name beside the target is a link to the device that is always full.
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a";
  fs::create_symlink("/dev/full", path.string() + ".part" + std::to_string(::getpid()));
  OutputFile file(path);
  EXPECT_THROW(
      {
        file.write(std::string(5'000'000, 'x'));
        file.commit();
      },
      IoError);
  EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace geolloyd
