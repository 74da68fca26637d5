// The ladder of energies, as clips draw it: at the ends there is one place for L, in the middle a whole way round.

const kLadderShape = 0.72;  // Its width, in heights.
const kLadderColours = {outline: "#6bbff2", now: "#ffffff", momentum: kColours.momentum, words: "#d6d3cb"};

class Ladder {
  constructor(canvas) { this.canvas = canvas; }

  /** `ladder`: of the core; `height` and the width of a line, `scale`, in pixels. */
  draw({now, rungs, outline}, height = Math.round(this.canvas.clientHeight * (devicePixelRatio || 1)), scale = (devicePixelRatio || 1) * letterSize()) {
    if (height === 0) return;
    const width = Math.round(kLadderShape * height);
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    const context = this.context = this.canvas.getContext("2d", kOnProcessor), margin = 12 * scale;
    context.clearRect(0, 0, width, height);
    const right = width - 26 * scale;
    this.place = (angle, share) => [8 * scale + (right - 8 * scale) * (0.5 + angle), height - margin - share * (height - 2 * margin)];
    this.#outline(outline, scale);
    for (const rung of rungs) this.#rung(rung, right, scale);
    if (Number.isFinite(now.height)) this.#now(now, scale);
  }

  #line(points, colour, width) {
    const {context} = this;
    context.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
    context.strokeStyle = inkOf(colour, this.isLight);
    context.lineWidth = width;
    context.stroke();
  }

  #outline(outline, scale) {
    const {context} = this, points = [...outline.map(({height, reach}) => this.place(reach, height)), ...outline.map(({height, reach}) => this.place(-reach, height)).reverse()];
    this.#line([...points, points[0]], "#8a8e96", scale);
    context.globalAlpha = 0.16;
    context.fillStyle = inkOf(kLadderColours.outline, this.isLight);
    context.fill();
    context.globalAlpha = 1;
  }

  #rung({axis, isTurned, height, reach}, right, scale) {
    const {context} = this, colour = kColours.axes[axis], [x, y] = this.place(reach, height);
    this.#line([this.place(-reach, height), [x, y]], colour, 1.4 * scale);
    this.#line([[x, y], [right + 4 * scale, y]], colour, 0.6 * scale);
    for (const side of [-1, 1]) this.#dot(this.place(side * reach, height), colour, 2.4 * scale);
    context.font = `600 ${12 * scale}px system-ui, sans-serif`;
    context.textBaseline = "middle";
    context.fillStyle = inkOf(colour, this.isLight);
    context.fillText((isTurned ? "123" : "xyz")[axis], right + 8 * scale, y);
  }

  #now({height, reach, angle}, scale) {
    const [x, y] = this.place(-reach, height);
    this.#line([[x, y], this.place(reach, height)], kLadderColours.now, 1.4 * scale);
    this.#dot(this.place(angle, height), kLadderColours.momentum, 4 * scale);
  }

  #dot([x, y], colour, radius) {
    const {context} = this;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = inkOf(colour, this.isLight);
    context.fill();
  }
}
