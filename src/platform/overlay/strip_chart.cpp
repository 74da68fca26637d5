#include "overlay/strip_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "overlay/label_placement.h"
#include "physics/motion_start.h"
#include "rigid/poinsot.h"
#include "rigid/regime.h"

namespace rotatebook::overlay {
namespace {

constexpr double kHighestEnergy = 3;  // share of the initial energy; more is drawn at the top edge

/// A number for each sample, and the look of its curve.
struct Series {
  std::string name;    ///< In the legend, unless empty.
  std::string letter;  ///< Replaces the name where there is no room.
  Colour colour;
  std::vector<double> values;
  double width = 0.7;  ///< Of a line.
};

/// A thin line with its letter at the right, and a number for each sample.
struct Mark {
  std::string letter;
  std::size_t axis;
  std::vector<double> values;
};

/// A level with its name at the left.
struct Tick {
  double value;
  std::string text;
};

/// The content of a chart; values beyond its range are drawn at its edge.
struct ChartContent {
  std::string title;
  std::string shortTitle;  ///< Replaces the title where there is no room.
  double low = 0, high = 1;
  std::vector<Tick> ticks;     ///< The most important first: the others may be left out.
  std::vector<Mark> marks{};   ///< The lowest first; those that end beyond the range are left out.
  std::vector<Series> series;  ///< The last is drawn on top.
};

TextStyle labelStyle(const Scale& scale, const Colour& colour, bool bold = false) {
  return {.size = scale.smallLetters, .bold = bold, .colour = colour};
}

double paddingOf(const Scale& scale) {
  return 0.45 * scale.smallLetters;
}

/// Writes labels on a chart if they are within its box and meet none of the labels before.
class ChartWriter {
 public:
  ChartWriter(const OverlayContext& context, Canvas& canvas, const Box& box)
      : context_(context), canvas_(canvas), box_(box) {}

  Layer set(const std::string& text, const Colour& colour, bool bold = false) const {
    return context_.type.draw(text, labelStyle(context_.scale, colour, bold), context_.scale.width);
  }
  void write(const Layer& label, const Point& position) {
    const Box box = boxOf(label, position);
    if (!isFree(box, box_, written_)) return;
    canvas_.write(label, position);
    written_.push_back(box);
  }

 private:
  const OverlayContext& context_;
  Canvas& canvas_;
  Box box_;
  std::vector<Box> written_;
};

/// Sets title and legend in a row, the first of these that fits into `room`: all; a short title;
/// the names of the series alone; their letters.
std::vector<Layer> heading(const ChartWriter& writer, const ChartContent& content, double gap,
                           double room) {
  const auto made = [&](const std::string& title, bool names) {
    std::vector<Layer> labels;
    if (!title.empty()) labels.push_back(writer.set(title, kWhite, true));
    for (const Series& one : content.series) {
      if (one.name.empty()) continue;
      labels.push_back(writer.set(names ? one.name : one.letter, one.colour));
    }
    return labels;
  };
  const auto width = [&](const std::vector<Layer>& labels) {
    double sum = -gap;
    for (const Layer& label : labels) sum += label.width + gap;
    return sum;
  };
  const std::array<std::pair<std::string, bool>, 4> choices{
      {{content.title, true}, {content.shortTitle, true}, {"", true}, {"", false}}};
  for (const auto& [title, names] : choices) {
    std::vector<Layer> labels = made(title, names);
    if (width(labels) <= room) return labels;
  }
  return {};
}

/// Returns the area of the curves. At its left is room for the widest tick of all charts, at its
/// right for the letter of a mark, so that plots one below the other are aligned.
Box plotOf(const OverlayContext& context, const Box& box) {
  const Scale& scale = context.scale;
  const double padding = paddingOf(scale), row = 1.35 * scale.smallLetters;
  const int ticks = context.type.measure("180°", labelStyle(scale, kGrey), scale.width).width;
  const double left = box.x + 2 * padding + ticks;
  const double top = box.y + padding + 1.35 * row;
  return {left, top, std::max(1.0, box.right() - padding - 0.8 * scale.smallLetters - left),
          std::max(1.0, box.bottom() - padding - 0.95 * row - top)};
}

/// A chart from the clip's first frame to its last, drawn up to the present one.
class StripChart final : public DrawnOverlay {
 public:
  StripChart(const OverlayContext& context, const Box& box, const ChartContent& content)
      : context_(context),
        box_(box),
        content_(content),
        plot_(plotOf(context, box)),
        background_(background()),
        curves_(curves()) {}

  const CachedLayer* still(std::int64_t) const override { return &background_; }
  void draw(const View& view) override {
    const double now = positionOf(view.frame, content_.low).x();
    LayerView past = viewOf(curves_.layer);
    past.width = std::clamp(static_cast<int>(std::ceil(now)) - past.x, 0, past.width);
    view.canvas.lay(past, view.picture);
    const Scale& scale = context_.scale;
    view.canvas.line(std::array{Point(now, plot_.y), Point(now, plot_.bottom())},
                     {kWhite, std::max(1.0, 0.3 * scale.line), 0.5, 0});
    for (const Series& one : content_.series) {
      const double value = one.values[static_cast<std::size_t>(view.frame)];
      view.canvas.disc(positionOf(view.frame, value), 0.95 * scale.line, {one.colour, 1});
    }
  }

 private:
  Point positionOf(std::int64_t frame, double value) const {
    const auto last = std::max<std::int64_t>(1, context_.scene.clip.frameCount() - 1);
    const double t = static_cast<double>(frame) / static_cast<double>(last);
    const double level =
        std::clamp((value - content_.low) / (content_.high - content_.low), 0.0, 1.0);
    return {plot_.x + t * plot_.width, plot_.bottom() - level * plot_.height};
  }

  CachedLayer background() const {
    const Scale& scale = context_.scale;
    Canvas canvas = context_.canvas();
    canvas.roundedBox(box_, 0.5 * scale.smallLetters, {kDark, kBacking});
    ChartWriter writer(context_, canvas, box_);
    const double padding = paddingOf(scale), gap = 0.7 * scale.smallLetters;
    double x = box_.x + padding;
    for (const Layer& label : heading(writer, content_, gap, box_.width - 2 * padding)) {
      writer.write(label, {x, std::round(box_.y + 0.5 * padding)});
      x += label.width + gap;
    }
    for (const Tick& tick : content_.ticks) {
      const double y = positionOf(0, tick.value).y();
      canvas.line(std::array{Point(plot_.x, y), Point(plot_.right(), y)}, {kGrey, 1, 0.3, 0});
      const Layer name = writer.set(tick.text, kGrey);
      writer.write(name, {plot_.x - padding / 2 - name.width, std::round(y - name.height / 2.0)});
    }
    drawMarks(canvas, writer);
    const auto frames = static_cast<double>(context_.scene.clip.frameCount());
    const double end = scene::timeAt(context_.scene, frames);
    const double y = std::round(plot_.bottom() + 0.15 * padding);
    const Layer last =
        writer.set(context_.scene.overlay.words.number(
                       end < 1e3 ? roundedText(end, 3) : std::to_string(std::lround(end))) +
                       " s",
                   kGrey);
    writer.write(last, {plot_.right() - last.width, y});
    return canvas.take();
  }

  void drawMarks(Canvas& canvas, ChartWriter& writer) const {
    std::vector<Layer> letters;
    std::vector<double> rows;
    for (const Mark& mark : content_.marks) {
      const double end = mark.values.back();
      if (!(end >= content_.low && end <= content_.high)) continue;
      const std::vector<Point> points = pointsOf(mark.values);
      canvas.line(points,
                  {kAxisColours[mark.axis], std::max(1.0, 0.35 * context_.scale.line), 0.75, 0});
      letters.push_back(writer.set(mark.letter, axisLetterColour(mark.axis)));
      rows.push_back(points.back().y());
    }
    if (letters.empty()) return;
    stackUpward(rows, letters[0].height + 1.0, plot_.bottom());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double y = std::round(rows[i] - letters[i].height / 2.0);
      writer.write(letters[i], {plot_.right() + 0.6 * paddingOf(context_.scale), y});
    }
  }

  std::vector<Point> pointsOf(const std::vector<double>& values) const {
    std::vector<Point> points;
    for (std::size_t i = 0; i < values.size(); ++i)
      points.push_back(positionOf(static_cast<std::int64_t>(i), values[i]));
    return points;
  }

  CachedLayer curves() const {
    Canvas canvas = context_.canvas();
    for (const Series& one : content_.series) {
      canvas.line(pointsOf(one.values),
                  {one.colour, one.width * context_.scale.line, 1, 0.5 * context_.scale.halo});
    }
    return canvas.take();
  }

  OverlayContext context_;
  Box box_;
  ChartContent content_;
  Box plot_;
  CachedLayer background_;
  CachedLayer curves_;  // of the whole motion
};

Series seriesOf(const OverlayContext& context, const std::string& name, const std::string& letter,
                const Colour& colour, double unit, double (*value)(const physics::Sample&)) {
  Series series{name, letter, colour, {}};
  for (const physics::Sample& sample : context.trajectory.samples) {
    series.values.push_back(value(sample) / unit);
  }
  return series;
}

/// Returns the energies of spins about the principal axes with the L of each sample, as shares.
std::vector<Mark> energyMarks(const OverlayContext& context, double unit) {
  const auto inertia = physics::modelInertia(context.scene.motions[0]);
  const bool principal = !inertia.bodyFromPrincipal.isIdentity(1e-9);
  const auto axes = rigid::axesByInertia(inertia.moments);
  std::vector<Mark> marks;
  for (const int axis : {axes[2], axes[1], axes[0]}) {
    const auto i = static_cast<std::size_t>(axis);
    Mark mark{std::string(1, (principal ? "123" : "xyz")[i]), i, {}};
    for (const physics::Sample& sample : context.trajectory.samples) {
      const double momentum = sample.angularMomentum.norm();
      mark.values.push_back(rigid::axisEnergies(inertia.moments, momentum)[axis] / unit);
    }
    marks.push_back(std::move(mark));
  }
  return marks;
}

}  // namespace

double energyTop(const physics::Trajectory& trajectory) {
  const double start = trajectory.samples.front().total();
  double highest = 0;
  for (const physics::Sample& sample : trajectory.samples) {
    highest = std::max(highest, sample.total() / start);
  }
  return std::clamp(1.06 * highest, 1.15, 1.02 * kHighestEnergy);
}

/// A chart of the kinetic, spring and total energy as shares of the initial total, from 0 to
/// energyTop() or OverlayContext::energyTop, whichever is higher; and of the energies between which
/// all motions with this L are.
std::unique_ptr<DrawnOverlay> makeEnergy(const OverlayContext& context, const Box& box) {
  const double start = context.trajectory.samples.front().total();
  const scene::Words& words = context.scene.overlay.words;
  ChartContent content;
  content.title = words[scene::Word::Energy] + " / E₀";
  content.shortTitle = "E / E₀";
  content.high = std::max(energyTop(context.trajectory), context.energyTop);
  for (const double level : {1.0, 0.0, 2.0, 3.0}) {
    if (level < content.high) content.ticks.push_back({level, roundedText(level, 1)});
  }
  content.marks = energyMarks(context, start);
  const auto total = [](const physics::Sample& sample) { return sample.total(); };
  if (context.scene.motions[0].simulation.model == physics::Model::Particles) {
    // While the springs hold nothing, the total is the kinetic energy: it is wider, beneath. If
    // book and springs tremble, both curves are bands; the springs' band is the narrower.
    content.series = {seriesOf(context, words[scene::Word::Total], "E", kTotalColour, start, total),
                      seriesOf(context, words[scene::Word::Kinetic], "T", kKineticColour, start,
                               [](const physics::Sample& sample) { return sample.kinetic; }),
                      seriesOf(context, words[scene::Word::Springs], "U", kSpringColour, start,
                               [](const physics::Sample& sample) { return sample.potential; })};
    content.series.front().width *= 2.4;
  } else {
    content.series = {
        seriesOf(context, words[scene::Word::Kinetic], "T", kKineticColour, start, total)};
  }
  return std::make_unique<StripChart>(context, box, content);
}

/// A chart of the angle to the exact motion.
std::unique_ptr<DrawnOverlay> makeError(const OverlayContext& context, const Box& box) {
  ChartContent content;
  content.title = context.scene.overlay.words[scene::Word::AngleToExact];
  content.shortTitle = context.scene.overlay.words[scene::Word::Error];
  content.high = 180;
  content.ticks = {{0, "0°"}, {180, "180°"}, {90, "90°"}};
  content.series = {seriesOf(context, "", "", kErrorColour, 1,
                             [](const physics::Sample& sample) { return sample.errorDeg; })};
  return std::make_unique<StripChart>(context, box, content);
}

}  // namespace rotatebook::overlay
