#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace geolloyd {

/// The parts of a glTF 2.0 file: the JSON, and the bytes of its buffers. All that is asked for is
/// checked, and complaints name the part, "accessors[3]".
class GltfDocument {
 public:
  /// `bytes` is a .glb or a .gltf file, told by its first bytes, and must live on, as must `name`.
  /// `folder` has the buffers that are files of their own; null: there may be none. Throws
  /// InvalidInput.
  GltfDocument(std::string_view bytes, std::string_view name, const std::filesystem::path* folder);

  [[nodiscard]] bool is_binary() const { return is_binary_; }
  [[nodiscard]] const nlohmann::json& root() const { return root_; }
  /// How many objects the array of this name has; 0 where there is none.
  [[nodiscard]] std::size_t count(const char* array) const;
  /// "accessors", 3.
  [[nodiscard]] const nlohmann::json& at(const char* array, std::size_t index) const;

  /// A whole number from 0 to 2^53 of an object that is called `what` in messages; `otherwise`
  /// where it is not there, or a complaint where that is nothing.
  [[nodiscard]] std::uint64_t number(const nlohmann::json& object, const char* key,
                                     const std::string& what,
                                     std::optional<std::uint64_t> otherwise = {}) const;

  /// The bytes of a buffer view.
  [[nodiscard]] std::string_view view(std::size_t index);

  /// Bytes of the file, and of the buffers beside it that were read so far.
  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// Throws InvalidInput "NAME: WHAT: MESSAGE".
  [[noreturn]] void fail(const std::string& what, const std::string& message) const;

 private:
  void read_chunks(std::string_view bytes);
  void parse(std::string_view text, std::size_t offset);
  void check_version() const;
  std::string_view buffer(std::size_t index);
  std::string_view load(std::size_t index, const std::string& address, const std::string& what);
  std::string_view read_beside(const std::string& address, const std::string& what);

  std::string_view name_;
  const std::filesystem::path* folder_;
  nlohmann::json root_;
  bool is_binary_ = false;
  std::optional<std::string_view> chunk_;     ///< the buffer of a .glb file
  std::map<std::size_t, std::string> data_;   ///< of buffers whose address holds it
  std::map<std::string, std::string> files_;  ///< beside this one, by address
  std::uint64_t size_;
};

/// "accessors[3]".
std::string part_name(const char* array, std::size_t index);

}  // namespace geolloyd
