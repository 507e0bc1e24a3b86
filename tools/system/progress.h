#pragma once

#include <cstdint>
#include <string>

#include "core/base/stopwatch.h"
#include "core/lloyd/relaxation.h"
#include "geolloyd/remesh.h"
#include "tools/system/console.h"

namespace geolloyd {

/// One line on standard error that tells how far the work is; silent unless that is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(const Console& console);
  /// One that tells nothing: of a part of something whose progress another line tells.
  static ProgressLine silent() { return {true, false}; }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { clear(); }

  /// What all that follows is part of, until the next stage; to be named first.
  void part(const std::string& what) { part_ = what + "  "; }
  /// What is being done, where no steps can be counted.
  void stage(const std::string& what);
  void show(const Progress& progress, std::size_t seed_count);
  void show(const RemeshProgress& progress);
  void clear();
  /// Says once, not only on a terminal, that a large run begins, which takes so much memory at
  /// most. Throws InvalidInput where that is more than the limit (memory_limit.h).
  void announce_memory(const std::string& what, std::uint64_t bytes);

 private:
  ProgressLine(bool is_silent, bool on_terminal)
      : is_silent_(is_silent), on_terminal_(on_terminal) {}
  [[nodiscard]] bool is_due();
  void print(const std::string& text);

  bool is_silent_;
  bool on_terminal_;
  bool announced_ = false;
  bool printed_ = false;
  std::string part_;
  double last_shown_ = -1;  // seconds of watch_
  Stopwatch watch_;
};

}  // namespace geolloyd
