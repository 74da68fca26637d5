// The live book: joins scene, core, clock, picture, controls and what is said.

const kOpening = `title = "A book thrown about its middle axis"

[simulation]
model = "particles"
integrator = "euler"
stiffness = 125
substeps = 60

[initial]
angular_velocity = [4, 0, 0]
tilt = [0.014, "z"]

[clip]
duration = 60

[overlay]
show = ["omega", "momentum", "polhode"]
`;
const kBudget = 7;         // Of simulating ahead, in a picture's time. [ms]
const kJiggle = 0.15;      // Share of the spin.
const kTrailFrames = 240;

class Player {
  constructor(root, core, pictures, shaders) {
    this.root = root;
    this.core = core;
    this.find = (selector) => root.querySelector(selector);
    this.announcer = new Announcer(this.find(".rb-events"), this.find(".rb-message"));
    this.clock = new Clock();
    this.orbit = {right: 0, up: 0, distance: 1};
    this.book = 0;
    this.steps = 500;
    this.simulated = 0;
    this.ghostFrames = 0;
    this.drawing = new Stage(root, core, pictures, shaders);
    this.stage = this.drawing.lines;
    this.timeline = new Timeline(this.find(".rb-timeline canvas"), this.find(".rb-seek"));
    this.ball = new PolhodeBall(this.find(".rb-ball"));
    this.predict = new Predict(this.find(".rb-question"), this);
  }

  /** As a second step, as knobs need a scene to show. */
  begin(text, isPlaying) {
    this.load(text, {isPlaying});
    this.controls = new Controls(this.root, this);
    this.controls.refresh();
    this.pointer = new Pointer(this.stage, this);
    new Commands(this.root, this);
    const tick = (now) => {
      requestAnimationFrame(tick);  // First, so that no error ends the pictures.
      this.tick(now);
    };
    tick(performance.now());
  }

  get labels() { return this.read.motions.map((motion) => motion.label); }
  get lastFrame() { return this.simulated - 1; }
  get frame() { return Math.min(this.clock.frame, this.lastFrame); }
  get isComplete() { return this.simulated >= this.core.frames(kFirst); }
  timeOf(frame) { return this.core.numbers(kFirst, 0, frame, [kSample.time])[0]; }

  /** Plays a scene's text from its beginning; the last good scene stays if it is none. Returns whether it is played. */
  load(text, {isPlaying = true, record = null} = {}) {
    try {
      const tree = this.core.treeOf(text);
      this.record = record;
      if (!this.apply(tree, {text, frame: 0, keepRecord: true})) return false;
      this.original = tree;
      Object.assign(this.orbit, {right: 0, up: 0, distance: 1});
      this.book = 0;
      this.#setPlaying(isPlaying);
      this.controls?.refresh();
      return true;
    } catch (error) {
      this.#refuse(error);
      return false;
    }
  }

  #refuse(error) {
    if (!(error instanceof SceneError)) throw error;
    this.announcer.show(error.message, "bad");
    this.controls?.refresh();
  }

  /** Changes the scene to a tree's, of which `text` is the TOML, at a frame. Returns whether the core takes it. */
  apply(tree, {text = tomlText(tree), frame = this.frame, isPlaying = this.clock.isPlaying, keepRecord = false} = {}) {
    let read;
    try {
      read = this.core.read(kFirst, text);
    } catch (error) {
      this.#refuse(error);
      return false;
    }
    this.announcer.show("");
    if (!keepRecord) this.record = null;
    this.#take(tree, read, frame);
    this.#setPlaying(isPlaying);
    this.controls?.refresh();
    return true;
  }

  #take(tree, read, frame) {
    this.read = read;
    this.scene = new LiveScene(tree, this.core.treeOf(this.core.sceneText(kFirst)));
    this.book = Math.min(this.book, read.motions.length - 1);
    this.clock.rate = read.rate[0] / read.rate[1];
    this.simulated = this.#advance(kFirst, 0);
    this.timeline.clear(read.motions.length, 0);
    this.motionFailed = false;
    this.checksum = null;
    const start = (i, first) => Math.hypot(...this.core.sample(kFirst, i, 0).subarray(first, first + 3)) || 1;
    this.scene.speeds = read.motions.map((motion, i) => start(i, kSample.omega));
    this.scales = read.motions.map((motion, i) => ({omega: start(i, kSample.omega), momentum: start(i, kSample.momentum)}));
    this.restoreCloth();
    this.ghostTree = this.scene.ghostTree();
    this.ghostFrames = 0;
    this.needsGhost = this.ghostTree !== null;
    this.#reach(frame);
    this.clock.go(Math.min(frame, this.lastFrame));
    this.told = this.frame;
    this.redraw();
  }

  /** Covers of plain cloth, if the scene asks for them. */
  restoreCloth() {
    const colour = this.scene.explicit.book?.color;
    this.drawing.view.setCloth(colour ? {white: [1, 1, 1], black: [0, 0, 0]}[colour] ?? colourOf(colour) : null);
  }

  #advance(slot, frame) {
    try {
      return this.core.advance(slot, frame, this.steps);
    } catch (error) {
      if (!(error instanceof SceneError)) throw error;
      this.motionFailed = true;
      this.announcer.show(error.message, "bad");
      return Math.max(this.simulated, 1);
    }
  }

  /** Simulates a piece of the motion, and keeps pieces to a few milliseconds. */
  #ahead(frame = this.core.frames(kFirst) - 1) {
    const start = performance.now();
    this.simulated = this.#advance(kFirst, frame);
    const took = performance.now() - start;
    if (took > 3) this.steps = Math.max(Math.floor(this.steps / 2), 1);
    else if (took < 1) this.steps = Math.min(2 * this.steps, 1e6);
  }

  /** Simulates as far as the picture that is to be shown, if that is soon done. */
  #reach(frame) {
    const until = performance.now() + 60;
    while (this.simulated <= frame && !this.isComplete && !this.motionFailed && performance.now() < until) this.#ahead(frame);
  }

  #simulate() {
    const until = performance.now() + kBudget;
    while (!this.isComplete && !this.motionFailed && performance.now() < until) this.#ahead();
    this.timeline.extend(this.core, this.simulated);
    if (this.isComplete && !this.motionFailed && this.checksum === null) this.#showChecksum();
    if (!this.ghostTree || this.isProving) return;
    if (this.needsGhost) this.core.read(kSecond, tomlText(this.ghostTree));
    this.needsGhost = false;
    if (this.ghostFrames === this.core.frames(kSecond)) return;
    if (this.ghostFrames <= this.frame) this.redraw();
    this.ghostFrames = this.core.advance(kSecond, this.core.frames(kSecond) - 1, 20000);
  }

  #showChecksum() {
    this.checksum = this.core.checksum(kFirst);
    const isSame = this.record?.motion === this.checksum;
    const words = this.record ? (isSame ? " – the clip’s own, bit for bit" : ` – not the clip’s, ${this.record.motion}`) : "";
    const line = this.find(".rb-checksum");
    line.textContent = `Checksum of this motion: ${this.checksum}${words}`;
    line.dataset.same = String(isSame);
  }

  tick(now) {
    const before = this.clock.position;
    this.#simulate();
    this.clock.tick(now, this.lastFrame);
    const frame = this.frame;
    if (this.clock.isPlaying && this.drawnAt) this.drawing.adapt(now - this.drawnAt);
    this.drawnAt = this.clock.isPlaying ? now : null;
    if (this.clock.position !== before || this.isDirty) this.#draw(frame);
    this.timeline.draw(this.core.frames(kFirst), this.simulated, this.scene.nudgeTimes.map((time) => time / this.timeOf(this.lastFrame) * this.lastFrame / Math.max(this.core.frames(kFirst) - 1, 1)));
    if (this.checksum === null) this.find(".rb-checksum").textContent = `Simulating … ${Math.floor(100 * this.simulated / this.core.frames(kFirst))} %`;
    if (this.clock.isPlaying && this.isComplete && frame >= this.lastFrame) this.#setPlaying(false);
  }

  #draw(frame) {
    this.isDirty = false;
    this.drawing.draw(frame, this);
    const time = this.timeOf(frame);
    showNumbers(this.find(".rb-numbers"), this, frame);
    this.#showTime(time, frame);
    this.#drawBall(frame);
    const words = wordsOfEvents(this.timeline.events, this.told, frame, this.labels, (at) => this.timeOf(at));
    if (words.length > 0) this.announcer.tell(words.join(". "));
    this.told = frame;
    this.predict.tick(time);
  }

  #showTime(time, frame) {
    const seek = this.timeline.slider;
    seek.max = Math.max(this.core.frames(kFirst) - 1, 1);
    seek.value = frame;
    seek.setAttribute("aria-valuetext", seconds(time));
    this.find(".rb-time").textContent = seconds(time);
  }

  #drawBall(frame) {
    const moments = this.read.motions[this.book].moments, isShown = this.scene.shows("polhode");
    this.find(".rb-ball-frame").hidden = !isShown;
    if (!isShown) return;
    const trail = [];
    const step = Math.max(Math.floor(kTrailFrames / 120), 1);
    for (let at = Math.max(frame - kTrailFrames, 0); at < frame; at += step) trail.push(momentumInBook(this.core.sample(kFirst, this.book, at)));
    trail.push(momentumInBook(this.core.sample(kFirst, this.book, frame)));
    this.ball.draw(moments, trail);
  }

  redraw() { this.isDirty = true; }

  #setPlaying(isPlaying) {
    if (isPlaying) this.clock.play();
    else this.clock.pause();
    const button = this.find(".rb-play"), word = isPlaying ? "Pause" : "Play";
    button.dataset.state = isPlaying ? "playing" : "paused";
    button.querySelector(".rb-word").textContent = word;
    this.redraw();
  }

  start() { this.#setPlaying(true); }
  pause() { this.#setPlaying(false); }

  toggle() {
    if (!this.clock.isPlaying && this.isComplete && this.frame >= this.lastFrame) this.seek(0);
    this.#setPlaying(!this.clock.isPlaying);
  }

  seek(frame) {
    this.#reach(frame);
    this.clock.go(Math.max(Math.min(frame, this.lastFrame), 0));
    this.told = this.frame;
    this.redraw();
  }

  step(frames) {
    this.pause();
    this.seek(this.frame + frames);
  }

  /** Whatever is begun anew starts to move, unless it was paused. */
  startAbout(axis) { this.apply(this.scene.withStartAbout(this.book, axis), {frame: 0}); }
  reset() { this.load(tomlText(this.original), {isPlaying: this.clock.isPlaying, record: this.record}); }

  edit(book) {
    this.book = book;
    this.controls.refresh();
    this.redraw();
  }

  booksChoice(scene) {
    if (scene.bookCount < 2) return "one";
    return this.read.motions[scene.bookCount - 1].model === "exact" ? "exact" : "same";
  }

  setBooks(choice) {
    const one = this.scene.bookCount > 1 ? new LiveScene(this.scene.withOnly(0), this.scene.explicit) : this.scene;
    if (choice === "one") {
      this.apply(one.tree);
      return;
    }
    const isExact = choice === "exact";
    this.book = isExact ? 0 : 1;
    this.apply(one.withSecondBook(isExact ? "exact" : "second", isExact ? {simulation: {model: "exact"}} : {}));
  }

  isOnBook(place) { return this.drawing.isOnBook(place); }
  bookRadius(place) { return this.drawing.bookRadius(place); }

  showHand(from, to) {
    this.hand = from && [from, to];
    this.redraw();
  }

  tap(place) {
    if (this.predict.isAsking) this.predict.choosePanel(this.drawing.bookAt(place).index);
    else this.toggle();
  }

  /** Adds to the spin about the picture's right and up. [rad/s] */
  throwBook(right, up) {
    const [rightAxis, upAxis] = Stage.axesOf(this.drawing.books[0].matrix);
    this.#nudge(rightAxis.map((part, axis) => right * part + up * upAxis[axis]));
    this.announcer.tell(`Thrown at ${seconds(this.timeOf(this.frame))}`);
  }

  jiggle() {
    const spin = this.core.sample(kFirst, this.book, this.frame).subarray(kSample.omega, kSample.omega + 3);
    const size = Math.hypot(...spin), along = [...spin].map((part) => part / size);
    const any = [0, 1, 2].map(() => Math.random() - 0.5), share = any.reduce((sum, part, axis) => sum + part * along[axis], 0);
    const across = any.map((part, axis) => part - share * along[axis]), length = Math.hypot(...across) || 1;
    this.#nudge(across.map((part) => kJiggle * size * part / length));
    this.announcer.tell(`Jiggled at ${seconds(this.timeOf(this.frame))}`);
  }

  #nudge(velocity) {
    const at = Number((this.timeOf(this.frame) || this.read.interval / 2).toPrecision(9));
    const rounded = velocity.map((part) => Number(part.toPrecision(4)) || 0);
    if (rounded.every((part) => part === 0)) return;
    try {
      this.apply(this.scene.withNudge(at, rounded), {isPlaying: true});
    } catch (error) {
      this.announcer.show(error.message, "bad");
    }
  }

  /** The scene as it is seen: a turned view becomes the camera's place. */
  sharedText() {
    const {right, up, distance} = this.orbit, camera = this.scene.explicit.camera;
    const isMoved = right !== 0 || up !== 0 || distance !== 1;
    if (!isMoved || camera?.frame !== "world") return this.scene.text;
    const eye = [...this.core.camera(kFirst, 0, 0, 16, 9, this.orbit).eye];
    return tomlText(this.scene.changed((tree) => {
      tree.camera = {...tree.camera, position: eye.map((part) => Number(part.toPrecision(5)))};
    }));
  }

  /** Proves a clip and plays its scene, or plays a dropped scene. */
  async open(file) {
    this.announcer.show(`Reading ${file.name} …`);
    this.isProving = true;
    try {
      if (/\.toml$/i.test(file.name)) {
        if (file.size > kLargestScene) throw new SceneError(`${file.name} is longer than a scene may be.`);
        this.load(await file.text());
        return;
      }
      const {isProved, record, words} = await proveClip(this.core, file, (share) => this.announcer.show(`Simulating ${file.name} again … ${Math.floor(100 * share)} %`));
      this.load(record.text, {record, isPlaying: !matchMedia("(prefers-reduced-motion: reduce)").matches});
      this.announcer.show(words, isProved ? "good" : "bad");
    } catch (error) {
      if (!(error instanceof RecordError || error instanceof SceneError)) throw error;
      this.announcer.show(error instanceof SceneError ? `${file.name}: ${error.message}` : error.message, "bad");
    } finally {
      this.isProving = false;
      this.needsGhost = this.ghostTree !== null;
      this.ghostFrames = 0;
    }
  }
}
