#include "overlay/strip_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/number_text.h"

namespace rotatebook::overlay {
namespace {

constexpr double kHighestEnergy = 3;  // of the start's: what is more runs along the upper edge

TextStyle wordStyle(const Scale& scale, const Colour& colour, bool bold = false) {
  return {.size = scale.smallLetters, .bold = bold, .colour = colour};
}

double paddingOf(const Scale& scale) {
  return 0.45 * scale.smallLetters;
}

double rowOf(const Scale& scale) {
  return 1.35 * scale.smallLetters;
}

/// Writes words on a chart if they fit within its box and beside the words before them.
class ChartWriter {
 public:
  ChartWriter(const OverlayContext& context, Canvas& canvas, const Box& box)
      : context_(context), canvas_(canvas), box_(box) {}

  Layer set(const std::string& text, const Colour& colour, bool bold = false) const {
    return context_.type.draw(text, wordStyle(context_.scale, colour, bold), context_.scale.width);
  }
  bool fits(const Box& words) const {
    return box_.holds(words) &&
           std::ranges::none_of(written_, [&](const Box& other) { return other.meets(words); });
  }
  void write(const Layer& words, const Point& place) {
    const Box box = boxOf(words, place);
    if (!fits(box)) return;
    canvas_.write(words, place);
    written_.push_back(box.grown(1));
  }

 private:
  const OverlayContext& context_;
  Canvas& canvas_;
  Box box_;
  std::vector<Box> written_;
};

/// Title and legend in a row, as much of them as there is room for: all; a short title; the names
/// of the series alone; their letters.
std::vector<Layer> heading(const ChartWriter& writer, const ChartContent& content, double gap,
                           double room) {
  const auto made = [&](const std::string& title, bool names) {
    std::vector<Layer> words;
    if (!title.empty()) words.push_back(writer.set(title, kWhite, true));
    for (const Series& one : content.series) {
      if (!one.name.empty()) words.push_back(writer.set(names ? one.name : one.letter, one.colour));
    }
    return words;
  };
  const auto width = [&](const std::vector<Layer>& words) {
    double sum = -gap;
    for (const Layer& word : words) sum += word.width + gap;
    return sum;
  };
  const std::array<std::pair<std::string, bool>, 4> choices{
      {{content.title, true}, {content.shortTitle, true}, {"", true}, {"", false}}};
  for (const auto& [title, names] : choices) {
    std::vector<Layer> words = made(title, names);
    if (width(words) <= room) return words;
  }
  return {};
}

/// The widest tick of all charts, so that their plots are one below the other.
double widestTick(const OverlayContext& context) {
  return context.type.measure("180°", wordStyle(context.scale, kGrey), context.scale.width).width;
}

Box plotOf(const OverlayContext& context, const Box& box) {
  const double padding = paddingOf(context.scale), row = rowOf(context.scale);
  const double left = box.x + 2 * padding + widestTick(context);
  const double top = box.y + padding + 1.35 * row;
  return {left, top, std::max(1.0, box.right() - 1.5 * padding - left),
          std::max(1.0, box.bottom() - padding - 0.95 * row - top)};
}

Series seriesOf(const OverlayContext& context, const std::string& name, const std::string& letter,
                const Colour& colour, double unit, double (*value)(const physics::Sample&)) {
  Series series{name, letter, colour, {}};
  for (const physics::Sample& sample : context.trajectory.samples) {
    series.values.push_back(value(sample) / unit);
  }
  return series;
}

}  // namespace

StripChart::StripChart(const OverlayContext& context, const Box& box, const ChartContent& content)
    : context_(context),
      box_(box),
      content_(content),
      plot_(plotOf(context, box)),
      cached_(stillPart()),
      curves_(curves()) {}

Point StripChart::placeOf(std::int64_t frame, double value) const {
  const auto last = std::max<std::int64_t>(1, context_.scene.clip.frameCount() - 1);
  const double t = static_cast<double>(frame) / static_cast<double>(last);
  const double level =
      std::clamp((value - content_.low) / (content_.high - content_.low), 0.0, 1.0);
  return {plot_.x + t * plot_.width, plot_.bottom() - level * plot_.height};
}

CachedLayer StripChart::stillPart() const {
  const Scale& scale = context_.scale;
  Canvas canvas(scale.width, scale.height);
  canvas.roundedBox(box_, 0.5 * scale.smallLetters, {kDark, 0.7});
  ChartWriter writer(context_, canvas, box_);
  const double padding = paddingOf(scale), gap = 0.7 * scale.smallLetters;
  double x = box_.x + padding;
  for (const Layer& word : heading(writer, content_, gap, box_.width - 2 * padding)) {
    writer.write(word, {x, std::round(box_.y + 0.5 * padding)});
    x += word.width + gap;
  }
  for (const Tick& tick : content_.ticks) {
    const double y = placeOf(0, tick.value).y();
    canvas.line(std::array{Point(plot_.x, y), Point(plot_.right(), y)}, {kGrey, 1, 0.3, 0});
    const Layer words = writer.set(tick.text, kGrey);
    writer.write(words, {plot_.x - padding / 2 - words.width, std::round(y - words.height / 2.0)});
  }
  const double end = static_cast<double>(context_.scene.clip.frameCount()) *
                     context_.scene.simulation.timePerFrame;
  const double y = std::round(plot_.bottom() + 0.15 * padding);
  const Layer last = writer.set(roundedText(end, 3) + " s", kGrey);
  writer.write(last, {plot_.right() - last.width, y});
  return canvas.take();
}

CachedLayer StripChart::curves() const {
  Canvas canvas(context_.scale.width, context_.scale.height);
  for (const Series& one : content_.series) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < one.values.size(); ++i) {
      points.push_back(placeOf(static_cast<std::int64_t>(i), one.values[i]));
    }
    canvas.line(points, {one.colour, 0.7 * context_.scale.line, 1, 0.5 * context_.scale.halo});
  }
  return canvas.take();
}

void StripChart::draw(const View& view) {
  view.canvas.lay(cached_, view.picture);
  const double now = placeOf(view.frame, content_.low).x();
  LayerView past = viewOf(curves_.layer);
  past.width = std::clamp(static_cast<int>(std::ceil(now)) - past.x, 0, past.width);
  blend(past, view.picture);
  const Scale& scale = context_.scale;
  view.canvas.line(std::array{Point(now, plot_.y), Point(now, plot_.bottom())},
                   {kWhite, std::max(1.0, 0.3 * scale.line), 0.5, 0});
  for (const Series& one : content_.series) {
    const double value = one.values[static_cast<std::size_t>(view.frame)];
    view.canvas.disc(placeOf(view.frame, value), 0.95 * scale.line, {one.colour, 1});
  }
}

double energyTop(const physics::Trajectory& trajectory) {
  const double start = trajectory.samples.front().total();
  double highest = 0;
  for (const physics::Sample& sample : trajectory.samples) {
    highest = std::max(highest, sample.total() / start);
  }
  return std::clamp(1.06 * highest, 1.15, 1.02 * kHighestEnergy);
}

ChartContent energyContent(const OverlayContext& context, double top) {
  const double start = context.trajectory.samples.front().total();
  ChartContent content;
  content.title = "Energy / E₀";
  content.shortTitle = "E / E₀";
  content.high = top;
  for (const double level : {1.0, 0.0, 2.0, 3.0}) {
    if (level < content.high) content.ticks.push_back({level, roundedText(level, 1)});
  }
  const auto total = [](const physics::Sample& sample) { return sample.total(); };
  if (context.scene.simulation.model == physics::Model::Particles) {
    // Where book and springs tremble, both are bands; the springs' is the narrower.
    content.series = {seriesOf(context, "kinetic", "T", kKineticColour, start,
                               [](const physics::Sample& sample) { return sample.kinetic; }),
                      seriesOf(context, "springs", "U", kSpringColour, start,
                               [](const physics::Sample& sample) { return sample.potential; }),
                      seriesOf(context, "total", "E", kTotalColour, start, total)};
  } else {
    content.series = {seriesOf(context, "kinetic", "T", kKineticColour, start, total)};
  }
  return content;
}

ChartContent errorContent(const OverlayContext& context) {
  ChartContent content;
  content.title = "Angle to the exact motion";
  content.shortTitle = "Error";
  content.high = 180;
  content.ticks = {{0, "0°"}, {180, "180°"}, {90, "90°"}};
  content.series = {seriesOf(context, "", "", kErrorColour, 1,
                             [](const physics::Sample& sample) { return sample.errorDeg; })};
  return content;
}

std::unique_ptr<DrawnOverlay> makeEnergyChart(const OverlayContext& context, const Box& box) {
  const double top = std::max(energyTop(context.trajectory), context.energyTop);
  return std::make_unique<StripChart>(context, box, energyContent(context, top));
}

std::unique_ptr<DrawnOverlay> makeErrorChart(const OverlayContext& context, const Box& box) {
  return std::make_unique<StripChart>(context, box, errorContent(context));
}

}  // namespace rotatebook::overlay
