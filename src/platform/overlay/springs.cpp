#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "overlay/drawn_overlay.h"
#include "overlay/rounded.h"
#include "physics/particle_places.h"

namespace rotatebook::overlay {
namespace {

constexpr Colour kCompressed{0.25, 0.55, 1.0}, kAtRest{0.86, 0.86, 0.86},
    kStretched{1.0, 0.47, 0.16};
constexpr std::size_t kColours = 25;
// The share of a motion's strains within the range of the colours.
constexpr double kShown = 0.9;
constexpr double kSmallestRange = 1e-4, kLargestRange = 0.5;

struct Spring {
  Eigen::Index a, b;  // the particles at its ends
};

template <typename Action>
void forEachSpring(const Action& action) {
  for (Eigen::Index a = 0; a < 8; ++a) {
    for (Eigen::Index b = a + 1; b < 8; ++b) action(Spring{a, b});
  }
}

double strain(const body::Cage& rest, const body::Cage& cage, const Spring& spring) {
  const double length = (cage.col(spring.a) - cage.col(spring.b)).norm();
  return length / (rest.col(spring.a) - rest.col(spring.b)).norm() - 1;
}

/// The eight particles that a cage carries: its corners, or points between them.
class Particles {
 public:
  explicit Particles(const physics::MotionSettings& settings) {
    const body::Cage corners = settings.body.corners();
    const physics::MassSpringSystem system = particlesOf(settings);
    for (int i = 0; i < 8; ++i) {
      rest_.col(i) = system.places.at(static_cast<std::size_t>(i));
      for (int corner = 0; corner < 8; ++corner) {
        // A corner's share of a point is a product of three, each 1 at the corner
        const Eigen::Array3d along = rest_.col(i).cwiseQuotient(2 * corners.col(corner));
        shares_(corner, i) = (0.5 + along).prod();
      }
    }
  }

  const body::Cage& rest() const { return rest_; }
  body::Cage within(const body::Cage& cage) const { return cage * shares_; }

 private:
  body::Cage rest_;
  Eigen::Matrix<double, 8, 8> shares_;
};

double rangeOf(const OverlayContext& context, const Particles& particles) {
  std::vector<double> strains;
  for (const physics::Sample& sample : context.trajectory.samples) {
    const body::Cage now = particles.within(sample.cage);
    forEachSpring([&](const Spring& spring) {
      strains.push_back(std::abs(strain(particles.rest(), now, spring)));
    });
  }
  const auto shown = strains.begin() +
                     static_cast<std::ptrdiff_t>(kShown * static_cast<double>(strains.size() - 1));
  std::nth_element(strains.begin(), shown, strains.end());
  return std::clamp(roundedUp(std::max(*shown, kSmallestRange)), kSmallestRange, kLargestRange);
}

/// Returns colour `step` of kColours, from compressed to stretched.
Colour colourOf(std::size_t step) {
  const double t = 2 * static_cast<double>(step) / (kColours - 1) - 1;
  return t < 0 ? mixed(kAtRest, kCompressed, -t) : mixed(kAtRest, kStretched, t);
}

std::size_t stepOf(double strain, double range) {
  const double t = (std::clamp(strain / range, -1.0, 1.0) + 1) / 2;
  return static_cast<std::size_t>(std::lround(t * (kColours - 1)));
}

CachedLayer legendOf(const OverlayContext& context, const Box& box, double range) {
  if (context.scene.textless) return {};
  const Scale& scale = context.scale;
  Canvas canvas = context.canvas();
  const double barHeight = 0.7 * scale.smallLetters, step = box.width / kColours;
  canvas.roundedBox(box.grown(0.4 * scale.smallLetters), 0.4 * scale.smallLetters,
                    {kDark, kBacking});
  for (std::size_t i = 0; i < kColours; ++i) {
    const double x = box.x + static_cast<double>(i) * step;
    const std::array<Point, 4> cell{Point(x, box.y), Point(x + step, box.y),
                                    Point(x + step, box.y + barHeight),
                                    Point(x, box.y + barHeight)};
    canvas.area(cell, {colourOf(i), 1});
  }
  const TextStyle style{.size = scale.smallLetters, .colour = kWhite, .halo = scale.halo};
  const scene::Words& words = context.scene.overlay.words;
  const std::string percent = words.number(shortestText(100 * range)) + " %";
  const double y = box.y + barHeight + 0.25 * scale.smallLetters;
  const auto write = [&](const std::string& text, double share) {
    const Layer label = context.type.draw(text, style, scale.width);
    canvas.write(label, {std::round(box.x + share * (box.width - boxOf(label).width)), y});
  };
  write("−" + percent, 0);
  write(words[scene::Word::Strain], 0.5);
  write("+" + percent, 1);
  return canvas.take();
}

/// The 28 springs, coloured by strain, the particles, and a legend. For eight particles only.
class Springs final : public DrawnOverlay {
 public:
  /// Takes the box of the legend.
  Springs(const OverlayContext& context, const Box& legend);
  void draw(const View& view) override;

 private:
  OverlayContext context_;
  Particles particles_;
  double range_;  // strain of full colour
  CachedLayer legend_;
};

Springs::Springs(const OverlayContext& context, const Box& legend)
    : context_(context),
      particles_(context.scene.motions[0]),
      range_(rangeOf(context, particles_)),
      legend_(legendOf(context, legend, range_)) {}

void Springs::draw(const View& view) {
  const body::Cage now = particles_.within(view.sample.cage);
  std::vector<Point> particles;
  for (Eigen::Index i = 0; i < 8; ++i) {
    const auto point = view.projector(now.col(i));
    if (!point) return;
    particles.push_back(*point);
  }
  const Scale& scale = context_.scale;
  std::array<std::vector<Point>, kColours> ofColour;
  forEachSpring([&](const Spring& spring) {
    const std::array<Point, 2> ends{particles[static_cast<std::size_t>(spring.a)],
                                    particles[static_cast<std::size_t>(spring.b)]};
    // Each is a path of its own: Cairo is slow with many lines that cross.
    view.canvas.line(ends, {kDark, 0.8 * scale.line + 2 * scale.halo, 0.35, 0});
    auto& others = ofColour[stepOf(strain(particles_.rest(), now, spring), range_)];
    others.insert(others.end(), ends.begin(), ends.end());
  });
  for (std::size_t i = 0; i < kColours; ++i) {
    for (std::size_t end = 0; end < ofColour[i].size(); end += 2) {
      view.canvas.line(std::span(ofColour[i]).subspan(end, 2),
                       {colourOf(i), 0.8 * scale.line, 1, 0});
    }
  }
  for (const Point& particle : particles) {
    view.canvas.disc(particle, 1.9 * scale.line + scale.halo, {kDark, 0.6});
    view.canvas.disc(particle, 1.9 * scale.line, {kWhite, 1});
  }
  view.canvas.lay(legend_, view.picture);
}

}  // namespace

std::unique_ptr<DrawnOverlay> makeSprings(const OverlayContext& context, const Box& legend) {
  return std::make_unique<Springs>(context, legend);
}

}  // namespace rotatebook::overlay
