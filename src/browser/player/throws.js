// Throws begin the motion anew; what is added to a spin, and jiggles, are nudges of the scene at the picture's time.

const kJiggle = 0.15;   // Share of the spin.
const kThrows = {x: "middle", y: "smallest", z: "largest"};  // The book's axes, and their moments.
const kSeenAfter = 10;  // A throw near the end lengthens the clip by so much. [s]

class Throws {
  /** `player`: with core, scene, read, book, frame, timeOf(frame), isWaiting, clock, drawing, announcer and apply(tree, options). */
  constructor(player) {
    this.player = player;
  }

  /** Throws the book about an axis, another body about the one of that moment. */
  throwAbout(axis) {
    const {scene, book} = this.player;
    const trees = scene.isOfBook(book) ? [scene.withStartAbout(book, axis)] : kAxes.map((toward) => scene.withStartAboutMoment(book, kThrows[axis], toward));
    trees.some((tree) => this.#begin(tree, book));  // No axis can be tilted toward itself.
  }

  /** Throws a book from rest: it lies as `attitude` says and is spun by `velocity` in its own axes. [rad/s] */
  throwFrom(book, attitude, velocity) {
    const {player} = this;
    if (!this.#begin(player.scene.withThrow(book, attitude, velocity), book) || !player.mayMove) return;
    const {core, drawing} = player, seen = core.sample(kPlayed, book, 0).subarray(kSample.attitude, kSample.attitude + 4);
    drawing.settling = {book, turn: times(attitude, undone([...seen]))};
  }

  /** Returns whether the core takes it. */
  #begin(tree, book) {
    const {player} = this, isThrown = player.apply(tree, {frame: 0, isPlaying: true});
    if (isThrown) player.outcome.expect(player.core.spin(kPlayed, book));
    return isThrown;
  }

  /** Adds to the spin about the picture's right and up. [rad/s] */
  throwBook(right, up) {
    const [rightAxis, upAxis] = Stage.axesOf(this.player.drawing.books[0].matrix);
    this.#nudge(rightAxis.map((part, axis) => right * part + up * upAxis[axis]), (time) => say("Thrown at {time}", {time}));
  }

  /** Adds a little across the spin, in any direction. */
  jiggle() {
    const {core, book, frame} = this.player;
    const spin = core.sample(kPlayed, book, Math.min(frame, this.player.lastFrame)).subarray(kSample.omega, kSample.omega + 3);
    const size = Math.hypot(...spin) || 1, along = [...spin].map((part) => part / size);
    const any = [0, 1, 2].map(() => Math.random() - 0.5), share = any.reduce((sum, part, axis) => sum + part * along[axis], 0);
    const across = any.map((part, axis) => part - share * along[axis]), length = Math.hypot(...across) || 1;
    this.#nudge(across.map((part) => kJiggle * size * part / length), (time) => say("Jiggled at {time}", {time}));
  }

  /** Returns a vector of the picture along axes that a nudge can state, and these: a camera that turns has others than the world. */
  #alongStated(velocity) {
    const {drawing, scene} = this.player;
    if (scene.frameOf(0) === "world") return [velocity, "world"];
    const attitude = drawing.books[0].sample.subarray(kSample.attitude, kSample.attitude + 4);
    return [turned(undone([...attitude]), velocity), "body"];
  }

  #nudge(velocity, done) {
    const {player} = this, {frame} = player;
    if (player.isWaiting) {
      player.announcer.show(say("The motion is still being simulated up to this moment."));
      return;
    }
    const at = Number((player.timeOf(frame) || player.read.interval / 2).toPrecision(9));
    const [along, axes] = this.#alongStated(velocity), rounded = along.map((part) => Number(part.toPrecision(4)) || 0);
    if (rounded.every((part) => part === 0)) return;
    try {
      const end = frame / player.clock.rate + kSeenAfter;
      const isThrown = player.apply(player.scene.withNudge(at, rounded, axes, end), {isPlaying: true});
      if (isThrown) player.announcer.announce(done(seconds(at)));
    } catch (error) {
      player.announcer.show(error.message, "bad");
    }
  }
}
