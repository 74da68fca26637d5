// The first error of several threads. Inside the room only.
#pragma once

#include <exception>
#include <mutex>

namespace rotatebook::system {

/// Keeps the first error that any thread reports.
class FirstError {
 public:
  /// Keeps `error` unless one is kept already.
  void set(std::exception_ptr error);
  bool isSet();
  /// Throws the kept error, if any.
  void rethrow();

 private:
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace rotatebook::system
