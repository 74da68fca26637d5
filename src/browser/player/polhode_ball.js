// The ball of all spins of one size: the angular momentum in the book's axes moves on it along the curves of equal energy.

const kBallView = [0.55, 0.42];  // Turned to the right and up. [rad]
const kCurves = [0.03, 0.12, 0.3, 0.55, 0.85];  // Shares of the way from an axis to the separatrix.
const kTrailFrames = 240;
const kTrailStep = 2;        // [frames]
const kLongestChord = Math.cos(0.5);  // A longer one would cut through the ball.
const kBallColours = {ball: "#23262b", rim: "#4a4f57", curve: "#6d737c", separatrix: "#f7f5ed", trail: "#e899d9", now: "#ffffff"};

/** Returns the points of a curve of energy `energy` about axis `about`, on its positive side; sizes of L and L² are 1. */
function polhodeCurve(moments, energy, about) {
  const [p, q] = [0, 1, 2].filter((axis) => axis !== about);
  const inverse = moments.map((moment) => 1 / moment);
  const share = (axis) => Math.sqrt(Math.max((energy - inverse[about]) / (inverse[axis] - inverse[about]), 0));
  const points = [];
  for (let i = 0; i <= 96; ++i) {
    const point = [0, 0, 0], angle = i / 48 * Math.PI;
    point[p] = share(p) * Math.cos(angle);
    point[q] = share(q) * Math.sin(angle);
    point[about] = Math.sqrt(Math.max(1 - point[p] ** 2 - point[q] ** 2, 0));
    points.push(point);
  }
  return points;
}

class PolhodeBall {
  constructor(canvas) {
    this.canvas = canvas;
    this.fixed = document.createElement("canvas");  // What stays from picture to picture.
    const [a, b] = kBallView;
    // Rows: right, up, toward the viewer; the cover's axis z looks at the viewer, y is up.
    this.rows = [[Math.cos(a), 0, -Math.sin(a)],
      [-Math.sin(a) * Math.sin(b), Math.cos(b), -Math.cos(a) * Math.sin(b)],
      [Math.sin(a) * Math.cos(b), Math.sin(b), Math.cos(a) * Math.cos(b)]];
  }

  #place(point) {
    const [x, y, depth] = this.rows.map((row) => row[0] * point[0] + row[1] * point[1] + row[2] * point[2]);
    return [this.middle + this.radius * x, this.middle - this.radius * y, depth];
  }

  /** Returns the direction in the book's axes that a point of the canvas shows, null beside the ball. */
  directionAt(x, y) {
    const u = (x - this.middle) / this.radius, v = (this.middle - y) / this.radius, flat = u * u + v * v;
    if (flat > 1) return null;
    const seen = [u, v, Math.sqrt(1 - flat)];
    return [0, 1, 2].map((axis) => this.rows.reduce((sum, row, i) => sum + row[axis] * seen[i], 0));
  }

  #ink(colour) { return inkOf(colour, this.isLight); }

  #curve(context, points, colour, width) {
    for (const isFront of [false, true]) {
      context.beginPath();
      let isDown = false;
      for (const point of points) {
        const [x, y, depth] = this.#place(point);
        if (depth >= 0 !== isFront) { isDown = false; continue; }
        if (isDown) context.lineTo(x, y);
        else context.moveTo(x, y);
        isDown = true;
      }
      context.globalAlpha = isFront ? 1 : 0.22;
      context.strokeStyle = this.#ink(colour);
      context.lineWidth = width;
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  #ground(context, moments, unit) {
    const inverse = moments.map((moment) => 1 / moment);
    const order = [0, 1, 2].sort((a, b) => inverse[a] - inverse[b]), middle = inverse[order[1]];
    context.fillStyle = this.#ink(kBallColours.ball);
    context.beginPath();
    context.arc(this.middle, this.middle, this.radius, 0, 2 * Math.PI);
    context.fill();
    context.strokeStyle = this.#ink(kBallColours.rim);
    context.lineWidth = unit;
    context.stroke();
    for (const about of [order[0], order[2]]) {
      if (inverse[about] === middle) continue;
      const mirrored = (points) => points.map((point) => point.map((part, axis) => (axis === about ? -part : part)));
      for (const share of [...kCurves, 1]) {
        const points = polhodeCurve(moments, inverse[about] + share * (middle - inverse[about]), about);
        const isLast = share === 1;
        for (const curve of [points, mirrored(points)]) {
          this.#curve(context, curve, isLast ? kBallColours.separatrix : kBallColours.curve, isLast ? 1.3 * unit : 0.8 * unit);
        }
      }
    }
  }

  #letters(context, unit) {
    context.font = `600 ${12 * unit}px system-ui, sans-serif`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    kAxes.forEach((axis, i) => {
      const [x, y, depth] = this.#place(kAxes.map((other) => (other === axis ? 1.13 : 0)));
      context.globalAlpha = depth < 0 ? 0.4 : 1;
      context.fillStyle = this.#ink(kColours.axes[i]);
      context.fillText(axis, x, y);
    });
    context.globalAlpha = 1;
  }

  /** Draws the ball, its curves and letters, unless they are there as they shall be. */
  #drawFixed(moments, size, scale) {
    const key = [size, scale, this.isLight, ...moments].join();
    if (key === this.fixedKey) return;
    this.fixedKey = key;
    this.fixed.width = this.fixed.height = size;
    const context = this.fixed.getContext("2d", kOnProcessor);
    this.#ground(context, moments, scale);
    this.#letters(context, scale);
  }

  /** `trail`: directions of L in the book's axes, the last of them now; `size` and the width of a line, `scale`, in pixels. */
  draw(moments, trail, size = Math.round(this.canvas.clientWidth * (devicePixelRatio || 1)), scale = (devicePixelRatio || 1) * letterSize()) {
    if (size === 0) return;
    if (this.canvas.width !== size) this.canvas.width = this.canvas.height = size;
    this.middle = size / 2;
    this.radius = 0.415 * size;
    this.#drawFixed(moments, size, scale);
    const context = this.canvas.getContext("2d", kOnProcessor);
    context.clearRect(0, 0, size, size);
    context.drawImage(this.fixed, 0, 0);
    this.#curve(context, trail, kBallColours.trail, 2 * scale);
    const [x, y, depth] = this.#place(trail[trail.length - 1]);
    context.globalAlpha = depth < 0 ? 0.45 : 1;
    context.fillStyle = this.#ink(kBallColours.now);
    context.beginPath();
    context.arc(x, y, 4 * scale, 0, 2 * Math.PI);
    context.fill();
    context.globalAlpha = 1;
  }
}

/** Returns the directions of L in a book's axes up to a frame, that of the frame last; as far back as they follow one another closely. */
function trailOf(core, book, frame) {
  const at = (then) => momentumInBook(core.sample(kPlayed, book, then)), trail = [at(frame)];
  for (let then = frame - kTrailStep; then >= Math.max(frame - kTrailFrames, 0); then -= kTrailStep) {
    const place = at(then);
    if (place.reduce((sum, part, axis) => sum + part * trail[0][axis], 0) < kLongestChord) break;
    trail.unshift(place);
  }
  return trail;
}

/** Returns the direction of L in the book's axes. */
function momentumInBook(sample) {
  const [w, x, y, z] = sample.subarray(kSample.attitude, kSample.attitude + 4);
  const momentum = sample.subarray(kSample.momentum, kSample.momentum + 3);
  const size = Math.hypot(...momentum) || 1;
  return turned([w, -x, -y, -z], [...momentum]).map((part) => part / size);
}
