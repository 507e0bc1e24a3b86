#include "tools/files/flat_map.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace geolloyd {
namespace {

using MessagePack = nlohmann::json;

// Takes what is found as it is found. Refuses maps in maps, so that nothing nests deeper than the
// stack is, and sets nothing aside before it is there, so that no size needs to be believed.
class FlatReader final : public nlohmann::json_sax<MessagePack> {
 public:
  FlatMap map;

  bool null() override { return false; }
  bool boolean(bool /*value*/) override { return false; }
  bool number_integer(number_integer_t /*value*/) override { return false; }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t& value) override {
    return put(std::vector<std::uint8_t>(value.begin(), value.end()));
  }
  bool start_object(std::size_t /*size*/) override { return !std::exchange(is_open_, true); }
  bool key(string_t& name) override {
    name_ = std::move(name);
    return true;
  }
  bool end_object() override { return true; }
  bool start_array(std::size_t /*size*/) override { return false; }
  bool end_array() override { return false; }
  bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& /*error*/) override {
    return false;
  }

 private:
  template <class Value>
  bool put(Value&& value) {
    return is_open_ && map.emplace(std::move(name_), std::forward<Value>(value)).second;
  }

  bool is_open_ = false;
  std::string name_;
};

struct ToJson {
  MessagePack operator()(const std::vector<std::uint8_t>& bytes) const {
    return MessagePack::binary(bytes);
  }
  template <class Value>
  MessagePack operator()(const Value& value) const {
    return value;
  }
};

}  // namespace

std::string encode(const FlatMap& map) {
  MessagePack json = MessagePack::object();
  for (const auto& [name, value] : map) json[name] = std::visit(ToJson{}, value);
  std::string bytes;
  MessagePack::to_msgpack(json, bytes);
  return bytes;
}

std::optional<FlatMap> decode(std::string_view bytes) {
  FlatReader reader;
  if (!MessagePack::sax_parse(bytes.begin(), bytes.end(), &reader,
                              MessagePack::input_format_t::msgpack)) {
    return std::nullopt;
  }
  return std::move(reader.map);
}

}  // namespace geolloyd
