#pragma once

// The program as its users meet it: run as a process, judged by its exit status, what it prints and
// what it leaves behind.
#include <gtest/gtest.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "core/text/file_io.h"
#include "tests/support/temporary_folder.h"

namespace geolloyd {

namespace fs = std::filesystem;

struct Outcome {
  int status = -1;
  std::string text;  // both streams
};

inline Outcome run_shell(const std::string& command) {
  // Where lines are counted, the program should not write its counts among the files looked at.
  ::setenv("LLVM_PROFILE_FILE", "/dev/null", 1);
  Outcome outcome;
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
    outcome.text.append(part.data(), n);
  }
  const int status = ::pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return outcome;
}

inline Outcome geolloyd_with(const std::string& arguments) {
  return run_shell(std::string(GEOLLOYD_PROGRAM) + " " + arguments);
}

// One line that holds `message`, and exit status 2.
inline void expect_complaint(const Outcome& outcome, const std::string& message) {
  EXPECT_EQ(outcome.status, 2) << outcome.text;
  EXPECT_EQ(std::count(outcome.text.begin(), outcome.text.end(), '\n'), 1) << outcome.text;
  EXPECT_EQ(outcome.text.rfind("geolloyd: ", 0), 0U) << outcome.text;
  EXPECT_NE(outcome.text.find(message), std::string::npos) << outcome.text;
}

inline std::vector<std::string> lines_of(const fs::path& path) {
  std::istringstream text(read_file(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

class Program : public testing::Test {
 protected:
  void SetUp() override {
    mesh_ = folder_.path() / "torus.ply";
    ASSERT_EQ(geolloyd_with("generate torus -t 2000 -o " + mesh_.string()).status, 0);
  }

  [[nodiscard]] Outcome relax(const std::string& options, const std::string& name = "out") const {
    return geolloyd_with("relax " + mesh_.string() + " -o " + out(name).string() + " " + options);
  }

  [[nodiscard]] fs::path out(const std::string& name = "out") const {
    return folder_.path() / name;
  }

  TemporaryFolder folder_;
  fs::path mesh_;
};

// The program in the background; where a folder is given, once that is there: then an interrupt no
// longer ends it at once.
class Running {
 public:
  Running(const std::vector<std::string>& arguments, const fs::path& text,
          const fs::path& folder = {})
      : id_(::fork()) {
    if (id_ == 0) {
      if (std::freopen(text.c_str(), "w", stdout) == nullptr) ::_exit(126);
      ::dup2(STDOUT_FILENO, STDERR_FILENO);
      std::vector<char*> argv = {const_cast<char*>(GEOLLOYD_PROGRAM)};
      for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
      argv.push_back(nullptr);
      ::execv(GEOLLOYD_PROGRAM, argv.data());
      ::_exit(127);
    }
    if (folder.empty()) return;
    while (!fs::exists(folder) && ::waitpid(id_, &status_, WNOHANG) == 0) ::usleep(1000);
    has_ended_ = !fs::exists(folder);
  }

  void send(int signal) const {
    if (!has_ended_) ::kill(id_, signal);
  }

  // Exit status, or minus the signal that ended it.
  int wait() {
    if (!has_ended_) ::waitpid(id_, &status_, 0);
    has_ended_ = true;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
  }

 private:
  pid_t id_;
  int status_ = 0;
  bool has_ended_ = false;
};

}  // namespace geolloyd
