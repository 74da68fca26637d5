// The state of the player: one scene, as the tree of its TOML.

const kStartTilt = 0.014;  // [rad]
const kStartSpeed = 4;     // [rad/s]
const kAxes = ["x", "y", "z"];
const kChanged = say(", changed");
const kEvent = /flip|nudge|burst|end/;
const kTiltToward = {x: "z", y: "x", z: "x"};
/** Sections that a panel may have of its own. */
const kPanelSections = ["body", "simulation", "initial", "expect"];

const clone = (tree) => JSON.parse(JSON.stringify(tree));

class LiveScene {
  /** `tree`: of the scene, whose `text` it is; `explicit`: of the same with every default, as the core writes it; `words`: the core's. */
  constructor(tree, explicit, text, words) {
    Object.assign(this, {tree, explicit, text, words});
    this.speeds = [];  // Of each book at the start. [rad/s]
  }

  get bookCount() { return this.tree.panel?.length ?? 1; }
  /** Of a grid of books; 0 of others. */
  get gridColumns() { return this.tree.grid ? this.tree.grid.columns?.values.length ?? 1 : 0; }
  /** Returns the same with a changed tree, to change it further. */
  as(tree) { return new LiveScene(tree, this.explicit, "", this.words); }

  /** Returns a key's value for a book, defaults included; undefined if it has none. */
  value(book, section, key) {
    return this.explicit.panel?.[book]?.[section]?.[key] ?? this.explicit[section]?.[key];
  }

  /** Simulated time from a picture to the next: the stated one, or that of real time or a constant speed. [s] */
  get timePerFrame() {
    const {fps, speed} = this.explicit.clip;
    const [frames, seconds] = String(fps).split("/").map(Number);
    return this.explicit.simulation?.time_per_frame ?? Number(((Number(speed) || 1) * (seconds || 1) / frames).toPrecision(12));
  }

  shows(overlay) { return this.explicit.overlay?.show?.includes(overlay) ?? false; }
  get hasBody() { return this.explicit.look?.body ?? true; }
  /** Whether a clip's text is on a dark ground. */
  get hasBand() { return this.explicit.overlay?.band ?? true; }

  /** Returns a changed copy of the tree: the scene itself changes only once the core has read the copy. */
  changed(action) {
    const tree = clone(this.tree);
    action(tree);
    return tree;
  }

  /** As above, of what the motion depends on: expectations, captions and events were of another motion. */
  withMotion(action) {
    return this.changed((tree) => {
      delete tree.expect;
      delete tree.caption;
      delete tree.cue;
      if (Array.isArray(tree.clip?.speed) && tree.clip.speed.some(({from, to}) => kEvent.test(from) || kEvent.test(to))) delete tree.clip.speed;
      delete tree.study;
      delete tree.map;
      if (tree.grid) delete tree.grid.expect;
      for (const panel of tree.panel ?? []) delete panel.expect;
      if (tree.title && !tree.title.endsWith(kChanged)) {
        tree.title = [...tree.title].slice(0, this.words.keys.title.max - kChanged.length).join("") + kChanged;
      }
      action(tree);
    });
  }

  /** Sets keys of one book, or of all if there are no panels. An undefined value removes the key. */
  withKeys(book, section, values) {
    return this.withMotion((tree) => {
      const owner = section !== "clip" && tree.panel ? tree.panel[book] : tree;
      const table = owner[section] = {...owner[section]};
      for (const [key, value] of Object.entries(values)) {
        if (value === undefined) delete table[key];
        else table[key] = value;
      }
    });
  }

  /** Returns what a book is to have with `model`: no dissipation, if the model takes none. */
  #withoutLoss(model, book) {
    const takesIt = this.words.keys["simulation.dissipation"].models.includes(model);
    return takesIt || !this.value(book, "simulation", "dissipation") ? {} : {dissipation: 0};
  }

  withModel(book, model) {
    const tree = this.withKeys(book, "simulation", {model, ...this.#withoutLoss(model, book), integrator: this.words.models.find(({name}) => name === model).integrator ?? undefined});
    const panel = tree.panel?.[book];
    if (panel?.label === say("exact") && model !== "exact") panel.label = say("second");
    return tree;
  }

  /** Returns the keys of a book's start. */
  startOf(book) {
    return clone(LiveScene.#startFrom(this.explicit.initial, this.explicit.panel?.[book]?.initial));
  }

  /** A panel's own start, with the scene's spin and other keys unless it states a spin. */
  static #startFrom(initial, own) {
    return own?.angular_velocity || own?.angular_momentum ? own : {...initial, ...own};
  }

  /** A start has one of several keys for the spin: only those in `initial` stay. */
  withStart(book, initial) {
    return this.withMotion((tree) => {
      const start = Object.fromEntries(Object.entries(initial).filter(([, value]) => value !== undefined));
      if (!tree.panel) {
        tree.initial = start;
        return;
      }
      // A panel would inherit the keys that it lacks; a recording states none.
      tree.panel.forEach((panel, i) => {
        if (i === book) panel.initial = start;
        else if (this.value(i, "simulation", "model") !== "recorded") panel.initial = this.startOf(i);
      });
      delete tree.initial;
    });
  }

  withStartAbout(book, axis) {
    const tilt = this.value(book, "initial", "tilt")?.[0] || kStartTilt;
    const speed = Math.max(this.speedAtStart(book), kStartSpeed);  // Not as limp as the hand's last throw may have been.
    const velocity = kAxes.map((name) => (name === axis ? speed : 0));
    return this.withoutNudges(this.withStart(book, {angular_velocity: velocity, tilt: [tilt, kTiltToward[axis]]}), book);
  }

  /** Whether a body is a book, whose axes have its three moments. */
  isOfBook(book) { return ["shape", "mesh", "part", "inertia"].every((key) => this.value(book, "body", key) === undefined); }

  /** Starts about the axis of a moment, "smallest", "middle" or "largest", with a tilt toward one of the body's axes. */
  withStartAboutMoment(book, about, toward) {
    const tilt = this.value(book, "initial", "tilt")?.[0] || kStartTilt;
    return this.withoutNudges(this.withStart(book, {angular_velocity: {about, value: this.speedAtStart(book)}, tilt: [tilt, toward]}), book);
  }

  /** Starts as a book lies, the world from its axes, with an angular velocity in these. [rad/s] */
  withThrow(book, attitude, velocity) {
    const rounded = (parts, digits) => parts.map((part) => Number(part.toFixed(digits)) || 0);
    return this.withoutNudges(this.withStart(book, {angular_velocity: rounded(velocity, 4), attitude: rounded(attitude, 6)}), book);
  }

  /** Starts with an angular velocity in the book's axes. [rad/s] */
  withVelocity(book, velocity) {
    return this.withoutNudges(this.withStart(book, {angular_velocity: velocity.map((part) => Number(part.toPrecision(6)))}), book);
  }

  withSpeed(book, speed) {
    const start = this.startOf(book), key = start.angular_velocity ? "angular_velocity" : "angular_momentum";
    const factor = speed / this.speedAtStart(book);
    const times = (part) => Number((part * factor).toPrecision(12));
    const spin = Array.isArray(start[key]) ? start[key].map(times) : {...start[key], value: times(start[key].value)};
    return this.withStart(book, {...start, [key]: spin});
  }

  /** Tilts the start by an angle [rad], toward the axis that it has or one that suits it. */
  withTilt(book, angle) {
    const toward = this.value(book, "initial", "tilt")?.[1] ?? kTiltToward[this.startAxis(book) ?? "x"];
    return this.withStart(book, {...this.startOf(book), tilt: angle > 0 ? [angle, toward] : undefined});
  }

  /** Sets the size along one axis. [m] */
  withSize(book, axis, length) {
    return this.withKeys(book, "body", {size: this.value(book, "body", "size").map((size, i) => (i === axis ? length : size))});
  }

  withoutNudges(tree, book) {
    delete tree.nudge;
    delete tree.panel?.[book]?.nudge;
    return tree;
  }

  /** The axis that the book is spun about at the start, null if it is none of the three alone. */
  startAxis(book) {
    const spin = this.value(book, "initial", "angular_velocity") ?? this.value(book, "initial", "angular_momentum");
    const turning = kAxes.filter((axis, i) => spin?.[i] !== 0);
    return turning.length === 1 ? turning[0] : null;
  }

  speedAtStart(book) {
    return Number((this.speeds[book] || kStartSpeed).toPrecision(6));
  }

  /** Adds a throw at a time [s] along `axes`, "world" or "body" [rad/s], in place of all later ones; the clip lasts until `end` [s] at least. */
  withNudge(at, angularVelocity, axes, end) {
    const {maxNudges} = this.words, sharing = this.tree.panel?.findIndex((panel) => !panel.nudge);
    const all = (this.tree.panel ? this.explicit.panel[sharing] : this.explicit)?.nudge ?? [];
    const earlier = all.filter((nudge) => nudge.at < at);
    if (earlier.length >= maxNudges) throw new Error(say("There are {count} throws already; reset the book to throw it anew.", {count: maxNudges}));
    return this.withMotion((tree) => {
      tree.nudge = [...earlier, {at, angular_velocity: angularVelocity, axes}];
      if (end > this.explicit.clip.duration) tree.clip = {...tree.clip, duration: Number(end.toPrecision(6))};
    });
  }

  get nudgeTimes() { return (this.explicit.nudge ?? []).map((nudge) => nudge.at); }

  /** Adds a second book beside the first, which differs in `sections`. */
  withSecondBook(label, sections = {}) {
    return this.withMotion((tree) => {
      delete tree.grid;
      tree.panel = [{label: say("first")}, {label, ...clone(sections)}];
      LiveScene.#setShown(tree, this.explicit, "ghost", false);
    });
  }

  withExactBook() {
    return this.withSecondBook(say("exact"), {simulation: {model: "exact", ...this.#withoutLoss("exact", 0)}});
  }

  /** Leaves one book: its own keys become the scene's. */
  withOnly(book) {
    return this.withMotion((tree) => {
      const panel = tree.panel[book];
      delete tree.panel;
      for (const section of kPanelSections) {
        if (!panel[section]) continue;
        tree[section] = section === "initial" ? LiveScene.#startFrom(tree.initial, panel.initial) : {...tree[section], ...panel[section]};
      }
      if (panel.frame) tree.camera = {...tree.camera, frame: panel.frame};
      if (tree.simulation?.model === "exact") delete tree.simulation.integrator;
    });
  }

  withShown(overlay, isShown) {
    return this.changed((tree) => LiveScene.#setShown(tree, this.explicit, overlay, isShown));
  }

  /** Shows overlays in place of the `hidden` ones. */
  withOverlays(shown, hidden) {
    return this.changed((tree) => {
      const others = (this.explicit.overlay?.show ?? []).filter((name) => !shown.includes(name) && !hidden.includes(name));
      tree.overlay = {...tree.overlay, show: [...others, ...shown]};
    });
  }

  static #setShown(tree, explicit, overlay, isShown) {
    const others = (explicit.overlay?.show ?? []).filter((name) => name !== overlay);
    tree.overlay = {...tree.overlay, show: isShown ? [...others, overlay] : others};
  }

  /** The reference frame in which the camera sees a book: "world", "body", "turning" or "momentum". */
  frameOf(book) { return this.explicit.panel?.[book]?.frame ?? this.explicit.camera?.frame ?? "world"; }

  /** All books are seen in one frame; the camera is at its usual place there. */
  withFrame(frame) {
    return this.changed((tree) => {
      tree.camera = {...tree.camera, frame};
      for (const panel of tree.panel ?? []) delete panel.frame;
    });
  }

  /** The tree of the exact motion from the same start, for the ghost. Null if there is nothing to compare. */
  ghostTree() {
    if (!this.shows("ghost") || this.tree.grid) return null;
    return this.changed((tree) => {
      delete tree.overlay;  // Some are for particles alone.
      tree.simulation = {...tree.simulation, model: "exact", dissipation: 0};
      delete tree.simulation.integrator;
      for (const panel of tree.panel ?? []) {
        panel.simulation = {...panel.simulation, model: "exact", dissipation: 0};
        delete panel.simulation.integrator;
      }
    });
  }
}
