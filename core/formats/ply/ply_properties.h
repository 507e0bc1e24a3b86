#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/ply/ply_body.h"
#include "core/formats/ply/ply_header.h"
#include "core/text/text_cursor.h"
#include "geolloyd/mesh.h"

namespace geolloyd {

/// The numbers of one element that become properties of a mesh. Lists, and names that come again,
/// do not, nor more than 256 of them.
class PlyColumnGroup {
 public:
  /// None: nothing is read.
  PlyColumnGroup() = default;
  /// `what` is "vertices" or "faces"; `known`: properties that are read otherwise. Says what is
  /// left out.
  PlyColumnGroup(const PlyElement& element, std::span<const std::size_t> known,
                 const std::string& what, std::vector<std::string>& left_out);

  /// Reads all columns of the rows that begin at `start`; the body is then where it was before.
  void read(PlyBody& body, std::size_t start);
  /// Reads the next value of the element's property; false, and nothing is read, where it is none
  /// of ours.
  bool read(TextCursor& text, std::size_t property);

  [[nodiscard]] std::vector<Property> take() && { return std::move(columns_); }

 private:
  std::vector<Property> columns_;
  const PlyElement* element_ = nullptr;
  std::vector<std::size_t> property_of_;  // per column
  std::vector<std::uint32_t> column_of_;  // per property of the element; no_id: none
};

/// All of a file.
class PlyColumns {
 public:
  /// `header` must live on.
  PlyColumns(const PlyHeader& header, const ReadOptions& options);

  /// Those of the faces have a value per face, yet.
  [[nodiscard]] Properties take() &&;

  PlyColumnGroup of_vertices;
  PlyColumnGroup of_faces;

 private:
  void find_faces(const PlyHeader& header);

  std::vector<std::string> left_out_;
};

}  // namespace geolloyd
