#include "tools/view/http/http_reader.h"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/system/error_code.hpp>
#include <string>
#include <utility>

namespace geolloyd {

namespace http = boost::beast::http;

struct HttpReader::Parser {
  http::request_parser<http::string_body> request;
  std::string rest;  // bytes that came and were not taken yet
};

namespace {

HttpResponse refusal_of(const boost::system::error_code& error) {
  if (error == http::error::header_limit) return http_error(431, "the header is too long");
  if (error == http::error::body_limit) return http_error(413, "the body is too long");
  return http_error(400, "this is no request");
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return result;
}

std::string text_of(boost::beast::string_view view) {
  return {view.data(), view.size()};
}

}  // namespace

HttpReader::HttpReader() : parser_(std::make_unique<Parser>()) {
  parser_->request.header_limit(most_header_bytes);
  parser_->request.body_limit(most_body_bytes);
  parser_->request.eager(true);
}

HttpReader::~HttpReader() = default;

// The parser wants a header whole. Whatever follows a request is left alone: the connection ends
// with its response.
bool HttpReader::put(std::string_view bytes) {
  std::string& rest = parser_->rest;
  rest.append(bytes);
  auto& request = parser_->request;
  while (!rest.empty() && !request.is_done()) {
    boost::system::error_code error;
    const std::size_t taken = request.put(boost::asio::buffer(rest), error);
    rest.erase(0, taken);
    if (error == http::error::need_more) break;
    if (error) {
      refusal_ = refusal_of(error);
      return true;
    }
    if (taken == 0) break;
  }
  if (!request.is_header_done() && rest.size() > most_header_bytes) {
    refusal_ = http_error(431, "the header is too long");
    return true;
  }
  return request.is_done();
}

bool HttpReader::is_complete() const {
  return !refusal_ && parser_->request.is_done();
}

HttpRequest HttpReader::take() {
  auto message = parser_->request.release();
  HttpRequest request;
  request.method = text_of(message.method_string());
  request.target = text_of(message.target());
  for (const auto& field : message) {
    request.headers.emplace_back(lower(text_of(field.name_string())), text_of(field.value()));
  }
  request.body = std::move(message.body());
  return request;
}

}  // namespace geolloyd
