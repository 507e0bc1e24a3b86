#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/gmsh_numbers.h"
#include "core/formats/mesh_readers.h"

namespace geolloyd {
namespace {

// Nodes of each type of element, from type 1 on.
constexpr std::array<std::uint8_t, 31> node_counts = {2,  3,  4,  4, 8, 6,  5,  3,  6, 9,  10,
                                                      27, 18, 14, 1, 8, 20, 15, 13, 9, 10, 12,
                                                      15, 15, 21, 4, 5, 6,  20, 35, 56};
constexpr std::int64_t triangle_type = 2;
constexpr std::int64_t quadrilateral_type = 3;

// The vertices by the numbers that a file gives them.
class NodeIds {
 public:
  void add(std::uint64_t number, VertexId vertex) {
    ascends_ = ascends_ && (nodes_.empty() || nodes_.back().first < number);
    nodes_.emplace_back(number, vertex);
  }
  // False where a number is there twice.
  bool finish() {
    if (!ascends_) std::sort(nodes_.begin(), nodes_.end());
    const auto same = [](const Node& a, const Node& b) { return a.first == b.first; };
    return std::adjacent_find(nodes_.begin(), nodes_.end(), same) == nodes_.end();
  }
  // no_id where there is none.
  [[nodiscard]] VertexId find(std::uint64_t number) const {
    // Mostly they are 1, 2, 3...
    if (number - 1 < nodes_.size() && nodes_[number - 1].first == number) {
      return nodes_[number - 1].second;
    }
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), Node(number, 0));
    return found != nodes_.end() && found->first == number ? found->second : no_id;
  }

 private:
  using Node = std::pair<std::uint64_t, VertexId>;
  std::vector<Node> nodes_;
  bool ascends_ = true;
};

class GmshReader {
 public:
  GmshReader(std::string_view bytes, std::string_view name, const ReadOptions& options)
      : bytes_(bytes), name_(name), has_properties_(options.properties) {}

  ParsedMesh read() {
    read_format();
    if (is_fourth_) {
      read_nodes_4(section("$Nodes"));
    } else {
      read_nodes_2(section("$Nodes"));
    }
    if (!ids_.finish()) fail_at_byte(name_, begin_of("$Nodes"), "two nodes have one number");
    if (is_fourth_) {
      read_elements_4(section("$Elements"));
    } else {
      read_elements_2(section("$Elements"));
    }
    if (has_properties_) finish_properties();
    return std::move(loaded_);
  }

 private:
  void read_format() {
    TextCursor text(bytes_, name_);
    const std::string_view first = text.word();
    if (first != "$MeshFormat") text.fail_expected("'$MeshFormat'", first);
    text.next_line();
    const std::string_view version = text.word();
    if (version != "2.2" && version != "4.1" && version != "2" && version != "2.1") {
      text.fail("Gmsh's format " + in_quotes(version) + "; 2.2 and 4.1 are understood");
    }
    is_fourth_ = version == "4.1";
    const std::int64_t kind = text.integer("0 or 1, for text or binary");
    const std::int64_t size = text.integer("the size of a number");
    if (kind != 0 && kind != 1) text.fail("expected 0 or 1, for text or binary");
    is_binary_ = kind == 1;
    if (is_binary_ && size != 8) text.fail("numbers of 8 bytes are understood alone");
    loaded_.format =
        std::string("Gmsh ") + (is_fourth_ ? "4.1" : "2.2") + (is_binary_ ? ", binary" : ", ascii");
    if (!is_binary_) return;
    // A 1 tells the order of bytes.
    text.next_line();
    const std::size_t at = bytes_.size() - text.remaining();
    if (text.remaining() < 4) fail_at_byte(name_, at, "the file ends inside its first section");
    const auto one = load<std::int32_t>(bytes_.data() + at);
    order_ = one == 1 ? std::endian::little : std::endian::big;
    if (load<std::int32_t>(bytes_.data() + at, order_) != 1) {
      fail_at_byte(name_, at, "expected a 1 that tells the order of bytes");
    }
  }

  // Where the line behind a section's name begins.
  [[nodiscard]] std::size_t begin_of(const std::string& section) const {
    for (std::size_t at = bytes_.find(section); at != std::string_view::npos;
         at = bytes_.find(section, at + 1)) {
      const bool begins_line = at == 0 || bytes_[at - 1] == '\n' || bytes_[at - 1] == '\r';
      const std::size_t end = bytes_.find('\n', at);
      if (begins_line && end != std::string_view::npos) return end + 1;
    }
    fail_at_byte(name_, bytes_.size(), "the file has no section " + in_quotes(section));
  }

  [[nodiscard]] GmshNumbers section(const std::string& name) const {
    return {bytes_, begin_of(name), name_, is_binary_, order_};
  }

  void add_position(GmshNumbers& in, std::uint64_t number) {
    Vec3 position;
    for (double& coordinate : position) coordinate = in.coordinate();
    ids_.add(number, static_cast<VertexId>(loaded_.mesh.positions.size()));
    loaded_.mesh.positions.push_back(position);
  }

  void read_nodes_2(GmshNumbers in) {
    const std::uint64_t count = in.count_in_text("the number of nodes");
    in.check_count(count, 4, 28, "nodes");
    loaded_.mesh.positions.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::int64_t number = in.integer("the number of a node");
      add_position(in, static_cast<std::uint64_t>(number));
    }
  }

  void read_nodes_4(GmshNumbers in) {
    const std::uint64_t blocks = in.size("the number of blocks");
    for (int i = 0; i < 3; ++i) (void)in.size("a count of nodes");
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t block = 0; block < blocks; ++block) {
      const std::int64_t dimension = in.integer("a dimension");
      (void)in.integer("an entity");
      const std::int64_t parametric = in.integer("0 or 1");
      const std::uint64_t count = in.size("the number of nodes");
      in.check_count(count, 4, 32, "nodes");
      numbers.clear();
      for (std::uint64_t i = 0; i < count; ++i) numbers.push_back(in.size("the number of a node"));
      const bool has_parameters = parametric != 0 && dimension > 0 && dimension <= 3;
      for (const std::uint64_t number : numbers) {
        add_position(in, number);
        if (has_parameters) in.skip_reals(static_cast<std::uint64_t>(dimension));
      }
    }
  }

  void read_elements_2(GmshNumbers in) {
    const std::uint64_t count = in.count_in_text("the number of elements");
    in.check_count(count, 4, 8, "elements");
    for (std::uint64_t done = 0; done < count;) {
      // In binary files a header stands before elements of one type, in text each has its own.
      if (!is_binary_) (void)in.integer("the number of an element");
      const std::int64_t type = in.integer("the type of an element");
      std::int64_t in_block = 1;
      if (is_binary_) in_block = in.integer("the number of elements");
      const std::int64_t tags = in.integer("the number of tags");
      if (in_block < 1) in.fail("a block has " + std::to_string(in_block) + " elements");
      if (tags < 0) in.fail("an element has " + std::to_string(tags) + " tags");
      for (std::int64_t i = 0; i < in_block; ++i, ++done) {
        if (is_binary_) (void)in.integer("the number of an element");
        std::array<std::int64_t, 2> first_tags{};
        for (std::int64_t t = 0; t < tags; ++t) {
          const std::int64_t tag = in.integer("a tag");
          if (t < 2) first_tags[static_cast<std::size_t>(t)] = tag;
        }
        read_element(
            in, type, [&] { return in.integer("a node"); }, first_tags[0], first_tags[1]);
      }
    }
  }

  void read_elements_4(GmshNumbers in) {
    const std::uint64_t blocks = in.size("the number of blocks");
    for (int i = 0; i < 3; ++i) (void)in.size("a count of elements");
    for (std::uint64_t block = 0; block < blocks; ++block) {
      (void)in.integer("a dimension");
      const std::int64_t entity = in.integer("an entity");
      const std::int64_t type = in.integer("the type of elements");
      const std::uint64_t count = in.size("the number of elements");
      in.check_count(count, 2, 16, "elements");
      for (std::uint64_t i = 0; i < count; ++i) {
        (void)in.size("the number of an element");
        read_element(
            in, type, [&] { return static_cast<std::int64_t>(in.size("a node")); }, 0, entity);
      }
    }
  }

  template <class NextNode>
  void read_element(GmshNumbers& in, std::int64_t type, NextNode&& next_node, std::int64_t physical,
                    std::int64_t entity) {
    if (type < 1 || type > std::ssize(node_counts)) {
      in.fail("no element of type " + std::to_string(type) + " is known");
    }
    const std::size_t count = node_counts[static_cast<std::size_t>(type - 1)];
    const bool is_face = type == triangle_type || type == quadrilateral_type;
    corners_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t node = next_node();
      if (!is_face) continue;
      const VertexId vertex = ids_.find(static_cast<std::uint64_t>(node));
      if (vertex == no_id) in.fail("there is no node " + std::to_string(node));
      corners_.push_back(vertex);
    }
    if (!is_face) return;
    add_polygon(loaded_, corners_);
    if (!has_properties_) return;
    add_label(in, physical, physical_);
    add_label(in, entity, entity_);
  }

  static void add_label(const GmshNumbers& in, std::int64_t label,
                        std::vector<std::int32_t>& labels) {
    if (!std::in_range<std::int32_t>(label)) in.fail("a tag has more than 32 bits");
    labels.push_back(static_cast<std::int32_t>(label));
  }

  // Where all are equal, that says nothing.
  void finish_properties() {
    const auto add = [&](const char* name, std::vector<std::int32_t>& labels) {
      const bool differ =
          std::any_of(labels.begin(), labels.end(), [&](auto x) { return x != labels.front(); });
      if (differ) loaded_.properties.of_triangles.push_back({name, std::move(labels)});
    };
    add("physical", physical_);
    add("entity", entity_);
  }

  std::string_view bytes_;
  std::string_view name_;
  bool has_properties_;
  bool is_fourth_ = false;
  bool is_binary_ = false;
  std::endian order_ = std::endian::little;
  ParsedMesh loaded_;
  NodeIds ids_;
  std::vector<VertexId> corners_;
  std::vector<std::int32_t> physical_;
  std::vector<std::int32_t> entity_;
};

}  // namespace

ParsedMesh read_gmsh(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  return GmshReader(bytes, name, options).read();
}

}  // namespace geolloyd
