// Lines over the picture: arrows, axes, springs, the ghost's outline, the hand's throw.

const kColours = {omega: "#fad14d", momentum: "#e899d9", axes: ["#f57552", "#47cc9e", "#6bb0fa"], ghost: "#b8ebff", halo: "rgba(10, 11, 15, 0.75)"};
/** Inks of the light look, by those of the dark one: of the same hue, for a light wall. */
const kLightInks = {"#fad14d": "#7a5800", "#e899d9": "#a3138f", "#f57552": "#b81428", "#47cc9e": "#00664b", "#6bb0fa": "#1858b8", "#b8ebff": "#0a6482",
  "rgba(10, 11, 15, 0.75)": "rgba(255, 255, 255, 0.8)", "#f7f5ed": "#33363d", "#f28c40": "#a63c00", "#5ca8fa": "#0a50d0", "#4dcc9e": "#006e3c",
  "#8fc7f0": "#0e6294", "#f0b070": "#944800", "#7fd6ab": "#0f6a3b", "#dba3da": "#8a3592", "#dcc664": "#685d00", "#f2978d": "#a8352b",
  "#b8dbff": "#2860a0", "#ffffff": "#16171a", "#23262b": "#ffffff"};
const inkOf = (colour, isLight) => (isLight && kLightInks[colour]) || colour;
/** For a style: of the look there. */
const inkOfLook = (colour) => `light-dark(${kLightInks[colour]}, ${colour})`;
// Of a canvas's context: a few lines are drawn by the processor, in less time than a slow graphics card takes for them.
const kOnProcessor = {willReadFrequently: true};
const kEdges = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
const kFaces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
const kStrain = {compressed: [64, 140, 255], rest: [219, 219, 219], stretched: [255, 120, 41]};
const kLargestStrain = 0.03;
const kLightStrain = 0.6;  // Of these colours in the light look.
// In units of the distance from the middle of the book to its corners, as in the program's clips.
const kReach = {omega: 0.86, momentum: 1, axis: 0.17, shortestAxis: 0.75};

/** Returns how large the page's letters are, 1 where they are as usual: lines of the picture are as thick. */
const letterSize = () => parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;

const cornerOf = (sample, i) => sample.subarray(kSample.corners + 3 * i, kSample.corners + 3 * i + 3);

function middleOf(sample) {
  const middle = [0, 0, 0];
  for (let i = 0; i < 8; ++i) cornerOf(sample, i).forEach((part, axis) => { middle[axis] += part / 8; });
  return middle;
}

/** Returns the product of two quaternions (w, x, y, z): the second turn, then the first. */
function times([w, x, y, z], [a, b, c, d]) {
  return [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c + y * a + z * b - x * d, w * d + z * a + x * c - y * b];
}

/** Returns the turn that undoes another. */
const undone = ([w, x, y, z]) => [w, -x, -y, -z];

/** Turns a vector by a unit quaternion (w, x, y, z). */
function turned([w, x, y, z], [a, b, c]) {
  const s = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * s[0] + y * s[2] - z * s[1], b + w * s[1] + z * s[0] - x * s[2], c + w * s[2] + x * s[1] - y * s[0]];
}

/** Returns the pixel that shows a point of the world, null if it is behind the camera. */
function projected(matrix, area, [x, y, z]) {
  const row = (i) => matrix[i] * x + matrix[4 + i] * y + matrix[8 + i] * z + matrix[12 + i];
  const w = row(3);
  if (w <= 0) return null;
  return [area.x + area.width * (0.5 + 0.5 * row(0) / w), area.y + area.height * (0.5 - 0.5 * row(1) / w)];
}

function strainColour(strain, isLight) {
  const share = Math.min(Math.abs(strain) / kLargestStrain, 1), most = strain < 0 ? kStrain.compressed : kStrain.stretched;
  return `rgb(${kStrain.rest.map((part, i) => Math.round((isLight ? kLightStrain : 1) * (part + share * (most[i] - part)))).join(", ")})`;
}

/** Returns whether a point is in a face of the book as it is seen. */
function isOnBook(book, sample, point) {
  const corners = [...Array(8).keys()].map((i) => projected(book.matrix, book.area, cornerOf(sample, i)));
  if (corners.includes(null)) return true;
  return kFaces.some((face) => {
    const signs = face.map((corner, k) => {
      const [ax, ay] = corners[corner], [bx, by] = corners[face[(k + 1) % 4]];
      return Math.sign((bx - ax) * (point[1] - ay) - (by - ay) * (point[0] - ax));
    });
    return signs.every((sign) => sign >= 0) || signs.every((sign) => sign <= 0);
  });
}

/** Draws lines over one book's picture. */
class Overlay {
  /** `unit`: width of a line [pixels]; `isLight`: in the light look. */
  constructor(context, book, unit, isLight) {
    Object.assign(this, {context, book, unit, isLight});
    this.least = [Infinity, Infinity];  // Of the places between which lines are drawn.
    this.most = [-Infinity, -Infinity];
  }

  #reach(place) {
    place?.forEach((part, i) => {
      this.least[i] = Math.min(this.least[i], part);
      this.most[i] = Math.max(this.most[i], part);
    });
    return place;
  }

  #ink(colour) { return inkOf(colour, this.isLight); }

  path(points) {
    const context = this.context;
    context.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
  }

  /** Strokes a line with an edge of the wall's kind, so that it shows over white pages, or dark cloth. */
  stroke(points, colour, width, edge = 1.6 * this.unit) {
    if (points.includes(null)) return;
    const context = this.context;
    context.lineCap = context.lineJoin = "round";
    this.path(points);
    context.strokeStyle = this.#ink(kColours.halo);
    context.lineWidth = width + edge;
    context.stroke();
    context.strokeStyle = this.#ink(colour);
    context.lineWidth = width;
    context.stroke();
  }

  place(point) { return this.#reach(projected(this.book.matrix, this.book.area, point)); }

  /** `letter` stands at its tip, if there is one; `width` in units. */
  arrow(from, to, colour, letter, width = 2) {
    const a = this.place(from), b = this.place(to);
    if (!a || !b) return;
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const head = Math.min((5 + 2 * width) * this.unit, 0.4 * length);
    const along = length > 0 ? [(b[0] - a[0]) / length, (b[1] - a[1]) / length] : [0, 0];
    const side = (sign) => [b[0] - head * along[0] + sign * 0.45 * head * along[1], b[1] - head * along[1] - sign * 0.45 * head * along[0]];
    this.stroke([a, b], colour, width * this.unit);
    if (length > 2) this.stroke([side(1), b, side(-1)], colour, width * this.unit);
    if (letter) this.#letter(letter, [b[0] + 11 * this.unit * along[0], b[1] + 11 * this.unit * along[1]], colour);
  }

  /** A line through points of the world; faint where `isHidden` says so of a point. */
  curve(points, colour, width, opacity, isHidden = []) {
    const context = this.context, places = points.map((point) => this.place(point));
    context.lineCap = context.lineJoin = "round";
    context.strokeStyle = this.#ink(colour);
    context.lineWidth = width * this.unit;
    for (const faint of [true, false]) {
      context.beginPath();
      let isDown = false;
      places.forEach((place, i) => {
        if (!place || Boolean(isHidden[i]) !== faint) { isDown = false; return; }
        if (isDown) context.lineTo(...place);
        else context.moveTo(...place);
        isDown = true;
      });
      context.globalAlpha = faint ? opacity * kBehind : opacity;
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  area(points, colour, opacity) {
    const places = points.map((point) => this.place(point));
    if (places.includes(null)) return;
    this.path(places);
    this.context.globalAlpha = opacity;
    this.context.fillStyle = this.#ink(colour);
    this.context.fill();
    this.context.globalAlpha = 1;
  }

  /** `radius` in units. */
  dot(point, colour, radius) {
    const place = this.place(point);
    if (!place) return;
    for (const [fill, size] of [[kColours.halo, radius + 1], [colour, radius]]) {
      this.context.beginPath();
      this.context.arc(...place, size * this.unit, 0, 2 * Math.PI);
      this.context.fillStyle = this.#ink(fill);
      this.context.fill();
    }
  }

  #letter(text, [x, y], colour) {
    const context = this.context;
    context.font = `600 ${15 * this.unit}px system-ui, sans-serif`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineWidth = 3 * this.unit;
    context.strokeStyle = this.#ink(kColours.halo);
    context.strokeText(text, x, y);
    context.fillStyle = this.#ink(colour);
    context.fillText(text, x, y);
  }

  /** `motion`: of the scene as read; `scale`: the sizes at the start, {omega, momentum}. */
  vectors(sample, motion, scale, shown) {
    const reach = Math.hypot(...motion.body) / 2, middle = middleOf(sample);
    const tip = (first, whole, full) => [0, 1, 2].map((i) => middle[i] + sample[first + i] / whole * full * reach);
    if (shown.axes) this.#axes(sample, motion, reach, middle);
    if (shown.momentum) this.arrow(middle, tip(kSample.momentum, scale.momentum, kReach.momentum), kColours.momentum, "L");
    if (shown.omega) this.arrow(middle, tip(kSample.omega, scale.omega, kReach.omega), kColours.omega, "ω");
  }

  #axes(sample, motion, reach, middle) {
    const attitude = sample.subarray(kSample.attitude, kSample.attitude + 4);
    kAxes.forEach((axis, i) => {
      const length = Math.max(motion.body[i] / 2 + kReach.axis * reach, kReach.shortestAxis * reach);
      const direction = turned(attitude, kAxes.map((other) => (other === axis ? length : 0)));
      this.arrow(middle, middle.map((part, k) => part + direction[k]), kColours.axes[i], axis);
    });
  }

  springs(sample, springs) {
    for (const [a, b, rest] of springs) {
      const from = cornerOf(sample, a), to = cornerOf(sample, b);
      const strain = Math.hypot(from[0] - to[0], from[1] - to[1], from[2] - to[2]) / rest - 1;
      this.stroke([this.place(from), this.place(to)], strainColour(strain, this.isLight), 1.3 * this.unit, 0.7 * this.unit);
    }
  }

  outline(sample) {
    for (const [a, b] of kEdges) {
      this.stroke([this.place(cornerOf(sample, a)), this.place(cornerOf(sample, b))], kColours.ghost, 1.2 * this.unit, this.unit);
    }
  }

  /** The hand's way, while it throws. */
  hand(from, to) {
    for (const place of [from, to]) this.#reach(place);
    this.context.setLineDash([6 * this.unit, 6 * this.unit]);
    this.stroke([from, to], kColours.omega, 2 * this.unit);
    this.context.setLineDash([]);
  }
}
