#pragma once

#include <stdexcept>
#include <string>

namespace geolloyd {

/// What a user can put right. The message is one line: where, what, what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The data or the options make no sense.
class InvalidInput : public Error {
 public:
  using Error::Error;
};

/// The operating system refused a file.
class IoError : public Error {
 public:
  using Error::Error;
};

}  // namespace geolloyd
