#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/surface/fit/fit_functional.h"
#include "core/surface/flips/glide_patch.h"

namespace geolloyd {

/// Some samples of a surface.
class PartSamples final : public SampleSet {
 public:
  void add(const Sample& sample, std::uint32_t id) {
    samples_.push_back(sample);
    ids_.push_back(id);
  }
  [[nodiscard]] std::size_t size() const override { return samples_.size(); }
  [[nodiscard]] Sample operator[](std::size_t i) const override { return samples_[i]; }
  [[nodiscard]] std::uint32_t id(std::size_t i) const { return ids_[i]; }

 private:
  std::vector<Sample> samples_;
  std::vector<std::uint32_t> ids_;  // per sample: of the surface
};

/// The fit of a region of a patch, with the functional of the whole remesh and those samples of
/// the surface that are nearest to the region.
class PatchFit {
 public:
  PatchFit(const GlidingRemesh& remesh, const GlidePatch& patch, const GlidePatch::Region& region);
  PatchFit(const PatchFit&) = delete;
  PatchFit& operator=(const PatchFit&) = delete;

  /// The functional, over the price of a triangle's strain.
  [[nodiscard]] double value() const { return functional_.value() / part_.whole.price; }
  /// Of that, what distances have a part in.
  [[nodiscard]] double distances() const { return functional_.distances() / part_.whole.price; }
  /// One round.
  void relax(int iterations);
  /// The cosine of the smallest angle.
  [[nodiscard]] double sharpest_cosine() const;
  /// The least cosine between a triangle's normal and one of its corners'.
  [[nodiscard]] double least_cosine() const;
  /// Of all samples.
  [[nodiscard]] double largest_square_distance() const;

  /// How far a vertex has moved along its normal.
  [[nodiscard]] double largest_rise() const;

  /// Vertices of the remesh, and where they are now.
  [[nodiscard]] std::vector<std::pair<VertexId, Vec3>> positions() const;
  /// Samples, each with the triangle of the remesh that it is nearest to now.
  [[nodiscard]] std::vector<std::pair<TriangleId, PlacedSample>> placed_samples() const;

 private:
  // A region as a remesh of its own.
  struct Part {
    Part(const GlidingRemesh& whole, const GlidePatch& patch, const GlidePatch::Region& region);
    void take_samples(const GlidePatch& patch, TriangleId t);
    [[nodiscard]] FitSetting setting() const;

    const GlidingRemesh& whole;
    std::vector<VertexId> vertex;  // per vertex: of the whole; those that do not move come first
    std::vector<TriangleId> triangle;  // per triangle: of the whole
    std::vector<double> area;          // per vertex: of a triangle, asked for
    std::size_t on_curves = 0;
    std::size_t held = 0;
    MovingRemesh remesh;
    PartSamples samples;
    std::vector<TriangleId> on;  // per sample
  };

  Part part_;
  MovingRemesh& remesh_;
  std::vector<Vec3> start_normals_;  // per vertex
  SampleProjection projection_;
  FitFunctional functional_;
};

}  // namespace geolloyd
