#include "tools/cli/suggestion.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace geolloyd {
namespace {

// Row i of the table has the distances of the first i letters of `a` from the beginnings of `b`.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> distance(a.size() + 1,
                                                 std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& least = distance[i][j];
      least = std::max(i, j);
      if (i == 0 || j == 0) continue;
      const bool differ = a[i - 1] != b[j - 1];
      least = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1,
                        distance[i - 1][j - 1] + (differ ? 1 : 0)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        least = std::min(least, distance[i - 2][j - 2] + 1);
      }
    }
  }
  return distance[a.size()][b.size()];
}

}  // namespace

std::string closest_name(std::string_view word, std::span<const std::string> names) {
  constexpr std::size_t longest = 64;  // nobody mistypes more than that
  if (word.size() > longest) return "";
  std::size_t least = word.size() / 3 + 1;
  std::string closest;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(word, name);
    if (distance >= least) continue;
    least = distance;
    closest = name;
  }
  return closest;
}

}  // namespace geolloyd
