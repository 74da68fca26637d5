// Errors of threads. Inside the room only.
#pragma once

#include <exception>
#include <mutex>

namespace rotatebook::system {

/// Keeps the first of the errors that threads run into.
class FirstError {
 public:
  /// Keeps `error` unless there is one already.
  void set(std::exception_ptr error);
  bool isSet();
  /// Throws the error that is kept, if any.
  void rethrow();

 private:
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace rotatebook::system
