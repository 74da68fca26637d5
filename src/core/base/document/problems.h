// Collects the problems of a document, so that all are reported at once.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace rotatebook::document {

/// One problem of a document.
struct Problem {
  std::string location;  ///< As TomlNode has it.
  std::string text;
  std::string remedy;      ///< Ends the text; may be empty.
  std::string unknownKey;  ///< The key, if it is unknown where it is.
};

/// Reports problems, one on each line of the message: "LOCATION: PROBLEM".
class DocumentError : public InputError {
 public:
  explicit DocumentError(std::vector<Problem> all);

  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// Problems of work that goes on after the first of them.
class Problems {
 public:
  /// Runs `work`, and notes the problems of a DocumentError of it.
  template <typename Work>
  void note(const Work& work) {
    try {
      work();
    } catch (const DocumentError& error) {
      noted_.insert(noted_.end(), error.problems().begin(), error.problems().end());
    }
  }

  /// Returns what was noted so far.
  std::vector<Problem>& all() { return noted_; }

  /// Throws DocumentError with what was noted, if anything was: in the order of the file, then
  /// overrides by their text, and only the first at each location.
  void throwIfAny();

 private:
  std::vector<Problem> noted_;
};

}  // namespace rotatebook::document
