#include "core/text/file_io.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>
#include <utility>

#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, int code) {
  throw IoError(path.string() + ": " + what + ": " + std::generic_category().message(code));
}

class Descriptor {
 public:
  explicit Descriptor(const std::filesystem::path& path)
      : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (number_ < 0) fail(path, "cannot open", errno);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { ::close(number_); }

  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

// The name by which a descriptor's file can be linked to another.
std::string name_of(int descriptor) {
  return "/proc/self/fd/" + std::to_string(descriptor);
}

// What `path` stands for: the end of its links, if it is one, whether that is there or not.
std::filesystem::path end_of_links(std::filesystem::path path) {
  constexpr int most_links = 40;  // as the system has it
  std::error_code error;
  for (int i = 0; i < most_links && std::filesystem::is_symlink(path, error); ++i) {
    const std::filesystem::path target = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / target;
  }
  return path;
}

// Null where the file system knows no files without a name, or they could not be given one.
std::FILE* open_unnamed(const std::filesystem::path& folder) {
  const int number = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC,
                            S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH);
  if (number < 0) return nullptr;
  std::FILE* file = ::access(name_of(number).c_str(), F_OK) == 0 ? ::fdopen(number, "wb") : nullptr;
  if (file == nullptr) ::close(number);
  return file;
}

std::string read_all(int descriptor, const std::filesystem::path& path) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) fail(path, "cannot read", errno);
  if (S_ISDIR(status.st_mode)) fail(path, "cannot read", EISDIR);
  // Some never end.
  if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) {
    throw IoError(path.string() + ": cannot read: a device, not a file");
  }

  // The size is only a first guess: a pipe has none, and a file may grow while it is read.
  std::string bytes(static_cast<std::size_t>(status.st_size) + 1, '\0');
  std::size_t filled = 0;
  while (true) {
    if (filled == bytes.size()) bytes.resize(2 * bytes.size());
    const ssize_t count = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, "cannot read", errno);
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  return read_all(Descriptor(path).number(), path);
}

std::string read_standard_input(const std::string& name) {
  return read_all(STDIN_FILENO, name);
}

OutputFile::OutputFile(std::filesystem::path path)
    : path_(std::move(path)), target_(end_of_links(path_)) {
  // A name that is too long, for example: the file would be lost when it is to have its name.
  struct stat status {};
  const bool replaces = ::stat(target_.c_str(), &status) == 0;
  if (!replaces && errno != ENOENT) fail(path_, "cannot write", errno);
  if (replaces && S_ISDIR(status.st_mode)) fail(path_, "cannot write", EISDIR);
  // A rename would put a plain file in the place of a device or a pipe.
  if (replaces && !S_ISREG(status.st_mode)) {
    throw IoError(path_.string() + ": cannot write: not a regular file");
  }
  open();
  // Some file systems know no modes: there the file has the one that they give to all.
  constexpr mode_t permissions = S_IRWXU | S_IRWXG | S_IRWXO;
  if (replaces) (void)::fchmod(::fileno(file_.get()), status.st_mode & permissions);
}

OutputFile::OutputFile(int descriptor, const std::string& name)
    : path_(name), target_(path_), is_stream_(true) {
  const int own = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (own >= 0) file_.reset(::fdopen(own, "wb"));
  if (file_) return;
  const int error = errno;
  if (own >= 0) ::close(own);
  fail(path_, "cannot write", error);
}

void OutputFile::open() {
  file_.reset(open_unnamed(target_.parent_path()));
  if (file_) return;
  make_temporary([&] {
    file_.reset(std::fopen(temporary_.c_str(), "wbex"));
    return file_ != nullptr;
  });
}

OutputFile::~OutputFile() {
  file_.reset();
  if (!has_name_) return;
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void OutputFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    fail(path_, "cannot write", errno);
  }
}

void OutputFile::sync() {
  const bool is_written = std::fflush(file_.get()) == 0;
  // EINVAL: there is no disk to bring it to.
  if (!is_written || (::fdatasync(::fileno(file_.get())) != 0 && errno != EINVAL)) {
    fail(path_, "cannot write", errno);
  }
}

void OutputFile::finish() {
  if (!file_) return;
  // Over a network it may be only when a file is closed that the disk turns out to be full; one
  // without a name would be gone then.
  const int result = has_name_ ? std::fclose(file_.release()) : std::fflush(file_.get());
  if (result != 0) fail(path_, "cannot write", errno);
}

void OutputFile::commit() {
  finish();
  if (is_stream_) return file_.reset();
  // In one step where nothing bears the name: a signal finds no other. No file can be linked over
  // another, but any can be renamed over one.
  const auto link_to = [&](const std::filesystem::path& name) {
    return ::linkat(AT_FDCWD, name_of(::fileno(file_.get())).c_str(), AT_FDCWD, name.c_str(),
                    AT_SYMLINK_FOLLOW) == 0;
  };
  if (!has_name_ && !link_to(target_)) make_temporary([&] { return link_to(temporary_); });
  if (has_name_ && std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    fail(path_, "cannot write", errno);
  }
  has_name_ = false;
  file_.reset();
}

// Under a name that nothing bears: one may be left by a process of the same id that was killed,
// and where others may write, they may have put a link there.
template <class Make>
void OutputFile::make_temporary(const Make& make) {
  const std::string begin = ".geolloyd-" + std::to_string(::getpid()) + "-";
  for (std::uint64_t n = 0; !has_name_; ++n) {
    temporary_ = target_.parent_path() / (begin + std::to_string(n) + ".part");
    has_name_ = make();
    if (!has_name_ && errno != EEXIST) fail(path_, "cannot write", errno);
  }
}

}  // namespace geolloyd
