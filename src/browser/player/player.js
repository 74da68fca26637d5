// The live book: joins scene, core, clock, picture, controls and what is said.

const kOpening = `title = "${say("A book thrown about its middle axis")}"

[simulation]
model = "exact"

[initial]
angular_velocity = [4, 0, 0]
tilt = [0.014, "z"]

[clip]
duration = 60

[overlay]
show = ["omega", "momentum", "polhode"]
`;
const kBudget = 7;           // Of simulating ahead, in a picture's time. [ms]
const kCatchingUp = 40;      // The same where the picture waits for it. [ms]
const kWhy = ["forces", "energy_ladder"];  // Overlays.

/** Returns the sizes of each motion's vectors at the start. */
function scalesAtStart(core, slot, motions) {
  const start = (i, first) => Math.hypot(...core.sample(slot, i, 0).subarray(first, first + 3)) || 1;
  return motions.map((motion, i) => ({omega: start(i, kSample.omega), momentum: start(i, kSample.momentum)}));
}

class Player {
  /** `materials`: {pictures, shaders} to draw with, and the packed muxer. */
  constructor(root, core, materials) {
    this.root = root;
    this.materials = materials;
    this.core = core;
    this.find = (selector) => root.querySelector(selector);
    this.announcer = new Announcer(this.find(".rb-events"), this.find(".rb-message"));
    this.clock = new Clock();
    this.orbit = {right: 0, up: 0, distance: 1};
    this.book = 0;
    this.edits = 0;
    this.motionEdits = 0;
    this.wanted = null;
    this.simulation = new Simulation(core, (message) => this.announcer.show(refusalOf(message), "bad"));
    this.drawing = new Stage(root, core, materials.pictures, materials.shaders);
    this.stage = this.drawing.picture;
    this.timeline = new Timeline(this.find(".rb-timeline canvas"), this.find(".rb-seek"));
    this.ball = new PolhodeBall(this.find(".rb-ball"));
    const box = new Box(this.find(".rb-question"), this);
    this.predict = new Predict(box, this);
    this.tour = new Tour(box, this.find(".rb-step"), this);
    this.throws = new Throws(this);
    this.saver = new ClipSaver(root, this);
    this.bigScreen = new BigScreen(root, this);
    this.files = new Files(this);
    this.toss = new Toss(this);
    this.loaded = new Loaded(this.find(".rb-title"), this);
    this.hand = new Hand(this);
    this.ladder = new Ladder(this.find(".rb-ladder"));
    this.outcome = new Outcome(this.find(".rb-said"), this.find(".rb-hint"), this.announcer);
    this.speed = 1;
    this.slowsAtFlips = false;
    this.isSeen = true;  // Else time stands still, and only changes are drawn.
    this.onEdit = () => {};
  }

  /** As a second step, as knobs need a scene to show. */
  begin(text, isPlaying) {
    this.outcome.warn(this.drawing.view.lack);
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
  /** Whether time goes on, or will once the hand lets go. */
  get isPlaying() { return this.hand.held?.wasPlaying ?? this.clock.isPlaying; }
  get simulated() { return this.simulation.simulated; }
  get lastFrame() { return this.simulation.lastFrame; }
  get isComplete() { return this.simulation.isComplete; }
  /** Whether the picture waits for a frame that isn't simulated yet. */
  get isWaiting() { return this.wanted !== null; }
  get frame() { return this.wanted ?? Math.min(this.clock.frame, this.lastFrame); }
  timeOf(frame) { return this.core.numbers(kPlayed, 0, Math.min(frame, this.lastFrame), [kSample.time])[0]; }

  /**
   * Plays a scene's text from its beginning, or a frame; the last good scene stays if it is none. Returns whether it is played. `origin`: as of
   * Loaded.take(); `file`: the name of the file that it is in; `refused`: takes the words of a refusal, which
   * are else a message.
   */
  load(text, {frame = 0, isPlaying = true, record = null, isQuestion = false, isStep = false, origin = null, file = "", refused} = {}) {
    try {
      const tree = this.core.treeOf(text);
      if (!this.#play(tree, text, {frame, isPlaying, record, isQuestion, file, refused})) return false;
      if (!isStep) this.tour.forget();
      Object.assign(this.orbit, {right: 0, up: 0, distance: 1});
      if (!isQuestion && !isStep) this.loaded.take(text, record, origin);
      this.loaded.show();
      return true;
    } catch (error) {
      this.#refuse(error, file, refused);
      return false;
    }
  }

  /** Changes the scene to an edited tree, at the picture's frame or another. Returns whether the core takes it. */
  apply(tree, {frame = this.frame, isPlaying = this.isPlaying, isMotion = true} = {}) {
    if (!this.#play(tree, this.core.textOf(tree), {frame, isPlaying, isMotion})) return false;
    this.loaded.show();
    this.edits += 1;
    if (isMotion) this.motionEdits += 1;
    this.onEdit();
    return true;
  }

  /** As above, of what is seen of the same motion. */
  see(tree) { return this.apply(tree, {isMotion: false}); }

  #refuse(error, file, refused = (words) => this.announcer.show(words, "bad")) {
    if (!(error instanceof SceneError)) throw error;
    refused(refusalOf(error.message, file));
    this.controls?.refresh();
  }

  /** `record`: of the clip whose motion this is said to be. */
  #play(tree, text, {frame, isPlaying, isMotion = true, record = null, isQuestion = false, file = "", refused}) {
    let read;
    try {
      read = this.core.read(kPlayed, text);
    } catch (error) {
      this.#refuse(error, file, refused);
      return false;
    }
    if (!isQuestion) this.predict.leave();
    this.announcer.show("");
    this.hand.putBack();
    if (isMotion) this.outcome.forget();
    this.record = record;
    this.#take(new LiveScene(tree, this.core.treeOf(this.core.sceneText(kPlayed)), text, this.core.words), read, frame);
    this.#setPlaying(isPlaying);
    this.controls?.refresh();
    return true;
  }

  #take(scene, read, frame) {
    this.read = read;
    this.scene = scene;
    this.drawing.settling = null;
    this.book = Math.min(this.book, read.motions.length - 1);
    this.clock.rate = read.rate[0] / read.rate[1];
    this.timeline.clear(read.motions.length);
    this.checksum = null;
    // A recording states no start, from which the exact motion would go on.
    const ghost = read.motions.some(({model}) => model === "recorded") ? null : this.scene.ghostTree();
    this.simulation.begin(ghost && this.core.textOf(ghost));
    this.scales = scalesAtStart(this.core, kPlayed, read.motions);
    this.scene.speeds = this.scales.map(({omega}) => omega);
    this.restoreCloth();
    this.#goTo(frame);
  }

  restoreCloth() { this.drawing.view.setCloth(clothOf(this.scene)); }

  /** Shows a frame at once if it is soon simulated; else the picture stays as it is until then. */
  #goTo(frame) {
    this.wanted = Math.max(frame, 0);
    this.simulation.work(60, this.wanted);
    this.#arrive();
  }

  /** Shows the frame that the picture waits for, if it is there or will never be. */
  #arrive() {
    if (this.simulation.lastFrame < this.wanted && !this.simulation.isDone) return;
    this.clock.go(Math.min(this.wanted, this.lastFrame));
    this.wanted = null;
    this.announcedFrame = this.frame;
    this.redraw();
  }

  #simulate() {
    this.simulation.work(this.isWaiting ? kCatchingUp : kBudget);
    this.timeline.extend(this.core, this.simulated);
    if (this.isWaiting) this.#arrive();
    if (this.checksum === null) this.#showChecksum();
    const ghostsBefore = this.simulation.ghostFrames;
    if (this.simulation.workOnGhost() && ghostsBefore <= this.frame) this.redraw();
  }

  #showChecksum() {
    const line = this.find(".rb-checksum");
    line.dataset.same = "false";
    line.dataset.record = String(this.record !== null);
    if (this.simulation.hasFailed) {
      line.textContent = say("No checksum: the motion can’t go on.");
    } else if (!this.isComplete) {
      line.textContent = say("Simulating … {share} %", {share: Math.floor(100 * this.simulated / this.simulation.frames)});
    } else {
      this.checksum = this.core.checksum(kPlayed);
      const isSame = this.record?.motion === this.checksum;
      const words = isSame ? say("the clip’s own, bit for bit") : say("not the clip’s, {motion}", {motion: this.record?.motion});
      line.textContent = say("Checksum of this motion: {motion}", {motion: this.checksum}) + (this.record ? " – " + words : "");
      line.dataset.same = String(isSame);
    }
  }

  tick(now) {
    const before = this.clock.position;
    this.#simulate();
    this.clock.speed = this.speed * (this.slowsAtFlips ? this.timeline.slowness(this.frame) : 1);
    if (!this.isWaiting) {
      if (this.isSeen) this.clock.tick(now, this.lastFrame);
      else this.clock.go(this.clock.position);
      if (this.clock.isPlaying && this.drawnAt) this.drawing.quality.take(now - this.drawnAt);
      if (this.clock.position !== before || this.isDirty) this.#draw(this.frame);
      if (this.clock.isPlaying && this.simulation.isDone && this.frame >= this.lastFrame) this.#end();
    }
    this.drawnAt = this.clock.isPlaying && this.isSeen ? now : null;
    this.timeline.draw(this.simulation.frames, this.simulated, this.#nudgesOnTimeline(), this.predict.isAsking);
  }

  /** A motion that has ended begins again; one that can't go on, or has a single picture, waits. */
  #end() {
    if (this.simulation.hasFailed || this.lastFrame === 0) this.#setPlaying(false);
    else this.#goTo(0);
  }

  /** Returns the nudges' places on the time line, as shares of it. */
  #nudgesOnTimeline() {
    const frames = Math.max(this.simulation.frames - 1, 1), last = this.timeOf(this.lastFrame);
    return this.scene.nudgeTimes.map((time) => time / last * this.lastFrame / frames);
  }

  #draw(frame) {
    this.isDirty = false;
    this.drawing.draw(frame, this);
    showNumbers(this.find(".rb-numbers"), kNumbers, this, frame);
    if (this.find(".rb-more").open) showNumbers(this.find(".rb-more-numbers"), kMoreNumbers, this, frame);
    this.#showTime(this.timeOf(frame), frame);
    this.#drawBall(frame);
    this.#drawWhy(frame);
    showNames(this.find(".rb-names"), this.scene, this.read.motions.length);
    const words = wordsOfEvents(this.timeline.events, this.announcedFrame, frame, this.labels, (at) => this.timeOf(at));
    if (words.length > 0) this.announcer.announce(words.join(". "));
    this.announcedFrame = frame;
    this.outcome.tick(this.timeOf(frame));
    this.predict.tick(this.timeOf(frame), this.simulation.isDone && frame >= this.lastFrame);
    this.tour.tick();
  }

  #showTime(time, frame) {
    const seek = this.timeline.slider;
    seek.max = Math.max(this.simulation.frames - 1, 1);
    seek.value = frame;
    seek.setAttribute("aria-valuetext", seconds(time));
    this.find(".rb-time").textContent = seconds(time);
  }

  #drawBall(frame) {
    const {moments} = this.read.motions[this.book], isShown = this.scene.shows("polhode") && this.read.motions.length <= kMostBooks;
    this.find(".rb-ball-frame").hidden = !isShown;
    if (!isShown) return;
    this.ball.draw(moments, trailOf(this.core, this.book, frame));
  }

  /** The ladder, and the legend of forces. */
  #drawWhy(frame) {
    const {scene, book} = this, motion = this.read.motions[book], legend = this.find(".rb-legend"), hasRoom = this.read.motions.length <= kMostBooks;
    this.ladder.canvas.hidden = !(hasRoom && scene.shows("energy_ladder"));
    if (!this.ladder.canvas.hidden) this.ladder.draw(this.core.ladder(kPlayed, book, frame));
    legend.hidden = !(hasRoom && scene.shows("forces"));
    legend.style.visibility = this.hand.held ? "hidden" : "";  // Its place stays.
    if (!legend.hidden) showLegend(legend, this.core.forces(kPlayed, book, frame), motion, scene.frameOf(book), this.drawing.pixelsOfMetre(book));
  }

  redraw() { this.isDirty = true; }

  #setPlaying(isPlaying) {
    if (isPlaying) this.outcome.plays();
    if (isPlaying) this.clock.play();
    else this.clock.pause();
    const button = this.find(".rb-play"), word = isPlaying ? say("Pause") : say("Play");
    button.dataset.state = isPlaying ? "playing" : "paused";
    button.querySelector(".rb-word").textContent = word;
    this.redraw();
  }

  start() { this.#setPlaying(true); }
  pause() { this.#setPlaying(false); }

  /** What plays or moves the picture waits for the answer of a question, and until the hand lets go. */
  #isFree() {
    if (this.predict.isAsking) this.predict.insist();
    return !this.predict.isAsking && !this.hand.held;
  }

  toggle() {
    if (!this.#isFree()) return;
    if (!this.clock.isPlaying && this.simulation.isDone && this.frame >= this.lastFrame) this.#goTo(0);
    this.#setPlaying(!this.clock.isPlaying);
  }

  seek(frame) {
    if (this.#isFree()) this.#goTo(Math.min(frame, this.simulation.frames - 1));
  }

  step(frames) {
    this.pause();
    this.seek(this.frame + frames);
  }

  open(file) { return this.files.open(file); }

  throwAbout(axis) {
    if (this.canThrow() && this.#isFree()) this.throws.throwAbout(axis);
  }
  throwFrom(book, attitude, velocity) { this.throws.throwFrom(book, attitude, velocity); }

  /** Sees the motion from another frame of reference. */
  setFrame(frame) { this.see(this.scene.withFrame(frame)); }

  get showsWhy() { return kWhy.every((overlay) => this.scene.shows(overlay)); }

  /** Shows forces and energies, or no longer; in the room there are none but what the body does to its parts, so a camera that turns sees them. */
  toggleWhy() {
    const {scene} = this, isShown = this.showsWhy;
    const tree = scene.withOverlays(isShown ? [] : kWhy, isShown ? kWhy : ["springs"]);
    const isInRoom = scene.frameOf(this.book) === "world";
    if (!isShown && isInRoom) this.see(scene.as(tree).withFrame("turning"));
    else this.see(isShown && this.isTurnedForWhy ? scene.as(tree).withFrame("world") : tree);
    this.isTurnedForWhy = !isShown && isInRoom;
  }

  reset() {
    if (this.tour.isOn) this.tour.open(this.tour.step);
    else this.loaded.reset();
  }

  edit(book) {
    this.book = book;
    this.controls.refresh();
    this.redraw();
  }

  booksChoice(scene) {
    if (scene.bookCount < 2) return "one";
    const isExact = (book) => this.read.motions[book].model === "exact";
    return isExact(scene.bookCount - 1) && !isExact(0) ? "exact" : "same";
  }

  setBooks(choice) {
    const one = this.scene.bookCount > 1 ? this.scene.as(this.scene.withOnly(this.book)) : this.scene;
    if (choice === "one") {
      this.apply(one.tree);
      return;
    }
    const isExact = choice === "exact";
    const other = isExact ? one.withExactBook() : one.withSecondBook(say("second"));
    if (this.apply(other)) this.edit(isExact ? 0 : 1);
  }

  /** Whether a book can be thrown: what was recorded happened as it did. */
  canThrow(book = this.book) { return this.read.motions[book]?.model !== "recorded"; }

  isOnBook(place) { return this.drawing.isOnBook(place) && this.canThrow(this.drawing.bookAt(place).index); }
  bookRadius(place) { return this.drawing.bookRadius(place); }

  /** Whether the hand can hold a book: not while a question waits for its answer. */
  canHold() { return !this.predict.isAsking; }

  showHand(from, to) {
    this.flick = from && [from, to];
    this.redraw();
  }

  tap(place) {
    if (this.isDirty && !this.isWaiting) this.#draw(this.frame);  // Where the books are now.
    if (this.predict.isAsking) this.predict.choosePanel(this.drawing.bookAt(place).index);
    else this.toggle();
  }

  throwBook(right, up) {
    if (this.canThrow() && this.#isFree()) this.throws.throwBook(right, up);
  }
  jiggle() { if (this.canThrow() && this.#isFree()) this.throws.jiggle(); }

  /** Whether the scene's text can hold the turned view: only a camera of the world's frame has a place of its own. */
  get canShareView() { return this.scene.explicit.camera?.frame === "world"; }
  get isViewMoved() { return this.orbit.right !== 0 || this.orbit.up !== 0 || this.orbit.distance !== 1; }

  /** The scene as it is seen: a turned view becomes the camera's place. */
  sharedText() {
    if (!this.isViewMoved || !this.canShareView) return this.scene.text;
    const eye = [...this.core.camera(kPlayed, 0, 0, 16, 9, this.orbit).eye];
    return this.core.textOf(this.scene.changed((tree) => {
      tree.camera = {...tree.camera, position: eye.map((part) => Number(part.toPrecision(5)))};
    }));
  }
}
