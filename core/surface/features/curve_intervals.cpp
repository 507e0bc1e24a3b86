#include "core/surface/features/curve_intervals.h"

#include <algorithm>

namespace geolloyd {
namespace {

using Edge = std::array<VertexId, 2>;

class CurveIntervals {
 public:
  CurveIntervals(const FineMesh& mesh, std::span<const Edge> features, double spacing,
                 std::vector<FeatureCurve>& curves)
      : mesh_(mesh), features_(features), spacing_(spacing), curves_(curves) {}

  void run() {
    widen_acute_corners();
    std::vector<Edge> ends;
    for (const FeatureCurve& curve : curves_) ends.push_back(ends_of(curve));
    std::sort(ends.begin(), ends.end());
    for (FeatureCurve& curve : curves_) {
      const auto same = std::equal_range(ends.begin(), ends.end(), ends_of(curve));
      const bool is_alone = same.second - same.first == 1;
      curve.least_intervals = ends_of(curve)[0] == ends_of(curve)[1] ? 3 : is_alone ? 1 : 2;
      curve.of_chords = length_of_chords(curve);
      if (is_feature(curve)) follow_curve(curve);
    }
  }

 private:
  // An end of a curve, as its corner sees it.
  struct End {
    VertexId corner;
    Vec3 direction;
    double* step;
  };

  // Of an angle t, two curves with even sites would span triangles whose smallest angle is less
  // than t: those that the first sites, at a distance of 1, make with the second at a distance
  // of r, if r > 2 cos t.
  void widen_acute_corners() {
    std::vector<End> ends;
    for (FeatureCurve& curve : curves_) {
      if (curve.is_loop) continue;
      const std::size_t last = curve.vertices.size() - 1;
      ends.push_back({curve.vertices[0], direction(curve, 0, 1), &curve.first_step});
      ends.push_back({curve.vertices[last], direction(curve, last, last - 1), &curve.last_step});
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const End& a, const End& b) { return a.corner < b.corner; });
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = i + 1; j < ends.size() && ends[j].corner == ends[i].corner; ++j) {
        constexpr double acute_cosine = 0.8;  // of 37 degrees
        const double cosine = dot(ends[i].direction, ends[j].direction);
        if (cosine < acute_cosine) continue;
        for (double* step : {ends[i].step, ends[j].step}) {
          *step = std::max(*step, 1 / (2 * cosine - 1));
        }
      }
    }
  }

  // The length of the straight lines that join even places, about a spacing apart; counted by the
  // inverse sizing.
  [[nodiscard]] double length_of_chords(const FeatureCurve& curve) const {
    const std::size_t count = curve.intervals_in(curve.length(), spacing_);
    const auto place = [&](double i) { return curve.length() * i / static_cast<double>(count); };
    double sum = 0;
    Vec3 last = mesh_.positions[curve.vertices.front()];
    for (std::size_t i = 1; i <= count; ++i) {
      const auto end = static_cast<double>(i);
      const Vec3 next = curve.point_at(mesh_, place(end));
      sum += curve.sized_length(mesh_, place(end - 0.5), next - last);
      last = next;
    }
    return sum;
  }

  [[nodiscard]] bool is_feature(const FeatureCurve& curve) const {
    return std::binary_search(features_.begin(), features_.end(),
                              ascending(curve.vertices[0], curve.vertices[1]));
  }

  // Up to half as many intervals again where chords would leave the curve by much.
  void follow_curve(FeatureCurve& curve) const {
    constexpr double most_sag = 0.09;  // of a chord's length
    const std::size_t ordinary = curve.intervals(spacing_);
    const std::size_t most = std::min(ordinary + ordinary / 2, curve.vertices.size() - 1);
    std::size_t count = ordinary;
    while (count < most && largest_sag(curve, count) > most_sag) ++count;
    if (count > ordinary) curve.of_chords = static_cast<double>(count) * spacing_;
  }
  [[nodiscard]] double largest_sag(const FeatureCurve& curve, std::size_t intervals) const {
    double largest = 0;
    for (std::size_t i = 0; i < intervals; ++i) {
      const double from = curve.place(i, intervals);
      const double to = curve.place(i + 1, intervals);
      const Vec3 a = curve.point_at(mesh_, from);
      const Vec3 b = curve.point_at(mesh_, to);
      const Vec3 middle = curve.point_at(mesh_, (from + to) / 2);
      const double sag = curve.sized_length(mesh_, (from + to) / 2, middle - (a + b) / 2);
      largest = std::max(largest, sag / (to - from));
    }
    return largest;
  }
  [[nodiscard]] Vec3 direction(const FeatureCurve& curve, std::size_t from, std::size_t to) const {
    return normalized(mesh_.positions[curve.vertices[to]] - mesh_.positions[curve.vertices[from]]);
  }

  static Edge ends_of(const FeatureCurve& curve) {
    return ascending(curve.vertices.front(), curve.vertices.back());
  }

  const FineMesh& mesh_;
  std::span<const Edge> features_;
  double spacing_;
  std::vector<FeatureCurve>& curves_;
};

}  // namespace

void find_curve_intervals(const FineMesh& mesh, std::span<const std::array<VertexId, 2>> features,
                          double spacing, std::vector<FeatureCurve>& curves) {
  CurveIntervals(mesh, features, spacing, curves).run();
}

}  // namespace geolloyd
