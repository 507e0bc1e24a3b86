#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geolloyd/evaluation.h"

namespace geolloyd {

/// The search for the fewest vertices whose remesh is within a tolerance. Distance falls about as
/// the number of vertices grows: so it goes on until the best one has at most a twentieth more
/// vertices than one that is too far. But it rises now and then: so at most five with a tenth
/// fewer, or two or three, are tried after that. None of that decides which is best: of all that
/// are within the tolerance it is the one with the fewest vertices.
class VertexSearch {
 public:
  /// Up to `most` vertices are tried, and at least 4.
  VertexSearch(double tolerance, std::size_t most);

  /// How many to try now; none: the search is over. Throws InvalidInput where more than `most`
  /// would be needed.
  [[nodiscard]] std::optional<std::size_t> next() const;
  /// What the remesh with next() vertices has, and how far it is. True where it is the best so far:
  /// the fewest vertices within the tolerance, or the last one while none is.
  bool add(const ToleranceTrial& trial);

  [[nodiscard]] const std::vector<ToleranceTrial>& trials() const { return trials_; }

 private:
  [[nodiscard]] bool has_close_bounds() const;
  [[nodiscard]] std::optional<std::size_t> next_probe() const;

  double tolerance_;
  std::size_t most_;
  std::size_t too_few_ = 3;
  std::size_t enough_ = 0;  // 0: none yet
  std::size_t tried_ = 0;   // the last one
  std::size_t fewest_ = 0;  // that a remesh within the tolerance has; 0: none yet
  std::size_t probes_ = 0;
  std::size_t vain_probes_ = 0;  // since the last one that was near enough
  std::vector<ToleranceTrial> trials_;
};

}  // namespace geolloyd
