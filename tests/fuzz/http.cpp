// Requests to a viewer's session: bytes 0xff stand between them. One that passes the guard is
// answered by a session on a small mesh, the same for all of an input.
#include <algorithm>
#include <future>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/mesh_check.h"
#include "core/mesh/mesh_edges.h"
#include "core/shapes/shapes.h"
#include "geolloyd/threads.h"
#include "tests/fuzz/target.h"
#include "tools/view/http/http_reader.h"
#include "tools/view/http/http_site.h"

namespace geolloyd::fuzz {
namespace {

const HttpGuard guard{8080, "0123456789abcdef0123456789abcdef"};

// What a request is made on.
struct Served {
  Served() : model(input(), options(), {}, threads), session(model, [] {}) {}

  static LoadedInput input() {
    LoadedInput loaded;
    loaded.input.file = "input.ply";
    loaded.input.loaded.mesh = icosphere(80);
    loaded.edges = find_edges(loaded.input.mesh());
    loaded.input.facts = check_mesh(loaded.input.mesh(), loaded.edges);
    return loaded;
  }

  static SessionOptions options() {
    SessionOptions options;
    options.seeds.count = 4;
    options.seeds.init = SeedInit::random;
    return options;
  }

  Threads threads{1};
  SessionModel model;
  Session session;
  HttpSite site{guard, {"index", "script", "style"}, session};
};

// A remesh takes as long as it has vertices, and that is no fault.
bool takes_long(const HttpRequest& request) {
  constexpr std::size_t enough = 40;
  try {
    const SessionCommand command = parse_command(request.body);
    return command.action == Action::remesh && command.vertices > enough;
  } catch (const InvalidInput&) {
    return false;
  }
}

void require_line(const Json& text) {
  require(text.is_string(), "an error is a text");
  for (const char c : text.get<std::string>()) require(c >= ' ', "an error is one line");
}

void require_sound(const HttpResponse& response) {
  const std::string head = http_head(response);
  require(head.starts_with("HTTP/1.1 ") && head.ends_with("\r\n\r\n"), "a response has a head");
  require(head.find("\r\n\r\n") == head.size() - 4, "a head ends once");
  require(head.find("Access-Control") == std::string::npos, "no other origin is let in");
  if (response.status != 200) require_line(Json::parse(response.body)["error"]);
}

// In pieces of this size.
void read(HttpReader& reader, std::string_view bytes, std::size_t piece) {
  while (!bytes.empty() && !reader.put(bytes.substr(0, piece))) {
    bytes.remove_prefix(std::min(piece, bytes.size()));
  }
}

void serve(std::string_view bytes, std::size_t piece, std::unique_ptr<Served>& served) {
  HttpReader reader;
  read(reader, bytes, piece);
  if (reader.refusal()) {
    require_sound(*reader.refusal());
    return;
  }
  if (!reader.is_complete()) return;
  const HttpRequest request = reader.take();
  if (const auto refusal = refuse(request, guard)) {
    require_sound(*refusal);
    return;
  }
  if (takes_long(request)) return;
  if (!served) served = std::make_unique<Served>();
  const auto promise = std::make_shared<std::promise<HttpResponse>>();
  served->site.answer(
      request, [promise](HttpResponse response) { promise->set_value(std::move(response)); });
  require_sound(promise->get_future().get());
  const Json state = Json::parse(served->session.state());
  require(state["seeds"].get<std::size_t>() > 0, "a session has seeds");
}

}  // namespace
}  // namespace geolloyd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace geolloyd::fuzz;
  if (size == 0) return 0;
  const std::size_t piece = data[0] < 128 ? size : data[0] - 127U;
  std::string_view text = text_of(data + 1, size - 1);
  std::unique_ptr<Served> served;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\xff'), text.size());
    serve(text.substr(0, end), piece, served);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return 0;
}
