// A clip's plots: energy, tilt and error over simulated time, on the clock of its player.
"use strict";

const kPlotHeight = 140;  // [CSS pixels]; of .curves in the style, too
const kSeriesColours = 6;
// An error that never exceeds this is of rounding alone, as the exact motion's own, and is no sight. [degrees]
const kLargestNoise = 1e-10;
// A curve is a line that goes up and down by less than this share of its plot's height.
const kLine = 0.01;

/** The colour that the page's style calls `name`, as the theme has it, for a canvas. */
function colourOf(name) {
  const probe = document.createElement("i");
  probe.style.color = "var(" + name + ")";
  document.body.append(probe);
  const colour = getComputedStyle(probe).color;
  probe.remove();
  return colour;
}

const seriesColour = (index) => "--series-" + (index % kSeriesColours + 1);

/** A number for people: four digits, or a power of ten. */
function numberText(value) {
  if (value === null || value === undefined) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  return say.number(size >= 1e-3 && size < 1e5 ? Number(value.toPrecision(4)) : value.toExponential(2).replace("+", ""));
}

/** The same on an axis, where there is little room. */
function tickText(value) {
  if (value === null) return "";
  const text = numberText(value);
  return text.includes("e") ? value.toExponential(0).replace("+", "") : text;
}

/** What there is to plot of a clip: [{title, series: [{label, values}], range}]. */
function chartsOf(clip) {
  const several = clip.motions.length > 1;
  const each = (key) => clip.motions.map((motion) => ({label: motion.label, values: motion[key]}));
  const only = clip.motions[0];
  const energies = [{label: say("total"), values: only.total}];
  if (only.springs) energies.push({label: say("kinetic"), values: only.kinetic}, {label: say("springs"), values: only.potential});
  // A rigid body's energy hardly leaves 1, and that it does is what there is to see.
  const energyRange = only.springs && !several ? {from: 0} : {from: 1, least: 0.1};
  const one = (key, label) => several ? each(key) : [{label, values: only[key]}];
  const isNoise = clip.motions.every(({error}) => error.every((value) => value !== null && value <= kLargestNoise));
  const charts = [
    {title: several ? say("Total energy as a share of the start’s") : say("Energy as a share of the start’s total"), series: several ? each("total") : energies, canBeLog: true, ...energyRange},
    {title: say("Tilt of the spun axis [°]"), series: one("tilt", say("tilt")), from: 0, to: 180},
  ];
  if (!isNoise) charts.push({title: say("Error against the exact motion [°]"), series: one("error", say("error")), from: 0, canBeLog: true});
  return charts;
}

/** The range of an axis that shows `low` to `high` and the chart's own bounds, and no less than its least span. */
function rangeOf(chart, low, high) {
  if (low === null || high === null) return [0, 1];
  const bottom = Math.min(low, chart.from);
  const top = Math.max(high, chart.to ?? chart.from);
  const span = top - bottom;
  if (span < (chart.least ?? 0)) return [(bottom + top - chart.least) / 2, (bottom + top + chart.least) / 2];
  if (span === 0) return [bottom, bottom + 1];
  return [bottom, chart.to === undefined ? top + 0.06 * span : top];
}

/** The smallest and the largest value of some series; null without any. */
function boundsOf(series) {
  const known = series.flatMap(({values}) => values.filter((value) => value !== null));
  const least = (start, pick) => known.reduce((a, b) => pick(a, b), start);
  return known.length === 0 ? [null, null] : [least(Infinity, Math.min), least(-Infinity, Math.max)];
}

/** Whether nothing is to be seen in a chart but lines. */
function isOfLines(chart) {
  const [bottom, top] = rangeOf(chart, ...boundsOf(chart.series));
  return chart.series.every((one) => {
    const [low, high] = boundsOf([one]);
    return high - low < kLine * (top - bottom);
  });
}

/**
 * A plot's heading, legend and place, which don't change when draw() is called, later, for its curves. One of lines says so, and is
 * folded.
 */
class Plot {
  constructor(parent, chart, times, clip, player) {
    this.chart = chart;
    this.times = times;
    this.clip = clip;
    this.player = player;
    this.logarithmic = false;
    this.isFolded = isOfLines(chart);
    this.element = document.createElement(this.isFolded ? "details" : "div");
    this.element.className = "plot";
    parent.append(this.element);
    this.element.append(this.isFolded ? this.words() : this.heading(), this.legend());
    this.element.addEventListener("toggle", () => this.draw());
    this.canvas = document.createElement("div");
    this.canvas.className = "curves";
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", this.summary());
    this.element.append(this.canvas);
    this.showValues();
  }

  /** In place of a line. */
  words() {
    const words = document.createElement("summary");
    const texts = this.chart.series.map((one) => {
      const [low, high] = boundsOf([one]).map(numberText);
      return low === high ? say("{value} throughout", {value: low}) : say("{low} to {high}", {low, high});
    });
    const areAlike = texts.every((text) => text === texts[0]);
    words.textContent = this.chart.title + ": " + (areAlike ? texts[0] : this.chart.series.map(({label}, i) => label + " " + texts[i]).join("; "));
    return words;
  }

  heading() {
    const heading = document.createElement("h3");
    heading.append(this.chart.title);
    if (!this.chart.canBeLog) return heading;
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = say("log");
    button.title = say("Logarithmic axis");
    button.setAttribute("aria-pressed", "false");
    button.addEventListener("click", () => {
      this.logarithmic = !this.logarithmic;
      button.setAttribute("aria-pressed", String(this.logarithmic));
      if (this.plot) this.draw();
    });
    heading.append(button);
    return heading;
  }

  legend() {
    const list = document.createElement("ul");
    list.className = "legend";
    this.values = this.chart.series.map((series, index) => {
      const item = document.createElement("li");
      const line = document.createElement("i");
      line.style.borderColor = "var(" + seriesColour(index) + ")";
      const value = document.createElement("b");
      item.append(line, series.label + " ", value);
      list.append(item);
      return value;
    });
    return list;
  }

  summary() {
    const parts = this.chart.series.map(({label, values}) => {
      const [low, high] = boundsOf([{values}]).map(numberText);
      return say("{label} from {low} to {high}", {label, low, high});
    });
    return this.chart.title + ": " + parts.join("; ");
  }

  draw() {
    if (this.isFolded && !this.element.open) return;
    if (this.plot) this.plot.destroy();
    const positive = (value) => value > 0 ? value : null;
    const columns = this.chart.series.map(({values}) => {
      const padded = this.times.map((time, index) => values[index] ?? null);
      return this.logarithmic ? padded.map(positive) : padded;
    });
    this.plot = new uPlot(this.options(), [this.times, ...columns], this.canvas);
    this.playhead = document.createElement("div");
    this.playhead.className = "playhead";
    this.plot.over.append(this.playhead);
    this.connectPointer();
  }

  options() {
    const axis = (size) => ({
      stroke: () => colourOf("--soft"),
      grid: {stroke: () => colourOf("--line"), width: 1},
      ticks: {show: false},
      font: "12px system-ui, sans-serif",
      gap: 4,
      size,
    });
    const linear = {range: (plot, low, high) => rangeOf(this.chart, low, high)};
    return {
      width: this.canvas.clientWidth,
      height: kPlotHeight,
      padding: [8, 8, 0, 0],
      legend: {show: false},
      cursor: {y: false, drag: {x: false, y: false}, points: {show: false}, sync: {key: this.player.section.id}},
      scales: {x: {time: false}, y: this.logarithmic ? {distr: 3} : linear},
      axes: [
        {...axis(22), space: 50, values: (plot, ticks) => ticks.map((tick) => say.number(tick) + " s")},
        {...axis(44), space: 28, values: (plot, ticks) => ticks.map((tick) => tickText(tick))},
      ],
      series: [{}, ...this.chart.series.map((series, index) => ({
        label: series.label,
        stroke: () => colourOf(seriesColour(index)),
        width: 1.5,
        pxAlign: 0,
        points: {show: false},
      }))],
      hooks: {setCursor: [() => this.showValues()], draw: [() => this.follow()]},
    };
  }

  connectPointer() {
    const over = this.plot.over;
    const seek = (event) => {
      const x = event.clientX - over.getBoundingClientRect().left;
      this.player.seek(this.player.frameNearest(this.plot.posToVal(x, "x")));
    };
    over.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      over.setPointerCapture(event.pointerId);
      seek(event);
    });
    over.addEventListener("pointermove", (event) => {
      if (over.hasPointerCapture(event.pointerId)) seek(event);
    });
  }

  /** Moves the playhead to the player's frame. A clip that holds its last picture has no more samples. */
  follow() {
    if (!this.plot) return;
    const index = Math.min(this.player.frame, this.times.length - 1);
    const x = this.plot.valToPos(this.times[index], "x");
    this.playhead.style.transform = "translateX(" + x + "px)";
    this.playhead.dataset.index = index;
    this.showValues();
  }

  showValues() {
    const hovered = this.plot?.cursor.idx;
    const index = hovered ?? Math.min(this.player.frame, this.times.length - 1);
    this.chart.series.forEach(({values}, series) => {
      this.values[series].textContent = numberText(values[index]);
    });
  }

  resize() {
    const width = this.canvas.clientWidth;
    if (!this.plot || width === 0 || width === this.plot.width) return;
    this.plot.setSize({width, height: kPlotHeight});
  }
}

/** Makes the plots of a clip beside its player, still without their curves; returns them. */
function makePlots(section, clip, player) {
  const parent = section.querySelector(".plots");
  const longest = Math.max(...clip.motions.map((motion) => motion.tilt.length));
  const times = player.times.slice(0, longest);
  const charts = chartsOf(clip).sort((a, b) => isOfLines(a) - isOfLines(b));
  const plots = charts.map((chart) => new Plot(parent, chart, times, clip, player));
  section.classList.toggle("without-curves", plots.every(({isFolded}) => isFolded));
  player.addEventListener("frame", () => plots.forEach((plot) => plot.follow()));
  new ResizeObserver(() => plots.forEach((plot) => plot.resize())).observe(parent);
  return plots;
}
