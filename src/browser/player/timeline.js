// The time line: the kept motion as a curve of tilt, with half-turns and throws, and a slider over it.

const kSlowest = 0.25, kSlowFrom = 15;  // Of the speed; of the tilt, down to the slowest at twice as much [degrees].
const kBookColours = ["#8fc7f0", "#f0b070", "#7fd6ab", "#dba3da", "#dcc664", "#f2978d"];

/** Returns the colour of a book's curve: above so many books, the same for all. */
const colourOfCurve = (book, books) => kBookColours[books > kBookColours.length ? 0 : book];

/** Names the lines over the book that are shown, and the curves of so many books, in their colours. */
function showNames(list, scene, books) {
  const lines = [...list.querySelectorAll("[data-of]")];
  for (const line of lines) line.hidden = !scene.shows(line.dataset.of);
  if (list.dataset.books === String(books)) return;
  list.dataset.books = books;
  for (const line of lines) line.firstChild.style.background = inkOfLook(kColours[line.dataset.of]);
  const each = books > kBookColours.length ? 1 : books;
  const stripes = Array.from({length: each}, (_, i) => `${inkOfLook(colourOfCurve(i, books))} ${100 * i / each}% ${100 * (i + 1) / each}%`);
  for (const mark of list.querySelectorAll("li:not([data-of]) i")) mark.style.background = `linear-gradient(90deg, ${stripes})`;
}

class Timeline {
  /** `slider`: the input over the canvas. */
  constructor(canvas, slider) {
    this.canvas = canvas;
    this.slider = slider;
    this.clear(1);
  }

  /** Forgets what it knows. */
  clear(motions) {
    this.tracks = Array.from({length: motions}, () => []);
    this.events = [];
    this.isStale = true;
  }

  /** Takes in the frames that are simulated by now. */
  extend(core, simulated) {
    this.tracks.forEach((track, motion) => {
      for (let frame = track.length; frame < simulated; ++frame) {
        const [tilt, halfTurns, held] = core.numbers(kPlayed, motion, frame, [kSample.tilt, kSample.halfTurns, kSample.held]);
        const before = track[frame - 1];
        if (before && halfTurns > before.halfTurns) this.events.push({frame, motion, halfTurns});
        if (held && !before?.held) this.events.push({frame, motion, isEnd: true});
        track.push({tilt, halfTurns, held});
        this.isStale = true;
      }
    });
  }

  /** Returns the share of its speed at which a motion that turns over is seen, less while it does: at the tilt of a book that is on its way. */
  slowness(frame) {
    const shares = this.tracks.map((track, motion) => {
      if (!this.events.some((event) => event.motion === motion && event.halfTurns)) return 1;
      const {tilt} = track[Math.min(frame, track.length - 1)], off = Math.min(tilt, 180 - tilt);
      return 1 - (1 - kSlowest) * Math.max(0, Math.min((off - kSlowFrom) / kSlowFrom, 1));
    });
    return Math.min(...shares, 1);
  }

  /** `frames`: of the whole clip; `nudges`: shares of it at which the book was thrown; `isSecret`: without what will happen. */
  draw(frames, simulated, nudges, isSecret) {
    const sharpness = devicePixelRatio || 1, scale = sharpness * letterSize();
    const width = Math.round(this.canvas.clientWidth * sharpness), height = Math.round(this.canvas.clientHeight * sharpness);
    const state = [width, height, frames, simulated, nudges.join(), isSecret, this.isLight].join(" ");
    if (!this.isStale && state === this.drawn) return;
    this.drawn = state;
    this.isStale = false;
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    const context = this.canvas.getContext("2d", kOnProcessor);
    context.clearRect(0, 0, width, height);
    const x = (frame) => frame / Math.max(frames - 1, 1) * width;
    context.fillStyle = "rgba(128, 128, 128, 0.1)";
    context.fillRect(0, 0, x(simulated), height);
    if (isSecret) return;
    const colourOf = (book) => colourOfCurve(book, this.tracks.length);
    this.tracks.forEach((track, motion) => this.#curve(context, track, x, height, colourOf(motion), scale));
    for (const event of this.events) this.#mark(context, x(event.frame), height, event.isEnd ? kBookColours[5] : colourOf(event.motion), scale);
    for (const nudge of nudges) this.#mark(context, nudge * width, height, kColours.omega, scale, true);
  }

  #curve(context, track, x, height, colour, scale) {
    const step = Math.max(Math.floor(track.length / 4000), 1), margin = 3 * scale;
    context.strokeStyle = inkOf(colour, this.isLight);
    context.lineWidth = 1.4 * scale;
    context.beginPath();
    for (let frame = 0; frame < track.length; frame += step) {
      const y = height - margin - track[frame].tilt / 180 * (height - 2 * margin);
      if (frame === 0) context.moveTo(x(frame), y);
      else context.lineTo(x(frame), y);
    }
    context.stroke();
  }

  #mark(context, x, height, colour, scale, isThrow = false) {
    context.fillStyle = inkOf(colour, this.isLight);
    context.globalAlpha = isThrow ? 0.9 : 0.55;
    if (isThrow) context.fillRect(x - scale, 0, 2 * scale, height);
    else context.fillRect(x - scale / 2, height * 0.72, scale, height * 0.28);
    context.globalAlpha = 1;
  }
}
