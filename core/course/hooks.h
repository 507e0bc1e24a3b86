#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace geolloyd {

/// What a course tells its client, and asks it. Any may be empty. All are called by the calling
/// thread.
struct CourseHooks {
  std::function<void(const std::string& stage)> stage;  ///< a stage begins: "building the graph"
  std::function<bool()>
      keep_going;  ///< asked now and then; false ends the work with what it has come to
  std::function<void(std::uint64_t bytes)>
      budget;  ///< what the run will hold at most, before it holds it; may throw
};

}  // namespace geolloyd
