#include "scene/measure.h"

#include <cmath>
#include <numbers>

#include "base/elementary.h"

namespace rotatebook::scene {
namespace {

/// Returns the angle of the body's line along its first spin to where that line was at the start.
/// [degrees]
double turnedDeg(const physics::Sample& sample, const physics::Sample& start) {
  const Eigen::Vector3d then = start.angularVelocity;  // both axes coincide at the start
  const Eigen::Vector3d now = sample.attitude * then;
  return arcTangent(then.cross(now).norm(), then.dot(now)) * 180 / std::numbers::pi;
}

}  // namespace

std::string reasonForAbsence(Measure measure, physics::Model model) {
  using physics::Model;
  if (measure == Measure::Order && !physics::takesSteps(model)) {
    return "the motion takes no steps; choose another model, e.g. simulation.model = "
           "\"quaternion\"";
  }
  switch (rowOf(measure).models) {
    case MeasureModels::All:
      break;
    case MeasureModels::Stepwise:
      if (model != Model::Exact) break;
      return "the model \"exact\" has no such error; choose another model, e.g. "
             "simulation.model = \"quaternion\"";
    case MeasureModels::Particles:
      if (model == Model::Particles) break;
      return "only the model \"particles\" has a centre that drifts";
  }
  return "";
}

MeasuredRange rangeOn(const physics::Sample& sample, const physics::Sample& start,
                      Measure measure) {
  const auto one = [](double value) { return MeasuredRange{value, value}; };
  switch (measure) {
    case Measure::HalfTurns:
      return one(sample.halfTurns);
    case Measure::TiltDeg:
      return one(sample.tiltDeg);
    case Measure::EnergyRatio:
      return one(sample.total() / start.total());
    case Measure::RotationalRatio:
      return one(sample.rotational / start.total());
    case Measure::MomentumRatio:
      return one(sample.angularMomentum.norm() / start.angularMomentum.norm());
    case Measure::Stretch:
      return {sample.stretchMin, sample.stretchMax};
    case Measure::ErrorDeg:
      return one(sample.errorDeg);
    case Measure::Regime:
      return one(static_cast<double>(sample.regime));
    case Measure::CentreDrift:
      return one(sample.centreDrift());
    case Measure::EnergyDrift:
      return one(std::fabs(sample.total() / start.total() - 1));
    case Measure::TurnedDeg:
      return one(turnedDeg(sample, start));
    case Measure::DivergesAt:
    case Measure::FirstFlip:
    case Measure::FlipInterval:
    case Measure::Growth:
    case Measure::FlipLaw:
    case Measure::Order:
      break;  // measured over a motion, not on a sample
  }
  return {};
}

double valueOn(const physics::Sample& sample, const physics::Sample& start, Measure measure) {
  const MeasuredRange range = rangeOn(sample, start, measure);
  const double rest = rowOf(measure).rest;
  return std::fabs(range.lowest - rest) > std::fabs(range.highest - rest) ? range.lowest
                                                                          : range.highest;
}

}  // namespace rotatebook::scene
