// The tour: six steps, each with a scene, a sentence and one thing to do; the next is open once it is done. An address names a step.

const kTourHash = "#tour=";

/** Returns how a book goes that is thrown about an axis, and seen with more `overlays` in `frame`. */
const tourScene = (axis, overlays = "", frame = "world") => `
simulation.model = "exact"
clip.duration = 60
camera.frame = "${frame}"
overlay.show = ["omega", "momentum"${overlays}]
[initial]
angular_velocity = [${kAxes.map((name) => (name === axis ? kStartSpeed : 0)).join(", ")}]
tilt = [${kStartTilt}, "${kTiltToward[axis]}"]
`;

/** Names, scenes, texts and when they are done; a step with a `task` asks that question. */
const kTour = [
  {name: say("Predict"), task: 0, text: kTasks[0].see, isDone: ({predict}) => !predict.isOpen || predict.isAnswered},
  {name: say("Throw it"), scene: tourScene("y"),
    text: say("No throw is quite straight, and about the middle axis that is enough. Throw the book head over heels, by its button or by hand, and wait until it turns over."),
    isDone: (player) => player.outcome.spin && player.core.numbers(kPlayed, 0, player.frame, [kSample.halfTurns])[0] > 0},
  {name: say("Ride with it"), scene: tourScene("x"),
    text: say("The same throw, seen from the book: the book rests, and its spin wanders over to the other side. Beside “room”, choose “book”."),
    isDone: ({scene}) => scene.frameOf(0) === "body"},
  {name: say("Forces"), scene: tourScene("x"),
    text: say("In a room that turns with the spin, what is off the axis is pulled away from it, the more the farther it is: so the tilt grows. Press “why”, and see the arrows."),
    isDone: (player) => player.showsWhy},
  {name: say("Why not the others"), scene: tourScene("y", ", \"forces\", \"energy_ladder\"", "turning"),
    text: say("Like a door, the forces pull the tilt farther, too, but the Coriolis force turns it aside; like a wheel, they pull it back. Throw the book like a wheel."),
    isDone: ({outcome}) => outcome.spin?.axis === "largest"},
  {name: say("Your own"), scene: tourScene("x", ", \"polhode\""),
    text: say("Now one of your own: throw it as you like, or give it another size beneath “More”. “Copy link” is there, too: it takes your book with you."),
    isDone: (player) => player.motionEdits > player.tour.editsBefore},
];

/** Returns the step, from 0, that an address's hash names; null if none. */
function tourStepOf(hash) {
  const step = hash.startsWith(kTourHash) ? Number(hash.slice(kTourHash.length)) - 1 : -1;
  return kTour[step] ? step : null;
}

class Tour {
  /** `box`: of questions, too; `line`: says where the tour is. */
  constructor(box, line, player) {
    Object.assign(this, {box, line, player});
    this.step = null;
  }

  get isOn() { return this.step !== null; }
  get #current() { return kTour[this.step]; }

  /** The buttons that lead on and away. */
  get ways() {
    const isLast = this.step === kTour.length - 1;
    return [[isLast ? say("Keep this book") : say("Next"), () => this.#next(), {className: "rb-strong rb-next", disabled: !this.isDone}],
      [say("Leave the tour"), () => this.#close(), {className: "rb-close"}]];
  }

  /** Opens a step, from 0; the address follows. */
  open(step) {
    const {player} = this;
    if (!this.isOn) this.before = this.#keep();
    Object.assign(this, {step, isDone: false, editsBefore: player.motionEdits});
    this.line.textContent = say("Tour, step {step} of {steps}: {name}", {step: step + 1, steps: kTour.length, name: this.#current.name});
    this.#goTo(kTourHash + (step + 1));
    if (this.#current.task === undefined) {
      const {name, scene} = this.#current;
      player.load(`title = "${name}"${scene}`, {isPlaying: player.mayMove, isStep: true});
      this.#show();
    } else {
      player.predict.ask(this.#current.task, true);
    }
  }

  #show() { this.box.show(this.#current.text, this.ways); }

  #next() {
    if (this.step + 1 < kTour.length) {
      this.open(this.step + 1);
    } else {
      this.forget();
      this.player.stage.focus({preventScroll: true});
    }
  }

  /** Called with each picture. */
  tick() {
    if (!this.isOn) return;
    if (this.box.element.hidden) this.#show();  // A change has closed the question.
    if (this.isDone || !this.#current.isDone(this.player)) return;
    const next = this.box.buttons.querySelector(".rb-next");
    this.isDone = true;
    next.disabled = false;
    // The answer to a question is said already.
    if (this.#current.task === undefined) this.player.announcer.announce(say("Done. Go on: “{button}”.", {button: next.textContent}));
  }

  /** What the player plays, and how it is seen. */
  #keep() {
    const {scene, frame, isPlaying, record, loaded, book, isTurnedForWhy, orbit} = this.player;
    const hash = location.hash.startsWith(kTourHash) ? "" : location.hash;
    return {text: scene.text, how: {frame, isPlaying, record}, loaded: [loaded.text, loaded.record, loaded.origin], isTurnedForWhy, book, orbit: {...orbit}, hash};
  }

  /** Leaves, and gives the book back as it was before; the address, too. */
  leave() {
    const {player, before: {text, how, loaded, isTurnedForWhy, book, orbit, hash}} = this;
    this.forget(hash);
    player.book = book;
    player.load(text, how);
    player.isTurnedForWhy = isTurnedForWhy;
    player.loaded.take(...loaded);
    player.loaded.show();
    Object.assign(player.orbit, orbit);
  }

  #close() {
    this.leave();
    this.player.stage.focus({preventScroll: true});
  }

  /** The tour is over; what is played stays. The address names another, unless somebody has gone on to one. */
  forget(hash = "") {
    if (!this.isOn) return;
    this.step = null;
    this.line.textContent = "";
    this.player.predict.leave();
    this.box.hide();
    this.player.loaded.show();
    if (location.hash.startsWith(kTourHash)) this.#goTo(hash);
  }

  #goTo(hash) {
    if (location.hash !== hash) history.pushState(null, "", location.href.split("#")[0] + hash);
  }
}
