#include "cli/body_report.h"

#include <array>
#include <cmath>
#include <ostream>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"
#include "rigid/inertia.h"
#include "rigid/regime.h"

namespace rotatebook::cli {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Principal moments, smallest first, and their axes as columns, right-handed.
struct SortedAxes {
  Vector3d moments;
  Matrix3d axes;
};

SortedAxes sortedAxes(const Matrix3d& inertia) {
  const rigid::PrincipalAxes principal = rigid::principalAxes(inertia);
  const auto order = rigid::axesByInertia(principal.moments);
  SortedAxes sorted;
  for (int i = 0; i < 3; ++i) {
    const int from = order[static_cast<std::size_t>(i)];
    sorted.moments[i] = principal.moments[from];
    sorted.axes.col(i) = principal.bodyFromPrincipal.col(from);
  }
  if (sorted.axes.determinant() < 0) sorted.axes.col(2) *= -1;
  sorted.axes.array() += 0.0;  // No -0
  return sorted;
}

/// Returns the vector for people: components that are only rounding, beside `scale`, are 0.
std::string bodyVectorText(const Vector3d& vector, double scale, int digits) {
  return fmt::format("({})", joinedOf(vector, [&](double number) {
                       return roundedText(std::fabs(number) < 1e-12 * scale ? 0 : number, digits);
                     }));
}

/// Returns the rate at which a deviation from a spin about the middle axis grows, as a share of the
/// spin: lambda = w sqrt((I2 - I1)(I3 - I2)/(I1 I3)).
double growthOf(const Vector3d& moments) {
  return std::sqrt((moments[1] - moments[0]) * (moments[2] - moments[1]) /
                   (moments[0] * moments[2]));
}

/// Returns "x" or "(0.8, 0.6, 0)", for a unit vector.
std::string axisText(const Vector3d& axis) {
  constexpr double kRounding = 1e-12;
  for (int i = 0; i < 3; ++i)
    if (std::fabs(axis[i]) > 1 - kRounding) return {"xyz"[i]};
  return bodyVectorText(axis, 1, 4);
}

std::string momentsText(const SortedAxes& sorted) {
  return joinedOf(std::array{0, 1, 2}, [&](int i) {
    return fmt::format("{}{} about {}", roundedText(sorted.moments[i], 6), i == 0 ? " kg m^2" : "",
                       axisText(sorted.axes.col(i)));
  });
}

std::string pairText(const std::array<std::size_t, 2>& triangles) {
  return fmt::format("triangles {} and {}", triangles[0] + 1, triangles[1] + 1);
}

/// Returns what there is to say about the surface.
std::string surfaceText(const std::optional<BodySurface>& surface) {
  if (!surface) return "the book, a cuboid";
  const std::string shells =
      surface->shells == 1
          ? "one closed surface"
          : fmt::format(
                "{} closed surfaces, which add up: also where they overlap; one that faces "
                "inward takes away",
                surface->shells);
  std::vector<std::string> notes = surface->notes;
  if (surface->crossing) {
    notes.push_back(pairText(*surface->crossing) +
                    " cross each other; what a surface encloses twice counts twice");
  }
  if (surface->overlap) {
    notes.push_back(
        pairText(*surface->overlap) +
        " meet at an edge around which something is enclosed twice, or taken away where "
        "nothing is; it counts so");
  }
  std::string text = fmt::format("{} triangles, {}", surface->triangles, shells);
  for (const std::string& note : notes) text += "\n  note        " + note;
  return text;
}

}  // namespace

void reportBody(const BodyNumbers& numbers, std::ostream& output) {
  const body::MassProperties& body = numbers.properties;
  const auto [moments, axes] = sortedAxes(body.inertia);
  output << fmt::format(
      "  body        {}\n  volume      {} m^3\n  mass        {} kg\n  centre      {} m\n"
      "  inertia     about the centre [kg m^2]\n",
      surfaceText(numbers.surface), roundedText(body.volume, 6), roundedText(body.mass, 6),
      bodyVectorText(body.centre, std::cbrt(body.volume), 6));
  for (int row = 0; row < 3; ++row)
    output << "              " << bodyVectorText(body.inertia.row(row), moments[2], 6) << '\n';
  output << "  moments     " << momentsText({moments, axes}) << '\n';
  const double growth = growthOf(moments);
  if (growth > 1e-6) {
    output << fmt::format(
        "  middle axis a spin of w about it is unstable: deviations grow as e^({} w t)\n",
        roundedText(growth, 4));
  } else {
    output << "  middle axis two moments are equal, or nearly so: no spin is unstable\n";
  }
}

std::string bodyJson(const BodyNumbers& numbers) {
  const body::MassProperties& body = numbers.properties;
  const auto [moments, axes] = sortedAxes(body.inertia);
  const auto rowsOf = [](const Matrix3d& matrix) {
    return jsonArrayOf(std::array{0, 1, 2}, [&](int row) { return vectorJson(matrix.row(row)); });
  };
  JsonObject json;
  json.addNumber("volume_m3", body.volume);
  json.addNumber("mass_kg", body.mass);
  json.add("centre_m", vectorJson(body.centre));
  json.add("inertia_kg_m2", rowsOf(body.inertia));
  json.add("moments_kg_m2", vectorJson(moments));
  json.add("axes", rowsOf(axes.transpose()));
  const auto count = [&](const char* key, std::size_t BodySurface::*member) {
    if (!numbers.surface) {
      json.add(key, "null");
    } else {
      json.addInteger(key, static_cast<std::int64_t>((*numbers.surface).*member));
    }
  };
  count("triangles", &BodySurface::triangles);
  count("shells", &BodySurface::shells);
  const auto pair = [&](const char* key, auto BodySurface::*member) {
    const bool isThere = numbers.surface && (*numbers.surface).*member;
    json.add(key, !isThere ? "null"
                           : jsonArrayOf(*((*numbers.surface).*member), [](std::size_t triangle) {
                               return std::to_string(triangle + 1);
                             }));
  };
  pair("crossing", &BodySurface::crossing);
  pair("overlap", &BodySurface::overlap);
  json.add("notes",
           jsonArrayOf(numbers.surface ? numbers.surface->notes : std::vector<std::string>{},
                       [](const std::string& note) { return jsonString(note); }));
  json.addBool("closed", true);
  return json.text();
}

}  // namespace rotatebook::cli
