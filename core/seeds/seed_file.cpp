#include "core/seeds/seed_file.h"

#include <algorithm>
#include <memory>
#include <nanoflann.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

#include "core/seeds/seeds.h"
#include "core/text/text_cursor.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

/// Nearest node to a point.
class NodeLocator {
 public:
  explicit NodeLocator(const std::vector<Vec3>& positions)
      : points_{positions}, tree_(3, points_, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {}

  [[nodiscard]] NodeId nearest(const Vec3& p) const {
    NodeId node = no_id;
    double squared_distance = 0;
    tree_.knnSearch(p.data(), 1, &node, &squared_distance);
    return node;
  }

 private:
  // What nanoflann wants to see of the points; the names are its own.
  struct Points {
    const std::vector<Vec3>& positions;
    // NOLINTBEGIN(readability-identifier-naming)
    [[nodiscard]] std::size_t kdtree_get_point_count() const { return positions.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
      return positions[i][static_cast<Eigen::Index>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
      return false;
    }
    // NOLINTEND(readability-identifier-naming)
  };
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>,
                                                   Points, 3, NodeId>;

  Points points_;
  Tree tree_;
};

class SeedReader {
 public:
  SeedReader(std::string_view text, std::string_view name, const MeshGraph& mesh_graph)
      : cursor_(text, name), mesh_graph_(mesh_graph) {}

  std::vector<NodeId> read() {
    cursor_.skip_empty_lines('#');
    const Form form = find_form();
    for (; !cursor_.at_end(); cursor_.skip_empty_lines('#')) {
      add(form == Form::positions ? node_at_position() : node_of_id(form == Form::table));
      cursor_.next_line();
    }
    if (seeds_.empty()) cursor_.fail("no seeds in this file");
    return std::move(seeds_);
  }

 private:
  enum class Form { ids, positions, table };

  Form find_form() {
    TextCursor ahead = cursor_;
    if (ahead.word() == "input_id") {
      columns_ = words_in_line();
      cursor_.next_line();
      cursor_.skip_empty_lines('#');
      return Form::table;
    }
    return ahead.at_line_end() ? Form::ids : Form::positions;
  }

  // On this line, from here on.
  [[nodiscard]] std::size_t words_in_line() const {
    TextCursor ahead = cursor_;
    std::size_t count = 0;
    while (!ahead.word().empty()) ++count;
    return count;
  }

  void check_columns() const {
    const std::size_t values = words_in_line();
    if (values == columns_) return;
    cursor_.fail(std::to_string(values) + " values where the table has " +
                 std::to_string(columns_) + " columns: is the file complete?");
  }

  NodeId node_of_id(bool table) {
    if (table) check_columns();
    const std::int64_t id = cursor_.integer("an input id");
    const auto count = static_cast<std::int64_t>(mesh_graph_.node_of.size());
    if (id < 0 || id >= count) {
      cursor_.fail("input id " + std::to_string(id) + " is none of this graph's, which are 0 to " +
                   std::to_string(count - 1));
    }
    if (table) {
      check_kind(static_cast<std::uint32_t>(id));
    } else if (!cursor_.at_line_end()) {
      cursor_.fail("expected one input id");
    }
    const NodeId node = mesh_graph_.node_of[static_cast<std::size_t>(id)];
    if (node == no_id) {
      cursor_.fail("input id " + std::to_string(id) +
                   " has no region: a vertex of no triangle, or a triangle naming a vertex twice");
    }
    return node;
  }

  void check_kind(std::uint32_t id) {
    const std::string_view expected = mesh_graph_.is_triangle(id) ? "triangle" : "vertex";
    const std::string_view kind = cursor_.word();
    if (kind != expected) {
      cursor_.fail("seed of kind " + in_quotes(kind) + " where this graph has a " +
                   std::string(expected) + ": these seeds belong to another kind of graph");
    }
  }

  NodeId node_at_position() {
    Vec3 p;
    for (double& coordinate : p) {
      coordinate = cursor_.real("a coordinate");
      if (!is_usable(coordinate)) cursor_.fail("coordinate is not a finite number of usable size");
    }
    if (!cursor_.at_line_end()) cursor_.fail("expected three coordinates");
    if (!locator_) locator_ = std::make_unique<NodeLocator>(mesh_graph_.position);
    return locator_->nearest(p);
  }

  void add(NodeId node) {
    const auto [first, is_new] = line_of_.emplace(node, cursor_.line());
    if (!is_new) {
      cursor_.fail("the same node as the seed on line " + std::to_string(first->second) +
                   ": remove one of the two");
    }
    seeds_.push_back(node);
  }

  TextCursor cursor_;
  const MeshGraph& mesh_graph_;
  std::unique_ptr<NodeLocator> locator_;
  std::unordered_map<NodeId, std::size_t> line_of_;
  std::vector<NodeId> seeds_;
  std::size_t columns_ = 0;  // of a table
};

}  // namespace

std::vector<NodeId> parse_seeds(std::string_view text, std::string_view name,
                                const MeshGraph& mesh_graph, const Components& components) {
  std::string words(text);
  std::replace(words.begin(), words.end(), ',', ' ');
  std::vector<NodeId> seeds = SeedReader(words, name, mesh_graph).read();
  check_every_component_has_a_seed(name, mesh_graph, components, seeds);
  return seeds;
}

std::size_t most_seeds(std::string_view text) {
  TextCursor cursor(text, "");
  std::size_t lines = 0;
  for (cursor.skip_empty_lines('#'); !cursor.at_end(); cursor.skip_empty_lines('#')) {
    cursor.next_line();
    ++lines;
  }
  return lines;
}

}  // namespace geolloyd
