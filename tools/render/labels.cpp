#include "tools/render/labels.h"

#include <cmath>

#include "core/regions/tessellation.h"

namespace geolloyd {
namespace {

// Easy to tell apart side by side.
constexpr std::array<Colour, 8> palette = {{{78, 121, 167},
                                            {242, 142, 43},
                                            {89, 161, 79},
                                            {225, 87, 89},
                                            {176, 122, 161},
                                            {237, 201, 72},
                                            {118, 183, 178},
                                            {156, 117, 95}}};
constexpr Label no_region = {no_colour, -1};

// The palette, and beyond it pastel hues a golden angle apart.
Colour colour_of(std::uint32_t number) {
  if (number < palette.size()) return palette[number];
  const double hue = 2.399963229728653 * number;
  const auto channel = [hue](double phase) {
    return static_cast<std::uint8_t>(160 + 90 * std::cos(hue + phase));
  };
  return {channel(0), channel(2.0944), channel(4.1888)};
}

}  // namespace

std::vector<Colour> colours_of_regions(const Graph& graph, const Partition& partition,
                                       std::size_t region_count) {
  std::vector<Colour> colours;
  colours.reserve(region_count);
  for (const std::uint32_t number : colour_regions(region_count, adjacent_regions(graph, partition),
                                                   static_cast<std::uint32_t>(palette.size()))) {
    colours.push_back(colour_of(number));
  }
  return colours;
}

std::vector<Label> label_input_ids(const MeshGraph& mesh_graph, const Partition& partition,
                                   std::size_t region_count) {
  const std::vector<Colour> colours = colours_of_regions(mesh_graph.graph, partition, region_count);
  std::vector<Label> labels;
  labels.reserve(mesh_graph.node_of.size());
  for (const NodeId node : mesh_graph.node_of) {
    const RegionId region = node == no_id ? no_id : region_of(partition.key[node]);
    labels.push_back(region == no_id ? no_region
                                     : Label{colours[region], static_cast<std::int32_t>(region)});
  }
  return labels;
}

}  // namespace geolloyd
