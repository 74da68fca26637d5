#include "cli/exit_code.h"

#include <atomic>
#include <iostream>
#include <new>
#include <system_error>

#include "base/error.h"
#include "base/text.h"
#include "system/file_descriptor.h"

namespace rotatebook::cli {
namespace {

std::atomic<bool> wantsRetryStatus = false;

int statusOfKind(ErrorKind kind) {
  if (kind == ErrorKind::Input) return kWrongInput;
  return kind == ErrorKind::Transient ? kTryAgain : kMachineFailed;
}

const char* messageOf(const std::system_error& error) {
  if (error.code() != std::errc::resource_unavailable_try_again) return error.what();
  return "can't start a thread: this user or container has reached its limit; raise it "
         "(ulimit -u)";
}

}  // namespace

void askForRetryStatus() {
  wantsRetryStatus = true;
}

int endStatus(int status) noexcept {
  if (status != kTryAgain && status < kInterrupted) return status;
  if (wantsRetryStatus) return kTryAgain;
  return status == kTryAgain ? kMachineFailed : status;
}

void printError(std::string_view message, std::string_view subject) {
  std::cerr << "rotatebook: " << subject << message << '\n';
}

int reportError(const std::exception_ptr& error, std::string_view subject) {
  const auto print = [subject](const char* message, int status) {
    printError(message, subject);
    return status;
  };
  try {
    std::rethrow_exception(error);
  } catch (const Error& known) {
    return print(known.what(), statusOfKind(known.kind()));
  } catch (const std::bad_alloc&) {
    return print("out of memory", kTryAgain);
  } catch (const std::system_error& system) {
    return print(messageText(messageOf(system)).c_str(),
                 statusOfKind(system::kindOfError(system.code().value())));
  } catch (const std::exception& other) {
    return print(messageText(other.what()).c_str(), kMachineFailed);
  }
}

int reportIfUnmet(int status, bool wroteFiles) {
  if (status == kUnmet) {
    printError(wroteFiles ? "expectations are not met; the files were kept"
                          : "expectations are not met");
  }
  return status;
}

}  // namespace rotatebook::cli
