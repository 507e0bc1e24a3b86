#include "tools/files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <utility>

#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

// The folders that this process has locked. A global, for the locks are the process's: they last as
// long as it does, whoever asked for them.
std::set<std::pair<dev_t, ino_t>>& locked_folders() {
  static std::set<std::pair<dev_t, ino_t>> folders;
  return folders;
}

}  // namespace

void lock_folder(const std::filesystem::path& folder) {
  const int number = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  struct stat status {};
  if (number < 0) return;
  const bool is_known = ::fstat(number, &status) == 0;
  const std::pair identity(status.st_dev, status.st_ino);
  if (is_known && !locked_folders().contains(identity)) {
    if (::flock(number, LOCK_EX | LOCK_NB) == 0) {
      locked_folders().insert(identity);
      return;  // the lock lives as long as the descriptor is open
    }
    if (errno == EWOULDBLOCK) {
      ::close(number);
      throw InvalidInput(folder.string() +
                         ": another run writes into this folder: wait for its end, or give another "
                         "folder");
    }
  }
  ::close(number);
}

}  // namespace geolloyd
