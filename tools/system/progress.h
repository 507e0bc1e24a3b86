#pragma once

#include <string>

#include "core/base/stopwatch.h"
#include "core/lloyd/relaxation.h"
#include "geolloyd/remesh.h"

namespace geolloyd {

/// One line on standard error that tells how far the work is; silent unless that is a terminal.
class ProgressLine {
 public:
  ProgressLine();
  /// One that tells nothing: of a part of something whose progress another line tells.
  static ProgressLine silent() { return ProgressLine(false); }
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

 private:
  explicit ProgressLine(bool on_terminal) : on_terminal_(on_terminal) {}
  [[nodiscard]] bool is_due();
  void print(const std::string& text);

  bool on_terminal_;
  bool printed_ = false;
  std::string part_;
  double last_shown_ = -1;  // seconds of watch_
  Stopwatch watch_;
};

}  // namespace geolloyd
