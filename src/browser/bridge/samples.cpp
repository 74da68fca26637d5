// Samples as they are kept, for languages that share the library's memory.
#include <cstddef>
#include <exception>
#include <type_traits>

#include "base/json.h"
#include "bridge/context.h"
#include "timeline/clip_motion.h"

namespace rotatebook::bridge {
namespace {

using physics::Sample;

/// Returns the JSON of a field of `sample`, of `shape` numbers; [] of a single one.
template <typename Number>
Json fieldJson(const Sample& sample, const Number& first, const Json& shape = Json::array()) {
  static_assert(std::is_same_v<Number, double> || sizeof(Number) == 4);
  const auto* const begin = reinterpret_cast<const std::byte*>(&sample);
  return {{"offset", reinterpret_cast<const std::byte*>(&first) - begin},
          {"type", std::is_same_v<Number, double> ? "f8" : "i4"},
          {"shape", shape}};
}

Json layoutJson() {
  const Sample sample;
  const Json three = Json::array({3});
  Json fields;
  fields["time"] = fieldJson(sample, sample.time);
  fields["attitude"] = fieldJson(sample, *sample.attitude.coeffs().data(), Json::array({4}));
  fields["angular_velocity"] = fieldJson(sample, *sample.angularVelocity.data(), three);
  fields["angular_momentum"] = fieldJson(sample, *sample.angularMomentum.data(), three);
  fields["kinetic"] = fieldJson(sample, sample.kinetic);
  fields["potential"] = fieldJson(sample, sample.potential);
  fields["rotational"] = fieldJson(sample, sample.rotational);
  fields["tilt_deg"] = fieldJson(sample, sample.tiltDeg);
  fields["flips"] = fieldJson(sample, sample.halfTurns);
  fields["stretch_min"] = fieldJson(sample, sample.stretchMin);
  fields["stretch_max"] = fieldJson(sample, sample.stretchMax);
  fields["error_deg"] = fieldJson(sample, sample.errorDeg);
  fields["regime"] = fieldJson(sample, sample.regime);
  fields["corners"] = fieldJson(sample, *sample.cage.data(), Json::array({8, 3}));
  return {{"size", sizeof(Sample)}, {"fields", fields}};
}

}  // namespace
}  // namespace rotatebook::bridge

const void* rb_samples(rb_context* context, std::int32_t slot, std::int32_t motion,
                       std::int32_t* count) {
  *count = 0;
  try {
    const auto& trajectories = context->wholeIn(slot).trajectories();
    const auto& samples = trajectories.at(static_cast<std::size_t>(motion)).samples;
    *count = static_cast<std::int32_t>(samples.size());
    return samples.data();
  } catch (const std::exception&) {
    return nullptr;
  }
}

std::int32_t rb_sample_layout(rb_context* context) {
  return context->answerOf([] { return rotatebook::jsonText(rotatebook::bridge::layoutJson()); });
}
