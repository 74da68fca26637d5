// Throws and jiggles: each is a nudge of the scene, at the picture's time.

const kJiggle = 0.15;   // Share of the spin.
const kSeenAfter = 10;  // A throw near the end lengthens the clip by so much. [s]

class Throws {
  /** `player`: with core, scene, read, book, frame, timeOf(frame), isWaiting, clock, drawing, announcer and apply(tree, options). */
  constructor(player) {
    this.player = player;
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

  #nudge(velocity, done) {
    const {player} = this, {frame} = player;
    if (player.isWaiting) {
      player.announcer.show(say("The motion is still being simulated up to this moment."));
      return;
    }
    const at = Number((player.timeOf(frame) || player.read.interval / 2).toPrecision(9));
    const rounded = velocity.map((part) => Number(part.toPrecision(4)) || 0);
    if (rounded.every((part) => part === 0)) return;
    try {
      const end = frame / player.clock.rate + kSeenAfter;
      const isThrown = player.apply(player.scene.withNudge(at, rounded, end), {isPlaying: true});
      if (isThrown) player.announcer.announce(done(seconds(at)));
    } catch (error) {
      player.announcer.show(error.message, "bad");
    }
  }
}
