// Poinsot's construction, as clips draw it: the inertia ellipsoid rolls on a plane across L; the point where they touch leaves curves on both.

const kRollingTrail = 20;  // [s]
const kRolling = {ellipsoid: "#b8dbff", plane: kColours.momentum, polhode: kColours.omega, now: "#ffffff", separatrix: "#f7f5ed"};
const kBehind = 0.3;       // Opacity of what the ellipsoid or the body hides.

const plus = (a, b, factor = 1) => a.map((part, axis) => part + factor * b[axis]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** Returns a function that takes a vector's parts along three others. */
function partsAlong([a, b, c]) {
  const normals = [cross(b, c), cross(c, a), cross(a, b)], volume = dot(a, normals[0]);
  return (vector) => normals.map((normal) => dot(vector, normal) / volume);
}

/** Returns a function that says whether the body of a sample, taken for a box, hides a point from the eye; as body_box.cpp. */
function hidingBody(sample, eye) {
  const middle = middleOf(sample), halves = [0, 1, 2].map(() => [0, 0, 0]);
  for (let i = 0; i < 8; ++i) halves.forEach((half, axis) => cornerOf(sample, i).forEach((part, k) => { half[k] += ((i >> axis) & 1 ? part : -part) / 8; }));
  const inBox = partsAlong(halves), start = inBox(plus([...eye], middle, -1));
  return (point) => {
    const ray = plus(inBox(plus(point, middle, -1)), start, -1), at = [-1, 1].map((side) => ray.map((part, axis) => (side - start[axis]) / part));
    const enters = Math.max(...at[0].map((a, axis) => Math.min(a, at[1][axis]))), leaves = Math.min(...at[0].map((a, axis) => Math.max(a, at[1][axis])));
    return enters > 0 && enters < leaves && enters < 1 - 1e-6;
  };
}

function circle(centre, a, b) {
  return Array.from({length: 97}, (_, i) => plus(plus(centre, a, Math.cos(i * Math.PI / 48)), b, Math.sin(i * Math.PI / 48)));
}

/** Returns the polhodes as curves of the unit sphere, of which the ellipsoid is an image: the separatrix first. */
function unitPolhodes(moments) {
  const inverse = moments.map((moment) => 1 / moment), order = [0, 1, 2].sort((a, b) => inverse[a] - inverse[b]);
  const curves = [];
  for (const share of [1, 0.25, 0.65]) {
    for (const about of [order[0], order[2]]) {
      if (inverse[about] === inverse[order[1]]) continue;
      const curve = polhodeCurve(moments, inverse[about] + share * (inverse[order[1]] - inverse[about]), about);
      for (const sign of [1, -1]) {
        curves.push({isSeparatrix: share === 1, points: curve.map((momentum) => {
          const scaled = momentum.map((part, axis) => (axis === about ? sign : 1) * part / Math.sqrt(moments[axis]));
          return sized(scaled, 1);
        })});
      }
    }
  }
  return curves;
}

class Rolling {
  /** `overlay`: of the book's picture; `poinsot`: of the core; `book`: {eye, sample}, the camera's place and what is drawn. */
  constructor(overlay, poinsot, moments, {eye, sample}) {
    Object.assign(this, {overlay, poinsot, moments});
    this.inUnits = partsAlong(poinsot.ellipsoid);
    this.eye = this.#unitOf([...eye]);
    this.hides = hidingBody(sample, eye);
    this.foot = plus(poinsot.centre, poinsot.normal, poinsot.distance);
    this.isBeyondPlane = dot(plus([...eye], this.foot, -1), poinsot.normal) > 0;
  }

  /** Returns a point as the unit sphere has it, of which the ellipsoid is an image. */
  #unitOf(point) { return this.inUnits(plus(point, this.poinsot.centre, -1)); }

  #placed(unit) {
    const [a, b, c] = this.poinsot.ellipsoid;
    return plus(plus(plus(this.poinsot.centre, a, unit[0]), b, unit[1]), c, unit[2]);
  }

  /** A curve, faint behind the body; on the ellipsoid also on its side away from the eye. */
  #curve(points, colour, width, opacity, isOnEllipsoid = false) {
    const isFar = (point) => isOnEllipsoid && dot(this.#unitOf(point), this.eye) < 1;
    this.overlay.curve(points, colour, width, opacity, points.map((point) => isFar(point) || this.hides(point)));
  }

  draw() {
    if (this.isBeyondPlane) this.#ellipsoid();
    this.#plane();
    if (!this.isBeyondPlane) this.#ellipsoid();
    this.#trails();
  }

  #ellipsoid() {
    const {overlay} = this, size = Math.hypot(...this.eye);
    if (size > 1) {
      const toward = sized(this.eye, 1), a = sized(cross(toward, Math.abs(toward[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]), Math.sqrt(1 - 1 / size ** 2));
      const rim = circle(sized(this.eye, 1 / size), a, cross(toward, a)).map((unit) => this.#placed(unit));
      overlay.area(rim, kRolling.ellipsoid, 0.13);
      overlay.curve(rim, kRolling.ellipsoid, 1, 0.75);
    }
    for (const {isSeparatrix, points} of unitPolhodes(this.moments)) {
      const [colour, width, opacity] = isSeparatrix ? [kRolling.separatrix, 1, 0.85] : [kRolling.ellipsoid, 0.8, 0.6];
      this.#curve(points.map((unit) => this.#placed(unit)), colour, width, opacity, true);
    }
  }

  #ring(radius) {
    const [a, b] = this.poinsot.plane;
    return circle(this.foot, a.map((part) => radius * part), b.map((part) => radius * part));
  }

  #plane() {
    const {overlay, poinsot} = this, edge = this.#ring(Math.max(1.25 * poinsot.greatest, 0.62 * poinsot.longest));
    overlay.area(edge, kRolling.plane, 0.12);
    this.#curve(edge, kRolling.plane, 1.2, 0.8);
    for (const radius of [poinsot.least, poinsot.greatest]) this.#curve(this.#ring(radius), kRolling.plane, 0.8, 0.6);
  }

  #trails() {
    const {overlay, poinsot} = this, {centre, polhode, herpolhode} = poinsot, touch = polhode[polhode.length - 1];
    this.#curve(herpolhode, kRolling.plane, 1.3, 0.9);
    this.#curve(polhode, kRolling.polhode, 1.3, 0.9, true);
    overlay.curve([centre, this.foot], kRolling.plane, 1.2, 0.9);
    overlay.curve([centre, touch], kRolling.polhode, 1.2, 0.9);
    overlay.dot(this.foot, kRolling.plane, 2);
    overlay.dot(touch, kRolling.now, 3);
  }
}
