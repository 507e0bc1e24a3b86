#include "tools/view/http/http_connection.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <utility>

namespace geolloyd {
namespace {

constexpr std::chrono::milliseconds between_states(50);
constexpr int most_silent_ticks = 100;  // then a beat says that the server is there
constexpr std::chrono::milliseconds to_drain(1000);
constexpr std::size_t most_drained_bytes = 2'000'000;

}  // namespace

HttpConnection::HttpConnection(boost::asio::ip::tcp::socket socket, const Owner& owner)
    : socket_(std::move(socket)),
      owner_(owner),
      deadline_(socket_.get_executor()),
      pace_(socket_.get_executor()) {}

void HttpConnection::start() {
  limit(owner_.patience);  // for the whole request, however slowly it drips
  read();
}

void HttpConnection::close() {
  if (std::exchange(is_closed_, true)) return;
  boost::system::error_code ignored;
  deadline_.cancel();
  pace_.cancel();
  socket_.close(ignored);
  owner_.closed(shared_from_this());
}

bool HttpConnection::is_silent() const {
  boost::system::error_code error;
  return stage_ == Stage::reading && socket_.available(error) == 0;
}

void HttpConnection::limit(std::chrono::milliseconds time) {
  deadline_.expires_after(time);
  deadline_.async_wait([self = shared_from_this()](const boost::system::error_code& error) {
    if (!error) self->close();
  });
}

void HttpConnection::read() {
  socket_.async_read_some(
      boost::asio::buffer(buffer_),
      [self = shared_from_this()](const boost::system::error_code& error, std::size_t bytes) {
        if (self->is_closed_) return;
        if (error) {
          self->close();
        } else if (self->reader_.put({self->buffer_.data(), bytes})) {
          self->answer();
        } else {
          self->read();
        }
      });
}

// The answer may come from the session's thread, and after the connection has gone.
void HttpConnection::answer() {
  stage_ = Stage::answering;
  deadline_.cancel();
  if (reader_.refusal()) {
    respond(*reader_.refusal());
    return;
  }
  const auto done = [self = shared_from_this()](HttpResponse response) {
    boost::asio::post(self->socket_.get_executor(), [self, response = std::move(response)] {
      if (!self->is_closed_) self->respond(response);
    });
  };
  if (owner_.site.answer(reader_.take(), done)) owner_.seen();
}

void HttpConnection::respond(const HttpResponse& response) {
  if (response.is_events && !owner_.may_listen()) {
    respond(http_error(503, "too many windows: close one"));
    return;
  }
  if (response.is_events) {
    stage_ = Stage::listening;
    has_news_ = true;
    send(http_head(response), &HttpConnection::listen);
    return;
  }
  send(http_head(response) + response.body, &HttpConnection::drain);
}

void HttpConnection::send(std::string text, void (HttpConnection::*then)()) {
  text_ = std::move(text);
  sent_ = 0;
  then_ = then;
  is_sending_ = true;
  send_rest();
}

void HttpConnection::send_rest() {
  limit(owner_.patience);
  socket_.async_write_some(
      boost::asio::buffer(text_.data() + sent_, text_.size() - sent_),
      [self = shared_from_this()](const boost::system::error_code& error, std::size_t bytes) {
        if (self->is_closed_) return;
        if (error) {
          self->close();
          return;
        }
        self->sent_ += bytes;
        if (self->sent_ < self->text_.size()) {
          self->send_rest();
          return;
        }
        self->is_sending_ = false;
        self->deadline_.cancel();
        ((*self).*(self->then_))();
      });
}

// What the other side still sends is taken, for a moment: else the response might be lost.
void HttpConnection::drain() {
  boost::system::error_code ignored;
  if (stage_ != Stage::closing) {
    stage_ = Stage::closing;
    socket_.shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
    limit(to_drain);
  }
  socket_.async_read_some(
      boost::asio::buffer(buffer_),
      [self = shared_from_this()](const boost::system::error_code& error, std::size_t bytes) {
        if (self->is_closed_) return;
        self->drained_ += bytes;
        if (error || self->drained_ > most_drained_bytes) {
          self->close();
        } else {
          self->drain();
        }
      });
}

void HttpConnection::listen() {
  watch_for_end();
  tick();
}

// Whoever listens sends no more.
void HttpConnection::watch_for_end() {
  socket_.async_read_some(
      boost::asio::buffer(buffer_),
      [self = shared_from_this()](const boost::system::error_code& error, std::size_t) {
        if (self->is_closed_) return;
        if (error) {
          self->close();
        } else {
          self->watch_for_end();
        }
      });
}

void HttpConnection::tick() {
  if (!is_sending_ && has_news_) {
    has_news_ = false;
    silent_ticks_ = 0;
    send("data: " + owner_.site.state() + "\n\n", &HttpConnection::sent);
  } else if (!is_sending_ && ++silent_ticks_ >= most_silent_ticks) {
    silent_ticks_ = 0;
    send(": beat\n\n", &HttpConnection::sent);
  }
  pace_.expires_after(between_states);
  pace_.async_wait([self = shared_from_this()](const boost::system::error_code& error) {
    if (!error && !self->is_closed_) self->tick();
  });
}

}  // namespace geolloyd
