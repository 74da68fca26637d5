// The table's questions to an engine: the book, set spinning once, and where it is after so many
// steps.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "body/cuboid.h"

namespace rotatebook::bench {

/// The motion that every row of the table makes. The body floats free: no gravity, no damping, and
/// it never goes to sleep.
struct Motion {
  body::Cuboid book;
  Eigen::Vector3d angularVelocity{0, 0, 0};  ///< At t = 0, when body and world axes agree. [rad/s]
};

/// The body at one moment.
struct EngineState {
  Eigen::Matrix3d worldFromBody = Eigen::Matrix3d::Identity();
  Eigen::Vector3d angularVelocity{0, 0, 0};  ///< World axes. [rad/s]
};

/// A body in motion.
class Engine {
 public:
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;

  /// Goes on by `steps` >= 0 steps of the length that the engine was made with; one that chooses
  /// its steps goes on by the same time.
  virtual void advance(int steps) = 0;
  virtual EngineState state() const = 0;
  /// Returns the number of steps that the engine has chosen to make so far; nothing if it doesn't
  /// choose.
  virtual std::optional<int> chosenSteps() const { return std::nullopt; }
};

/// One way of stepping that an engine offers.
struct Mode {
  std::string name;
  /// Makes the motion at t = 0, to be advanced in steps of a length in seconds. May throw
  /// rotatebook::Error.
  std::function<std::unique_ptr<Engine>(const Motion&, double)> make;
  bool stepMatters = true;  ///< False where the engine chooses its steps, or needs none.
};

/// An engine as this machine has it.
struct Family {
  std::string name;         ///< With the version, if it is installed.
  std::string package;      ///< Debian's name of what to install; empty for our own.
  std::string note;         ///< Remark for the reader of its rows, or empty.
  std::vector<Mode> modes;  ///< None if it is not installed.
};

// One a source file; only those of the engines that were found at configuration are compiled.
Family bulletFamily();
Family mujocoFamily();
Family odeFamily();
Family ownFamily();
Family simbodyFamily();

}  // namespace rotatebook::bench
