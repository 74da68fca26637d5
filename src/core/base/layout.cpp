#include "base/layout.h"

#include <atomic>
#include <string>
#include <string_view>

#include "base/error.h"

namespace rotatebook {
namespace {

constexpr const char* kByCMake = "link rotatebook::core by CMake, which passes the flags on";
constexpr const char* kSameFlags = "build both with it, or both without it";

struct LayoutFlag {
  bool Layout::*isSet;
  const char* name;
  const char* remedy;
};

constexpr LayoutFlag kLayoutFlags[]{
    {&Layout::eigenDoesNotVectorize, "-DEIGEN_DONT_VECTORIZE", kByCMake},
    {&Layout::eigenIsRowMajor, "-DEIGEN_DEFAULT_TO_ROW_MAJOR", kSameFlags},
    {&Layout::contractionIsOff, "-ffp-contract=off", kByCMake},
    {&Layout::fastMath, "-ffast-math", kSameFlags},
    {&Layout::associativeMath, "-fassociative-math", kSameFlags},
    {&Layout::reciprocalMath, "-freciprocal-math", kSameFlags},
    {&Layout::noSignedZeros, "-fno-signed-zeros", kSameFlags},
    {&Layout::finiteMathOnly, "-ffinite-math-only", kSameFlags}};

struct SizeDifference {
  const char* type;
  std::size_t here, caller;
};

// The first differences that were noted. Initialised before any source of the program can note
// anything.
constinit std::atomic<const Layout*> otherLayout{nullptr};
constinit std::atomic<const SizeDifference*> otherSize{nullptr};

const Layout& coreLayout() noexcept {
  static const Layout here = layoutHere();
  return here;
}

bool isSameVersion(const Layout& caller) noexcept {
  return std::string_view(kVersion) == caller.version;
}

// Returns the first flag that differs, or null. Those of another version may be others.
const LayoutFlag* differingFlag(const Layout& caller) noexcept {
  for (const LayoutFlag& flag : kLayoutFlags) {
    if (coreLayout().*flag.isSet != caller.*flag.isSet) return &flag;
  }
  return nullptr;
}

}  // namespace

bool noteLayout(const Layout& caller) noexcept {
  if (isSameVersion(caller) && differingFlag(caller) == nullptr) return true;
  const Layout* none = nullptr;
  otherLayout.compare_exchange_strong(none, &caller);
  return false;
}

bool noteSize(const char* type, std::size_t here, std::size_t caller) noexcept {
  if (here == caller) return true;
  static const SizeDifference first{type, here, caller};
  otherSize = &first;
  return false;
}

void requireSameLayout() {
  if (const Layout* other = otherLayout.load()) requireSameLayout(*other);
  const SizeDifference* size = otherSize.load();
  if (size == nullptr) return;
  throw InputError("rotatebook was built with a " + std::string(size->type) + " of " +
                   std::to_string(size->here) + " bytes, this program with one of " +
                   std::to_string(size->caller) + "; build both with the same headers and flags");
}

void requireSameLayout(const Layout& caller) {
  if (!isSameVersion(caller)) {
    throw InputError("this is rotatebook " + std::string(kVersion) +
                     ", but this program was built with the headers of " + caller.version +
                     "; build it with the headers of the library that it links");
  }
  const LayoutFlag* flag = differingFlag(caller);
  if (flag == nullptr) return;
  const bool here = coreLayout().*flag->isSet;
  throw InputError("rotatebook was built " + std::string(here ? "with " : "without ") + flag->name +
                   ", this program " + (here ? "without" : "with") + " it; " + flag->remedy);
}

}  // namespace rotatebook
