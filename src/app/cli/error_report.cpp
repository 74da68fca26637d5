#include "cli/error_report.h"

#include <iostream>
#include <new>
#include <system_error>

#include "base/error.h"
#include "cli/exit_code.h"

namespace rotatebook::cli {
namespace {

const char* wordsOf(const std::system_error& error) {
  if (error.code() != std::errc::resource_unavailable_try_again) return error.what();
  return "can't start a thread: this user or container has reached its limit; raise it "
         "(ulimit -u)";
}

}  // namespace

int reportError(const std::exception_ptr& error, std::string_view subject) {
  const auto say = [subject](const char* words, int status) {
    std::cerr << "rotatebook: " << subject << words << '\n';
    return status;
  };
  try {
    std::rethrow_exception(error);
  } catch (const Error& known) {
    return say(known.what(), known.kind() == ErrorKind::Input ? kWrongInput : kMachineFailed);
  } catch (const std::bad_alloc&) {
    return say("out of memory", kMachineFailed);
  } catch (const std::system_error& system) {
    return say(wordsOf(system), kMachineFailed);
  } catch (const std::exception& other) {
    return say(other.what(), kMachineFailed);
  }
}

}  // namespace rotatebook::cli
