// The picture: where each book is in it, at what size it is drawn, and what is drawn over it.

const kLargestScale = 2;       // Pixels of the screen a CSS pixel.
const kNamedFor = 2;           // The axes have their names at first. [s]
const kSlowPicture = 34;       // Slower than this, pictures are drawn smaller: 30 a second aren't. [ms]
const kJudgedPictures = 15;    // The middle of so many times is taken for theirs.
const kStep = 0.8, kLeastQuality = 0.5;
const kHelps = 0.9;            // Share of the time in which a smaller picture must be there to be worth it.
const kRest = 30;              // After one that wasn't, judgements without a try.
const kSettling = 0.5;         // After a throw. [s]
const kBesideLines = 26;       // Of heads and letters at their ends, in widths of a line.
const kLinesStep = 64;         // Of the size of the canvas that shows them. [pixels]
const kNameHeight = 24;        // Of a book's name, or of a letter at the end of its longest arrow. [CSS pixels]
const kLeastBetween = 0.6;     // Room between the buttons in which a book's arrows are seen, in heights of the picture.
const kPlainColours = {white: [1, 1, 1], black: [0, 0, 0], transparent: [0.075, 0.08, 0.086]};

/** Divides a picture, into so many `columns` or such that the panels' shorter sides are longest and few are empty. Returns areas [pixels]. */
function dividedAreas(count, width, height, columns = 0) {
  let best = columns || 1;
  const shorter = (each) => Math.min(width / each, height / Math.ceil(count / each));
  const empty = (each) => each * Math.ceil(count / each) - count;
  for (let each = 2; each <= count && !columns; ++each) {
    const gain = shorter(each) - shorter(best);
    if (gain > 1e-9 || (gain > -1e-9 && empty(each) <= empty(best))) best = each;
  }
  const rows = Math.ceil(count / best), cut = (whole, part, parts) => Math.round(whole * part / parts);
  return Array.from({length: count}, (_, i) => {
    const column = i % best, row = Math.floor(i / best), inRow = row + 1 < rows ? best : count - best * (rows - 1);
    const indent = (best - inRow) / 2;
    const x = cut(width, column + indent, best), y = cut(height, row, rows);
    return {x, y, width: cut(width, column + indent + 1, best) - x, height: cut(height, row + 1, rows) - y};
  });
}

/** How sharply a moving picture is drawn: less on a machine that takes long, if that helps; as before when there is time again. */
class Quality {
  constructor() {
    this.value = 1;  // Share of the sharpness.
    this.times = [];
    this.rest = 0;
    this.sharper = null;  // The time that a picture took before the last step down. [ms]
  }

  /** Takes in the time since the last picture. [ms] */
  take(passed) {
    this.times.push(passed);
    if (this.times.length < kJudgedPictures) return;
    this.#judge(this.times.sort((a, b) => a - b)[kJudgedPictures >> 1]);
    this.times = [];
  }

  #judge(took) {
    const {sharper} = this, hasHelped = sharper === null || took < kHelps * sharper;
    this.sharper = null;
    this.rest = hasHelped ? Math.max(this.rest - 1, 0) : kRest;
    if (!hasHelped) this.value /= kStep;
    else if (took > kSlowPicture && this.rest === 0 && kStep * this.value >= kLeastQuality) {
      this.sharper = took;
      this.value *= kStep;
    } else if (took < kStep ** 2 * kSlowPicture) this.value = Math.min(this.value / kStep, 1);  // In time even if all of it went to the pixels.
  }
}

class Stage {
  constructor(root, core, pictures, shaders) {
    this.picture = root.querySelector(".rb-picture");
    this.lines = document.createElement("canvas");  // As large as the picture; shown is as much as has lines.
    this.shown = root.querySelector(".rb-lines");
    this.labels = root.querySelector(".rb-labels");
    [this.scene, this.throws, this.views] = [".rb-scene", ".rb-throws", ".rb-views"].map((selector) => root.querySelector(selector));
    this.core = core;
    this.pictures = pictures;
    this.view = new BookView(this.picture, core.mesh(), pictures, shaders);
    this.quality = new Quality();
    this.books = [];
    this.settling = null;  // {book, turn}: how a book that was thrown lay, from how it lies in its own frame or that of its L.
  }

  /** The picture's size. [CSS pixels] */
  get box() { return {width: this.picture.clientWidth, height: this.picture.clientHeight}; }
  /** Pixels of the lines a CSS pixel. */
  get sharpness() { return Math.min(devicePixelRatio || 1, kLargestScale); }
  /** Pixels of the drawing a CSS pixel. */
  get scale() { return this.sharpness * (this.isMoving ? this.quality.value : 1); }

  /** Width of a line. [pixels of the lines] */
  get unit() { return this.sharpness * letterSize(); }

  #fit(canvas, scale) {
    const {box} = this;
    this.#resize(canvas, Math.max(Math.round(box.width * scale), 2), Math.max(Math.round(box.height * scale), 2));
  }

  #resize(canvas, width, height) {
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
  }

  /** Draws `frame`. `state`: {clock, scene, read, orbit, simulation, hand, flick, scales}. */
  draw(frame, state) {
    this.isMoving = state.clock.isPlaying;
    this.#fit(this.picture, this.scale);
    this.#fit(this.lines, this.sharpness);
    const {width, height} = this.picture;
    const motions = state.read.motions, areas = this.#areas(state);
    this.#takeBodies(motions, state.scene);
    this.books = motions.map((motion, i) => this.#book(i, frame, areas[i], state));
    const isPlain = this.view.lack !== "";
    if (!isPlain) this.view.draw(this.books);
    this.#drawLines(frame, state, isPlain);
    this.#placeLabels(motions, areas);
    this.#placeInsets(areas[state.book]);
  }

  /** Returns where each book is drawn. [pixels] */
  #areas(state) {
    const {width, height} = this.picture, {left, top, right, named} = this.room(state);
    const [x, y, end, label] = [left, top, right, named].map((part) => Math.round(part * width / this.box.width));
    this.above = label;  // Each book, for its name or a letter. [pixels]
    return dividedAreas(state.read.motions.length, end - x, height - y, state.scene.gridColumns)
      .map((area) => ({x: x + area.x, y: y + area.y + label, width: area.width, height: Math.max(area.height - label, 1)}));
  }

  /** Returns the part of the picture that books have, without buttons over it where they would hide arrows, and the height of what is above each. [CSS pixels] */
  room({read: {motions}, scene}) {
    const {throws, views, box} = this, room = {left: 0, top: 0, right: box.width, named: 0};
    const isShared = motions.length > 1, left = throws.offsetLeft + throws.offsetWidth;
    const isLow = throws.offsetHeight > throws.offsetWidth, between = views.offsetLeft - left;
    if (motions.length <= kMostBooks && (isShared || !isLow)) room.named = kNameHeight * letterSize();
    if (isLow) {
      if (isShared || between >= box.height) Object.assign(room, {left, right: views.offsetLeft});
    } else if (isShared || between < kLeastBetween * box.height || scene.shows("forces")) room.top = throws.offsetTop + throws.offsetHeight;
    return room;
  }

  /** Makes the bodies' meshes, unless they are those of the last picture. */
  #takeBodies(motions, scene) {
    const key = motions.map((_, i) => JSON.stringify(scene.explicit.panel?.[i]?.body ?? scene.explicit.body)).join();
    if (key === this.bodiesKey) return;
    this.bodiesKey = key;
    this.bodies = motions.map((_, i) => this.core.body(kPlayed, i));
    this.view.setBodies(this.bodies);
  }

  /** Lets the next picture make the bodies' meshes again, as of a file that has changed. */
  forgetBodies() { this.bodiesKey = null; }

  #book(i, frame, area, state) {
    // A scene's angle is from bottom to top; an upright picture is narrower than that.
    const isAlone = state.read.motions.length === 1, narrow = isAlone ? Math.max(area.height / area.width, 1) : 1;
    const {width, height} = this.picture, ground = isAlone ? {x: 0, y: 0, width, height} : area;
    const orbit = {...state.orbit, distance: state.orbit.distance * narrow};
    const sample = state.hand.seen(i, this.core.sample(kPlayed, i, frame));
    return {area, ground, sample, cage: new Float32Array(sample.subarray(kSample.corners)),
      ...this.#settled(i, frame / state.clock.rate, sample, this.core.camera(kPlayed, i, frame, area.width, area.height, orbit)),
      isUnseen: !state.scene.hasBody, ...this.#background(state.scene.explicit.look?.background ?? "studio")};
  }

  /** Returns the camera, turned about the book's middle so that a throw doesn't move the picture at once, but over a while. */
  #settled(i, time, sample, camera) {
    const share = this.settling?.book === i ? Math.max(1 - time / kSettling, 0) : 0;
    if (share === 0) return camera;
    const [w, ...axis] = this.settling.turn, angle = 2 * Math.atan2(Math.hypot(...axis), Math.abs(w)) * share * share * (3 - 2 * share);
    const turn = quaternionOf(sized(axis, w < 0 ? -angle : angle)), middle = middleOf(sample), {matrix, eye} = camera;
    const image = (vector, last) => [0, 1, 2, 3].map((row) => dot(vector, [matrix[row], matrix[4 + row], matrix[8 + row]]) + last * matrix[12 + row]);
    const columns = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axisOf) => image(turned(turn, axisOf), 0));
    const place = image(plus(middle, turned(turn, middle), -1), 1);
    return {...camera, matrix: new Float32Array([...columns, place].flat()), eye: plus(middle, turned(undone(turn), plus([...eye], middle, -1)))};
  }

  #background(name) {
    if (name === "studio" || name === "stars") return {backdrop: name};
    return {plain: kPlainColours[name] ?? colourOf(name)};
  }

  #drawLines(frame, state, isPlain) {
    const context = this.lines.getContext("2d", kOnProcessor), ratio = this.lines.width / this.picture.width;
    context.clearRect(0, 0, this.lines.width, this.lines.height);
    const sharpness = this.lines.width / this.box.width;
    const shown = Object.fromEntries(Object.keys(kShownOverlays).map((name) => [name, state.scene.shows(name)]));
    shown.axes ||= frame < kNamedFor * state.clock.rate && this.books.length <= kMostBooks;
    const overlays = this.books.map((book, i) => {
      const area = Object.fromEntries(Object.entries(book.area).map(([key, value]) => [key, value * ratio]));
      context.save();
      context.beginPath();
      context.rect(area.x, area.y - this.above * ratio, area.width, area.height + this.above * ratio);
      context.clip();
      const motion = state.read.motions[i], overlay = new Overlay(context, {...book, area}, this.unit, this.view.isLight);
      if (isPlain && !book.isUnseen) drawPlainBook(overlay, book.sample, {pictures: this.pictures, cloth: clothOf(state.scene), isBook: !this.bodies[i]});
      if (frame < state.simulation.ghostFrames && motion.model !== "exact") overlay.outline(this.core.sample(kGhost, i, frame));
      if (shown.springs && motion.springs) overlay.springs(book.sample, motion.springs);
      const isHeld = state.hand.held?.book === i;
      if (!isHeld) this.#drawWhy(overlay, i, frame, state, shown);
      overlay.vectors(book.sample, motion, state.scales[i], isHeld ? {axes: shown.axes} : shown);
      if (state.flick) overlay.hand(...state.flick.map((place) => place.map((part) => part * sharpness)));
      context.restore();
      return overlay;
    });
    this.#showLines(overlays, isPlain);
  }

  /** Shows the part of the lines' canvas in which there are any: all of it would take its time, as it is put over the picture. */
  #showLines(overlays, isWhole) {
    const sizes = [this.lines.width, this.lines.height], margin = kBesideLines * this.unit;
    const within = (place, i) => Math.min(Math.max(Math.floor(place), 0), sizes[i]);
    const from = sizes.map((_, i) => (isWhole ? 0 : within(Math.min(...overlays.map(({least}) => least[i])) - margin, i)));
    const to = sizes.map((size, i) => (isWhole ? size : within(Math.max(...overlays.map(({most}) => most[i])) + margin, i)));
    const [width, height] = to.map((end, i) => Math.max(Math.ceil((end - from[i]) / kLinesStep), 1) * kLinesStep);
    this.#resize(this.shown, width, height);
    const context = this.shown.getContext("2d", kOnProcessor);
    context.clearRect(0, 0, width, height);
    context.drawImage(this.lines, -from[0], -from[1]);
    const share = (value, i) => `${100 * value / sizes[i]}%`;
    Object.assign(this.shown.style, {left: share(from[0], 0), top: share(from[1], 1), width: share(width, 0), height: share(height, 1)});
  }

  /** What says why the book turns over. */
  #drawWhy(overlay, i, frame, state, shown) {
    const motion = state.read.motions[i];
    if (shown.poinsot) {
      const poinsot = this.core.poinsot(kPlayed, i, frame, Math.round(kRollingTrail * state.read.rate[0] / state.read.rate[1]));
      if (poinsot) new Rolling(overlay, poinsot, motion.moments, this.books[i]).draw();
    }
    if (shown.forces) drawForces(overlay, this.core.forces(kPlayed, i, frame), motion, state.scene.frameOf(i));
  }

  /** Returns the pixels of a metre across the view at a book's middle. [CSS pixels, or the picture's] */
  pixelsOfMetre(index) {
    const book = this.books[index], middle = middleOf(book.sample), [right] = Stage.axesOf(book.matrix);
    const [a, b] = [0, 0.01].map((way) => projected(book.matrix, book.area, plus(middle, right, way)));
    return a && b ? 100 * Math.hypot(a[0] - b[0], a[1] - b[1]) * this.box.width / this.picture.width : 0;
  }

  /** Returns where a book's middle is. [CSS pixels] */
  middleOfBook(index) {
    const book = this.books[index], factor = this.box.width / this.picture.width;
    return (projected(book.matrix, book.area, middleOf(book.sample)) ?? [0, 0]).map((part) => part * factor);
  }

  #placeLabels(motions, areas) {
    const key = motions.map((motion, i) => [motion.label, ...Object.values(areas[i])].join()).join(";") + this.picture.width;
    if (key === this.placed) return;
    this.placed = key;
    const share = (part, whole) => `${100 * part / whole}%`;
    this.labels.replaceChildren(...(motions.length < 2 || motions.length > kMostBooks ? [] : motions.map((motion, i) => {
      const label = make("span", {}, motion.label);
      label.style.left = share(areas[i].x, this.picture.width);
      label.style.top = `calc(${share(areas[i].y, this.picture.height)} - ${kNameHeight / 16}rem)`;
      label.style.maxWidth = share(areas[i].width, this.picture.width);
      label.style.setProperty("--rb-book", inkOfLook(kBookColours[i]));
      return label;
    })));
  }

  /** The ball and the ladder are in the panel of the book that they are of. */
  #placeInsets({x, y, width, height}) {
    const {picture} = this, place = [picture.width - x - width, picture.height - y - height].map((part, i) => 100 * part / [picture.width, picture.height][i]);
    const key = place.join();
    if (key === this.insetsPlaced) return;
    this.insetsPlaced = key;
    ["right", "bottom"].forEach((side, i) => { this.scene.style.setProperty("--rb-" + side, `${place[i]}%`); });
  }

  /** Returns the index of the book in whose area a point is [CSS pixels], and the point in the drawing's pixels. */
  bookAt([x, y]) {
    const factor = this.picture.width / this.picture.clientWidth, point = [x * factor, y * factor];
    const index = this.books.findIndex(({area}) =>
      point[0] >= area.x && point[0] < area.x + area.width && point[1] >= area.y && point[1] < area.y + area.height);
    return {index, point, factor};
  }

  isOnBook(place) {
    const {index, point} = this.bookAt(place), book = this.books[index];
    return Boolean(book) && isOnBook(book, book.sample, point);
  }

  /** Returns about how large half a book is as it is seen. [CSS pixels] */
  bookRadius(place) {
    const {index, factor} = this.bookAt(place), book = this.books[Math.max(index, 0)];
    const middle = middleOf(book.sample), reach = Math.hypot(...cornerOf(book.sample, 0).map((part, axis) => part - middle[axis]));
    const up = Stage.axesOf(book.matrix)[1];
    const at = (sign) => projected(book.matrix, book.area, middle.map((part, axis) => part + sign * reach * up[axis]));
    const [a, b] = [at(1), at(-1)];
    return a && b ? Math.max(Math.hypot(a[0] - b[0], a[1] - b[1]) / 2 / factor, 20) : 100;
  }

  /** Returns the picture's right and up in the world's axes. */
  static axesOf(matrix) {
    return [0, 1].map((row) => {
      const axis = [matrix[row], matrix[4 + row], matrix[8 + row]], size = Math.hypot(...axis);
      return axis.map((part) => part / size);
    });
  }
}

/** Returns the colour of a scene's covers of plain cloth; null if it doesn't ask for them. */
function clothOf(scene) {
  const colour = scene.explicit.book?.color;
  return colour ? {white: [1, 1, 1], black: [0, 0, 0]}[colour] ?? colourOf(colour) : null;
}

/** Returns the parts, 0 to 1, of a colour such as "#2b5d8a". */
function colourOf(text) {
  const hex = /^#([0-9a-f]{6})$/i.exec(text)?.[1];
  return hex ? [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255) : [0, 0, 0];
}
