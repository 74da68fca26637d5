#include "cli/error_report.h"

#include <iostream>
#include <new>
#include <system_error>

#include "base/error.h"
#include "base/text.h"
#include "cli/exit_code.h"

namespace rotatebook::cli {
namespace {

const char* messageOf(const std::system_error& error) {
  if (error.code() != std::errc::resource_unavailable_try_again) return error.what();
  return "can't start a thread: this user or container has reached its limit; raise it "
         "(ulimit -u)";
}

}  // namespace

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
    return print(known.what(), known.kind() == ErrorKind::Input ? kWrongInput : kMachineFailed);
  } catch (const std::bad_alloc&) {
    return print("out of memory", kMachineFailed);
  } catch (const std::system_error& system) {
    return print(messageText(messageOf(system)).c_str(), kMachineFailed);
  } catch (const std::exception& other) {
    return print(messageText(other.what()).c_str(), kMachineFailed);
  }
}

int reportIfUnmet(int status, bool wroteFiles) {
  if (status == kUnmet) {
    printError(wroteFiles ? "expectations are unmet; the files were kept"
                          : "expectations are unmet");
  }
  return status;
}

}  // namespace rotatebook::cli
