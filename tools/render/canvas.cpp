#include "tools/render/canvas.h"

#include <algorithm>
#include <cmath>

#include "core/base/bucketing.h"

namespace geolloyd {
namespace {

constexpr int band_rows = 24;  // of samples, drawn by one thread
constexpr double full = 255;

struct Range {
  int begin;
  int end;
};

// Of columns or rows whose samples are within `reach` of something that goes from a to b.
Range near(double a, double b, double reach, int count) {
  const auto to_sample = [&](double pixels) {
    return static_cast<int>(
        std::clamp(std::floor(pixels * SampleGrid::per_side), 0.0, static_cast<double>(count)));
  };
  return {to_sample(std::min(a, b) - reach), to_sample(std::max(a, b) + reach + 1)};
}

// Much faster than std::hypot, which cares for numbers that no picture has.
double length(double x, double y) {
  return std::sqrt(x * x + y * y);
}

double reach_of(const Stroke& stroke) {
  return stroke.half_width + 1.0 / SampleGrid::per_side;
}

// How far below the surface a stroke is still seen: it is flat and as wide as it is, and an arc
// between two nodes cuts through what bends between them.
double tolerance_of(const Stroke& stroke) {
  return 1 + 3 * stroke.half_width + 0.3 * norm(stroke.to - stroke.from);
}

class Band {
 public:
  Band(const Scene& scene, int first_row)
      : scene_(scene),
        columns_(scene.grid.columns()),
        first_(first_row),
        last_(std::min(first_row + band_rows, scene.grid.rows())),
        coverage_(static_cast<std::size_t>(last_ - first_) * static_cast<std::size_t>(columns_)) {}

  void add(const Stroke& stroke) {
    const double reach = reach_of(stroke);
    const Range rows = near(stroke.from.y(), stroke.to.y(), reach, scene_.grid.rows());
    const Range columns = near(stroke.from.x(), stroke.to.x(), reach, columns_);
    const Vec3 along = stroke.to - stroke.from;
    const double flat_square = along.x() * along.x() + along.y() * along.y();
    const double tolerance = tolerance_of(stroke);
    for (int row = std::max(rows.begin, first_); row < std::min(rows.end, last_); ++row) {
      const double dy = SampleGrid::place(row) - stroke.from.y();
      for (int column = columns.begin; column < columns.end; ++column) {
        const double dx = SampleGrid::place(column) - stroke.from.x();
        const double t = flat_square > 0
                             ? std::clamp((dx * along.x() + dy * along.y()) / flat_square, 0.0, 1.0)
                             : 0.0;
        const double off = length(dx - t * along.x(), dy - t * along.y());
        const double covered =
            std::clamp((stroke.half_width - off) * SampleGrid::per_side + 0.5, 0.0, 1.0);
        if (covered == 0) continue;
        const std::size_t sample = scene_.grid.index(column, row);
        if (stroke.from.z() + t * along.z() > scene_.hit[sample].z + tolerance) continue;
        std::uint8_t& most = coverage_[sample - scene_.grid.index(0, first_)];
        most = std::max(most, static_cast<std::uint8_t>(covered * full));
      }
    }
  }

  void blend_into(Canvas& canvas, const Ink& ink) const {
    const std::size_t offset = scene_.grid.index(0, first_);
    for (std::size_t i = 0; i < coverage_.size(); ++i) {
      if (coverage_[i] == 0) continue;
      Colour& colour = canvas[offset + i];
      colour = blend(colour, ink.colour, ink.opacity * coverage_[i] / full);
    }
  }

 private:
  const Scene& scene_;
  int columns_;
  int first_;
  int last_;
  std::vector<std::uint8_t> coverage_;  // the most of any stroke
};

std::uint32_t pixel_at(const Scene& scene, const Canvas& canvas, int x, int y) {
  constexpr unsigned samples = SampleGrid::per_side * SampleGrid::per_side;
  unsigned hits = 0;
  std::array<unsigned, 3> sum = {0, 0, 0};
  for (int row = y * SampleGrid::per_side; row < (y + 1) * SampleGrid::per_side; ++row) {
    for (int i = 0; i < SampleGrid::per_side; ++i) {
      const std::size_t sample = scene.grid.index(x * SampleGrid::per_side + i, row);
      if (scene.hit[sample].triangle == no_id) continue;
      ++hits;
      for (std::size_t c = 0; c < 3; ++c) sum[c] += canvas[sample][c];
    }
  }
  const auto channel = [](unsigned total) { return (total + samples / 2) / samples; };
  return channel(255 * hits) << 24 | channel(sum[0]) << 16 | channel(sum[1]) << 8 | channel(sum[2]);
}

}  // namespace

Colour blend(const Colour& under, const Colour& over, double part) {
  Colour result{};
  for (std::size_t c = 0; c < 3; ++c) {
    result[c] = static_cast<std::uint8_t>(under[c] + part * (over[c] - under[c]));
  }
  return result;
}

void draw(std::span<const Stroke> strokes, const Ink& ink, const Scene& scene, Canvas& canvas,
          Executor& executor) {
  const int rows = scene.grid.rows();
  const auto bands = static_cast<std::size_t>((rows + band_rows - 1) / band_rows);
  const auto by_band =
      bucket_sort<std::uint32_t>(executor, bands, strokes.size(), [&](std::size_t i, auto&& put) {
        const Stroke& stroke = strokes[i];
        const Range range = near(stroke.from.y(), stroke.to.y(), reach_of(stroke), rows);
        for (int row = range.begin; row < range.end; row += band_rows - row % band_rows) {
          put(static_cast<std::size_t>(row / band_rows), static_cast<std::uint32_t>(i));
        }
      });
  parallel_for(executor, bands, 1, [&](std::size_t b) {
    if (by_band[b].empty()) return;
    Band band(scene, static_cast<int>(b) * band_rows);
    for (const std::uint32_t i : by_band[b]) band.add(strokes[i]);
    band.blend_into(canvas, ink);
  });
}

Pixels to_pixels(const Scene& scene, const Canvas& canvas, Executor& executor) {
  const Size size = scene.grid.size;
  Pixels pixels{size, {}};
  pixels.argb.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  parallel_for(executor, static_cast<std::size_t>(size.height), 1, [&](std::size_t y) {
    for (int x = 0; x < size.width; ++x) {
      pixels.argb[y * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)] =
          pixel_at(scene, canvas, x, static_cast<int>(y));
    }
  });
  return pixels;
}

}  // namespace geolloyd
