#pragma once

#include <span>

#include "geolloyd/choices.h"

namespace geolloyd {

/// True where a space costs something in each direction of its plane, and not 10^12 times as much
/// in one as in another.
bool is_metric(const TangentSpace& space);

/// The mean of one to four spaces as metrics M = k1^2 t t^T + k2^2 b b^T, which may be given in
/// any order and with directions swapped or negated. All must be metrics. The result has the
/// principal directions.
///
/// Planes are turned into the plane of their mean normal. There M has a determinant and a shape, M
/// over the root of its determinant. The mean's determinant is the geometric mean of the
/// determinants; its shape is the sum of the shapes, scaled back to determinant 1. Of two metrics
/// that is the affine-invariant mean A#B (Bhatia, Positive Definite Matrices, ch. 4). Shapes form a
/// hyperboloid, and the scaled sum is their centroid on it (Galperin 1993), of any number of them.
/// A linear map of the plane takes the mean along. Unlike the
/// log-Euclidean mean it needs no logarithm, and no difference of nearly equal numbers: all entries
/// that decide are sums of squares.
TangentSpace metric_mean(std::span<const TangentSpace> spaces);

}  // namespace geolloyd
