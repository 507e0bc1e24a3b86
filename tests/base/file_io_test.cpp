#include "core/text/file_io.h"

#include <gtest/gtest.h>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/inotify.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <iterator>

#include "geolloyd/errors.h"
#include "tests/support/temporary_folder.h"

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
  EXPECT_EQ(message([] { read_file("/dev/zero"); }),
            "/dev/zero: cannot read: a device, not a file");
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

// Else a signal just then would leave the other.
TEST(FileIo, GivesANewFileNoOtherName) {
  const TemporaryFolder folder;
  OutputFile file(folder.path() / "a");
  file.write("new");
  const int events = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  ASSERT_GE(::inotify_add_watch(events, folder.path().c_str(), IN_CREATE | IN_MOVE | IN_DELETE), 0);
  file.commit();
  alignas(inotify_event) std::array<char, 4096> buffer{};
  const ssize_t size = ::read(events, buffer.data(), buffer.size());
  ::close(events);
  ASSERT_GT(size, 0);
  inotify_event event{};
  std::memcpy(&event, buffer.data(), sizeof event);
  EXPECT_STREQ(buffer.data() + sizeof event, "a");
  EXPECT_EQ(static_cast<std::size_t>(size), sizeof event + event.len) << "more than one event";
}

std::string temporary_name(int n) {
  return ".geolloyd-" + std::to_string(::getpid()) + "-" + std::to_string(n) + ".part";
}

TEST(FileIo, WritesWhereAKilledProcessOfTheSameIdLeftItsFile) {
  const TemporaryFolder folder;
  const fs::path left = folder.write(temporary_name(0), "left");
  const fs::path path = folder.write("a", "old");
  OutputFile file(path);
  file.write("new");
  file.commit();
  EXPECT_EQ(read_file(path), "new");
  EXPECT_EQ(read_file(left), "left");
  EXPECT_EQ(files_in(folder.path()), 2U);
}

// The longest name there can be is as good as any; a longer one is refused before all work.
TEST(FileIo, KnowsWhichNamesThereCanBe) {
  const TemporaryFolder folder;
  const fs::path longest = folder.path() / std::string(255, 'x');
  OutputFile file(longest);
  file.write("new");
  file.commit();
  EXPECT_EQ(read_file(longest), "new");
  EXPECT_THROW(OutputFile(folder.path() / std::string(256, 'x')), IoError);
  EXPECT_THROW(OutputFile(longest / "a"), IoError);
}

TEST(FileIo, GivesFilesTheUsersPermissions) {
  const TemporaryFolder folder;
  const mode_t mask = ::umask(027);
  OutputFile file(folder.path() / "a");
  ::umask(mask);
  file.commit();
  EXPECT_EQ(fs::status(folder.path() / "a").permissions(), static_cast<fs::perms>(0640));
}

TEST(FileIo, KeepsTheModeOfTheFileItReplaces) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a", "old");
  for (const auto mode : {0600, 0444, 0666, 0751}) {
    fs::permissions(path, static_cast<fs::perms>(mode));
    OutputFile file(path);
    file.write("new");
    file.commit();
    EXPECT_EQ(fs::status(path).permissions(), static_cast<fs::perms>(mode));
  }
  EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(FileIo, ReplacesWhatALinkPointsTo) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "data");
  const fs::path target = folder.path() / "data" / "target";
  const fs::path link = folder.path() / "link";
  fs::create_symlink("data/second", link);
  fs::create_symlink("target", folder.path() / "data" / "second");
  for (const std::string text : {"new", "newer"}) {  // first there is no file
    OutputFile file(link);
    file.write(text);
    file.commit();
    EXPECT_EQ(read_file(target), text);
    EXPECT_EQ(fs::read_symlink(link), "data/second");
  }
  EXPECT_EQ(files_in(folder.path()), 2U);
  EXPECT_EQ(files_in(folder.path() / "data"), 2U);
}

TEST(FileIo, RefusesALinkThatLeadsNowhereOrRound) {
  const TemporaryFolder folder;
  fs::create_symlink("missing/file", folder.path() / "nowhere");
  fs::create_symlink("round", folder.path() / "round");
  EXPECT_THROW(OutputFile(folder.path() / "nowhere"), IoError);
  EXPECT_THROW(OutputFile(folder.path() / "round"), IoError);
}

// From now on a system call fails in this process, if the kernel lets us say so.
bool forbid(unsigned call, unsigned error) {
  sock_filter steps[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                         BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 1),
                         BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | error),
                         BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
  const sock_fprog filter = {std::size(steps), steps};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

TEST(FileIo, KeepsTheOldFileWhereTheNewOneDoesNotReachTheDisk) {
  enum { written, refused, untested };
  const TemporaryFolder folder;
  const fs::path path = folder.write("a", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    if (!forbid(SYS_fdatasync, EIO)) ::_exit(untested);
    try {
      OutputFile file(path);
      file.write("new");
      file.sync();
      file.commit();
    } catch (const IoError&) {
      ::_exit(refused);
    }
    ::_exit(written);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == untested) GTEST_SKIP() << "no system call can be made to fail";
  EXPECT_EQ(WEXITSTATUS(status), refused);
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(files_in(folder.path()), 1U);
}

// While this lives no file can be larger.
class LargestFile {
 public:
  explicit LargestFile(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  LargestFile(const LargestFile&) = delete;
  LargestFile& operator=(const LargestFile&) = delete;
  ~LargestFile() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

TEST(FileIo, NoticesAFullDisk) {
  const TemporaryFolder folder;
  for (const std::size_t size : {5'000U, 5'000'000U}) {  // told when it is finished, and before
    const LargestFile limit(1000);
    OutputFile file(folder.path() / "a");
    EXPECT_THROW(
        {
          file.write(std::string(size, 'x'));
          file.finish();
        },
        IoError);
  }
  EXPECT_EQ(files_in(folder.path()), 0U);
}

TEST(FileIo, FollowsNoLinkThatBearsTheTemporaryName) {
  const TemporaryFolder folder;
  const fs::path other = folder.write("other", "kept");
  const fs::path path = folder.write("a", "old");
  for (int n = 0; n < 3; ++n) fs::create_symlink(other, folder.path() / temporary_name(n));
  OutputFile file(path);
  file.write("new");
  file.commit();
  EXPECT_EQ(read_file(path), "new");
  EXPECT_EQ(read_file(other), "kept");
  EXPECT_FALSE(fs::is_symlink(path));
}

TEST(FileIo, AppearsOnlyWhenCommitted) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a";
  {
    OutputFile file(path);
    file.write("lost");
    file.finish();
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_EQ(files_in(folder.path()), 0U);
}

}  // namespace
}  // namespace geolloyd
