#include "system/first_error.h"

#include <utility>

namespace rotatebook::system {

void FirstError::set(std::exception_ptr error) {
  const std::lock_guard lock(mutex_);
  if (!error_) error_ = std::move(error);
}

bool FirstError::isSet() {
  const std::lock_guard lock(mutex_);
  return error_ != nullptr;
}

void FirstError::rethrow() {
  const std::lock_guard lock(mutex_);
  if (error_) std::rethrow_exception(error_);
}

}  // namespace rotatebook::system
