#include "tools/view/http/http_server.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/stopwatch.h"
#include "geolloyd/errors.h"
#include "tools/view/http/http_connection.h"

namespace geolloyd {
namespace {

using boost::asio::ip::tcp;

constexpr std::chrono::milliseconds between_looks(100);
constexpr std::chrono::milliseconds after_failure(200);
constexpr int most_waiting = 1024;  // connections that were not accepted yet

std::chrono::milliseconds milliseconds_of(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000));
}

}  // namespace

class HttpServer::Loop {
 public:
  explicit Loop(HttpServerOptions options)
      : options_(std::move(options)), acceptor_(context_), look_(context_), retry_(context_) {
    const tcp::endpoint here(boost::asio::ip::address_v4::loopback(), 0);
    boost::system::error_code error;
    acceptor_.open(here.protocol(), error);
    if (!error) acceptor_.bind(here, error);
    if (!error) acceptor_.listen(most_waiting, error);
    if (error) throw IoError("127.0.0.1: cannot listen there: " + error.message());
    port_ = acceptor_.local_endpoint().port();
  }

  [[nodiscard]] std::uint16_t port() const { return port_; }

  void serve(HttpSite& site) {
    HttpConnection::Owner owner{
        site, milliseconds_of(options_.patience_seconds), [this] { since_seen_ = Stopwatch(); },
        [this] { return count(HttpConnection::Stage::listening) < most_listeners; },
        [this](const auto& connection) { gone(connection); }};
    owner_ = &owner;
    since_seen_ = Stopwatch();
    accept();
    look_around();
    context_.run();
    owner_ = nullptr;
  }

  void notify() {
    boost::asio::post(context_, [this] {
      for (const Connection& connection : connections_) connection->tell_state();
    });
  }

 private:
  using Connection = std::shared_ptr<HttpConnection>;

  [[nodiscard]] std::size_t count(HttpConnection::Stage stage) const {
    return static_cast<std::size_t>(
        std::count_if(connections_.begin(), connections_.end(),
                      [stage](const Connection& c) { return c->stage() == stage; }));
  }

  void accept() {
    if (is_accepting_ || !acceptor_.is_open()) return;
    is_accepting_ = true;
    acceptor_.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
      is_accepting_ = false;
      if (!acceptor_.is_open()) return;
      if (error) {
        accept_later();
      } else {
        admit(std::move(socket));
      }
    });
  }

  // Where the process may open no more files, say.
  void accept_later() {
    retry_.expires_after(after_failure);
    retry_.async_wait([this](const boost::system::error_code& error) {
      if (!error) accept();
    });
  }

  void admit(tcp::socket socket) {
    connections_.push_back(std::make_shared<HttpConnection>(std::move(socket), *owner_));
    connections_.back()->start();
    if (connections_.size() >= most_connections) make_room();
    if (connections_.size() < most_connections) accept();
  }

  // Those that are answered stay, and those whose request has come and was not read yet.
  void make_room() {
    const auto newest = connections_.end() - 1;
    auto leaving = std::find_if(connections_.begin(), newest, [](const Connection& c) {
      return c->stage() == HttpConnection::Stage::closing;
    });
    if (leaving == newest) {
      leaving = std::find_if(connections_.begin(), newest,
                             [](const Connection& c) { return c->is_silent(); });
    }
    if (leaving != newest) Connection(*leaving)->close();
  }

  void gone(const Connection& connection) {
    connections_.erase(std::remove(connections_.begin(), connections_.end(), connection),
                       connections_.end());
    accept();
  }

  void look_around() {
    if (count(HttpConnection::Stage::listening) > 0 || owner_->site.is_busy()) {
      since_seen_ = Stopwatch();
    }
    if (options_.should_end() || since_seen_.seconds() > options_.idle_seconds) {
      end();
      return;
    }
    look_.expires_after(between_looks);
    look_.async_wait([this](const boost::system::error_code& error) {
      if (!error) look_around();
    });
  }

  void end() {
    boost::system::error_code ignored;
    acceptor_.close(ignored);
    retry_.cancel();
    for (const Connection& connection : std::vector<Connection>(connections_)) connection->close();
    context_.stop();
  }

  HttpServerOptions options_;
  boost::asio::io_context context_{1};
  tcp::acceptor acceptor_;
  std::uint16_t port_ = 0;
  boost::asio::steady_timer look_;
  boost::asio::steady_timer retry_;
  const HttpConnection::Owner* owner_ = nullptr;
  std::vector<Connection> connections_;  // the oldest first
  bool is_accepting_ = false;
  Stopwatch since_seen_;
};

HttpServer::HttpServer(HttpServerOptions options)
    : loop_(std::make_unique<Loop>(std::move(options))) {}

HttpServer::~HttpServer() = default;

std::uint16_t HttpServer::port() const {
  return loop_->port();
}

void HttpServer::serve(HttpSite& site) {
  loop_->serve(site);
}

void HttpServer::notify() {
  loop_->notify();
}

}  // namespace geolloyd
