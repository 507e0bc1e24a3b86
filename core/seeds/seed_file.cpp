#include "core/seeds/seed_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/seeds/seeds.h"
#include "core/text/text_cursor.h"
#include "geolloyd/errors.h"

namespace geolloyd {
namespace {

constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};

class SeedReader {
 public:
  SeedReader(std::string_view text, std::string_view name, SeedsBy by, const MeshGraph& mesh_graph)
      : cursor_(text, name), by_(by), mesh_graph_(mesh_graph) {}

  GivenSeeds read() {
    cursor_.skip_empty_lines('#');
    const Form form = find_form();
    for (; !cursor_.at_end(); cursor_.skip_empty_lines('#')) {
      if (!columns_.empty()) check_columns();
      if (form == Form::positions) {
        positions_.push_back(position());
      } else {
        add(node_of_id());
      }
      cursor_.next_line();
    }
    if (ids_.empty() && positions_.empty()) cursor_.fail("no seeds in this file");
    if (form == Form::ids) return {std::move(ids_), {}};
    NearestNodes nearest = nearest_nodes(mesh_graph_, positions_);
    return {std::move(nearest.nodes), nearest.fit};
  }

 private:
  enum class Form { ids, positions };

  Form find_form() {
    const std::vector<std::string_view> words = words_in_line();
    const bool has_ids = !words.empty() && words.front() == "input_id";
    if (has_ids || std::find(words.begin(), words.end(), axes[0]) != words.end()) {
      return find_form_of_table(words, has_ids);
    }
    if (words.size() > 1) return Form::positions;
    if (by_ == SeedsBy::position && !words.empty()) {
      cursor_.fail(
          "a list of input ids has no positions: give a seeds.csv, three coordinates a "
          "line, or a mesh");
    }
    return Form::ids;
  }

  Form find_form_of_table(const std::vector<std::string_view>& words, bool has_ids) {
    columns_ = words;
    const bool by_id = has_ids && by_ == SeedsBy::id;
    if (!by_id) find_axes();
    cursor_.next_line();
    cursor_.skip_empty_lines('#');
    return by_id ? Form::ids : Form::positions;
  }

  void find_axes() {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto found = std::find(columns_.begin(), columns_.end(), axes[i]);
      if (found == columns_.end()) {
        cursor_.fail("no column " + std::string(axes[i]) + ": seeds by position need x, y and z");
      }
      column_of_axis_[i] = static_cast<std::size_t>(found - columns_.begin());
    }
  }

  // On this line, from here on.
  [[nodiscard]] std::vector<std::string_view> words_in_line() const {
    TextCursor ahead = cursor_;
    std::vector<std::string_view> words;
    for (std::string_view word = ahead.word(); !word.empty(); word = ahead.word()) {
      words.push_back(word);
    }
    return words;
  }

  void check_columns() const {
    const std::size_t values = words_in_line().size();
    if (values == columns_.size()) return;
    cursor_.fail(std::to_string(values) + " values where the table has " +
                 std::to_string(columns_.size()) + " columns: is the file complete?");
  }

  NodeId node_of_id() {
    const std::int64_t id = cursor_.integer("an input id");
    const auto count = static_cast<std::int64_t>(mesh_graph_.node_of.size());
    if (id < 0 || id >= count) {
      cursor_.fail("input id " + std::to_string(id) + " is none of this graph's, which are 0 to " +
                   std::to_string(count - 1));
    }
    if (!columns_.empty()) {
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

  double coordinate(TextCursor& cursor) const {
    const double number = cursor.real("a coordinate");
    if (!is_usable(number)) cursor_.fail("coordinate is not a finite number of usable size");
    return number;
  }

  Vec3 position() {
    Vec3 p;
    if (!columns_.empty()) {
      for (std::size_t i = 0; i < axes.size(); ++i) {
        TextCursor cell = cursor_;
        for (std::size_t skipped = 0; skipped < column_of_axis_[i]; ++skipped) cell.word();
        p[static_cast<Eigen::Index>(i)] = coordinate(cell);
      }
      return p;
    }
    for (double& number : p) number = coordinate(cursor_);
    if (!cursor_.at_line_end()) cursor_.fail("expected three coordinates");
    return p;
  }

  void add(NodeId node) {
    const auto [first, is_new] = line_of_.emplace(node, cursor_.line());
    if (!is_new) {
      cursor_.fail("the same node as the seed on line " + std::to_string(first->second) +
                   ": remove one of the two");
    }
    ids_.push_back(node);
  }

  TextCursor cursor_;
  SeedsBy by_;
  const MeshGraph& mesh_graph_;
  std::unordered_map<NodeId, std::size_t> line_of_;
  std::vector<NodeId> ids_;
  std::vector<Vec3> positions_;
  std::vector<std::string_view> columns_;  // of a table, else none
  std::array<std::size_t, 3> column_of_axis_{};
};

}  // namespace

GivenSeeds parse_seeds(std::string_view text, std::string_view name, SeedsBy by,
                       const MeshGraph& mesh_graph, const Components& components) {
  std::string words(text);
  std::replace(words.begin(), words.end(), ',', ' ');
  GivenSeeds seeds = SeedReader(words, name, by, mesh_graph).read();
  check_every_component_has_a_seed(name, mesh_graph, components, seeds.nodes);
  return seeds;
}

GivenSeeds seeds_at(std::span<const Vec3> positions, std::string_view name,
                    const MeshGraph& mesh_graph, const Components& components) {
  if (positions.empty()) throw InvalidInput(std::string(name) + ": no vertices to take as seeds");
  NearestNodes nearest = nearest_nodes(mesh_graph, positions);
  check_every_component_has_a_seed(name, mesh_graph, components, nearest.nodes);
  return {std::move(nearest.nodes), nearest.fit};
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
