#include "core/surface/cells/cells.h"

namespace geolloyd {
namespace {

template <class T>
void remove_from(std::vector<T>& values, std::span<const std::uint8_t> is_removed) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_removed[i] == 0) values[kept++] = values[i];
  }
  values.resize(kept);
}

}  // namespace

void Cells::assign(std::span<const MetricMoments> sums) {
  moments.resize(sums.size());
  metric.resize(sums.size());
  for (std::size_t r = 0; r < sums.size(); ++r) {
    moments[r] = sums[r].moments;
    metric[r] = sums[r].metric;
  }
}

void Cells::add_empty() {
  moments.emplace_back();
  if (!metric.empty()) metric.emplace_back();
}

void Cells::remove(std::span<const std::uint8_t> is_removed) {
  remove_from(moments, is_removed);
  remove_from(metric, is_removed);
}

}  // namespace geolloyd
