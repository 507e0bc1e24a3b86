#include "core/file_io.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

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

TEST(FileIo, NoticesThatThereIsNoRoom) {
  const TemporaryFolder folder;
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1'000'000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  {
    OutputFile file(folder.path() / "a");
    EXPECT_THROW(
        {
          file.write(std::string(5'000'000, 'x'));
          file.commit();
        },
        IoError);
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(files_in(folder.path()), 0U);
}

// However a process ends. (On file systems without files that have no name one is left.)
TEST(FileIo, LeavesNothingOfAFileWhoseProcessIsKilled) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    OutputFile file(folder.path() / "a");
    file.write(std::string(5'000'000, 'x'));
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(files_in(folder.path()), 0U);
}

TEST(FileIo, WritesWhereAKilledProcessOfTheSameIdLeftItsFile) {
  const TemporaryFolder folder;
  const fs::path left = folder.write("a.part" + std::to_string(::getpid()), "left");
  OutputFile file(folder.path() / "a");
  file.write("new");
  file.commit();
  EXPECT_EQ(read_file(folder.path() / "a"), "new");
  EXPECT_FALSE(fs::exists(left));
}

TEST(FileIo, GivesFilesTheUsersPermissions) {
  const TemporaryFolder folder;
  const mode_t mask = ::umask(027);
  OutputFile file(folder.path() / "a");
  ::umask(mask);
  file.commit();
  EXPECT_EQ(fs::status(folder.path() / "a").permissions(), static_cast<fs::perms>(0640));
}

}  // namespace
}  // namespace geolloyd
