#include "core/properties/property_mixture.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include "core/base/loops.h"
#include "core/properties/properties.h"

namespace geolloyd {
namespace {

template <class Number>
bool have_same_bits(Number a, Number b) {
  using Bytes = std::array<std::byte, sizeof(Number)>;
  return std::bit_cast<Bytes>(a) == std::bit_cast<Bytes>(b);
}

// The value that all shares have, to the bit.
template <class Number>
std::optional<Number> common_value(const std::vector<Number>& values, const Mixture& mixture) {
  std::optional<Number> common;
  for (const auto& [item, weight] : mixture) {
    if (!(weight > 0)) continue;
    if (common && !have_same_bits(*common, values[item])) return std::nullopt;
    common = values[item];
  }
  return common;
}

template <class Number>
Number mean(const std::vector<Number>& values, const Mixture& mixture) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  double sum = 0;
  for (const auto& [item, weight] : mixture) {
    if (!(weight > 0)) continue;
    const auto value = static_cast<double>(values[item]);
    least = std::min(least, value);
    most = std::max(most, value);
    sum += weight * value;
  }
  if (!(least <= most)) sum = std::numeric_limits<double>::quiet_NaN();  // of no number
  if (sum < least) sum = least;
  if (sum > most) sum = most;
  if constexpr (std::is_integral_v<Number>) {
    return sum == sum ? static_cast<Number>(std::floor(sum + 0.5)) : Number{0};
  } else {
    return static_cast<Number>(sum);
  }
}

template <class Number>
Number majority(const std::vector<Number>& labels, const Mixture& mixture) {
  Number best{};
  double most = 0;
  for (const Share& candidate : mixture) {
    if (!(candidate.weight > 0)) continue;
    const Number label = labels[candidate.item];
    double votes = 0;
    for (const auto& [item, weight] : mixture) {
      if (weight > 0 && labels[item] == label) votes += weight;
    }
    if (votes > most || (votes == most && label < best)) {
      best = label;
      most = votes;
    }
  }
  return best;
}

Property mix(const Property& property, std::span<const Mixture> mixtures, Executor& executor) {
  const bool is_of_labels = is_label(property);
  return std::visit(
      [&](const auto& values) {
        std::remove_cvref_t<decltype(values)> mixed(mixtures.size());
        parallel_for(executor, mixtures.size(), small_items, [&](std::size_t i) {
          const auto common = common_value(values, mixtures[i]);
          mixed[i] = common         ? *common
                     : is_of_labels ? majority(values, mixtures[i])
                                    : mean(values, mixtures[i]);
        });
        return Property{property.name, std::move(mixed)};
      },
      property.values);
}

void set(Property& property, std::size_t i, double value) {
  std::visit(
      [&](auto& values) {
        values[i] = static_cast<ValueOf<std::remove_cvref_t<decltype(values)>>>(value);
      },
      property.values);
}

// What has no length or no usable one stays as it is.
void normalise_normals(std::vector<Property>& properties, std::size_t count, Executor& executor) {
  std::array<Property*, 3> normal{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (Property& property : properties) {
      if (property.name == normal_names[axis] && !has_integers(property)) normal[axis] = &property;
    }
    if (normal[axis] == nullptr) return;
  }
  parallel_for(executor, count, small_items, [&](std::size_t i) {
    const Vec3 n(value_at(*normal[0], i), value_at(*normal[1], i), value_at(*normal[2], i));
    const double length = norm(n);
    if (!(length > 0) || !std::isfinite(length)) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      set(*normal[axis], i, n[static_cast<Eigen::Index>(axis)] / length);
    }
  });
}

}  // namespace

Mixture mixture_at(std::span<const Triangle> triangles, const SurfacePoint& place) {
  Mixture mixture{};
  if (place.triangle == no_id) return mixture;
  for (std::size_t c = 0; c < 3; ++c) {
    mixture[c] = {triangles[place.triangle][c], place.barycentric[c]};
  }
  return mixture;
}

std::vector<Property> mix(std::span<const Property> properties, std::span<const Mixture> mixtures,
                          Executor& executor) {
  std::vector<Property> mixed;
  mixed.reserve(properties.size());
  for (const Property& property : properties) mixed.push_back(mix(property, mixtures, executor));
  normalise_normals(mixed, mixtures.size(), executor);
  return mixed;
}

}  // namespace geolloyd
