// The exceptions of the library: one class, three kinds, one readable message.
#pragma once

#include <stdexcept>
#include <string>

namespace rotatebook {

/// Names who can fix the error; the command line turns it into its exit code.
enum class ErrorKind {
  Input,    ///< The user's input is wrong: a scene, an option, a picture (exit code 2).
  Machine,  ///< The machine can't: no EGL, no encoder (exit code 3).
  /// The machine can't now, but another try, or another machine, may: a full disk, a lock of
  /// another process, a device that is missing (exit code 3, or 75 if that was asked for).
  Transient,
};

/// The only exception that rotatebook throws at resource and I/O edges. Its message states who,
/// what, the values, the library's own message, and the remedy if there is one. Whatever it quotes,
/// it is safe to print, and on one line but for those that kNextLine begins; see messageText().
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message);

  ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

/// Reports that the user's input is wrong.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(ErrorKind::Input, message) {}
};

/// Reports that the machine can't do what was requested, or, of the kind Transient, not now.
class MachineError : public Error {
 public:
  explicit MachineError(const std::string& message, ErrorKind kind = ErrorKind::Machine)
      : Error(kind, message) {}
};

}  // namespace rotatebook
