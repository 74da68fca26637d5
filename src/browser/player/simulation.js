// Simulates ahead of the picture, in slices that leave the page its time: the motion that is played, and its ghost.

const kFirstSteps = 500;     // Of a slice; it adapts.
const kMaxSteps = 1e6;
const kLongSlice = 3;        // Longer ones are halved, shorter ones than a third doubled. [ms]
const kGhostSteps = 20000;

class Simulation {
  /** `onFailure` is called with the message of a motion that can't go on. */
  constructor(core, onFailure) {
    this.core = core;
    this.onFailure = onFailure;
    this.steps = kFirstSteps;
    this.simulated = 0;
  }

  /** Begins with the scene in the core's slot, which may have its motion already, and the text of the ghost's, null if there is none. */
  begin(ghostText) {
    this.hasFailed = false;
    this.simulated = 0;
    this.ghostText = ghostText;
    this.ghostFrames = 0;
    this.#advance(0);
  }

  get frames() { return this.core.frames(kPlayed); }
  get lastFrame() { return this.simulated - 1; }
  get isComplete() { return this.simulated >= this.frames; }
  /** Whether there is nothing more to come. */
  get isDone() { return this.isComplete || this.hasFailed; }

  #advance(frame) {
    const start = performance.now();
    try {
      this.simulated = this.core.advance(kPlayed, frame, this.steps);
    } catch (error) {
      if (!(error instanceof SceneError)) throw error;
      this.hasFailed = true;
      this.simulated = Math.max(this.simulated, 1);
      this.onFailure(error.message);
    }
    const took = performance.now() - start;
    if (took > kLongSlice) this.steps = Math.max(Math.floor(this.steps / 2), 1);
    else if (took < kLongSlice / 3) this.steps = Math.min(2 * this.steps, kMaxSteps);
  }

  /** Simulates for a while [ms], as far as `frame` at most. */
  work(time, frame = this.frames - 1) {
    const until = performance.now() + time;
    while (this.simulated <= frame && !this.isDone && performance.now() < until) this.#advance(frame);
  }

  /** Simulates a slice of the ghost's motion; returns whether it has got any further. */
  workOnGhost() {
    if (this.ghostText === null) return false;
    if (this.ghostFrames === 0) this.core.read(kGhost, this.ghostText);
    const before = this.ghostFrames, frames = this.core.frames(kGhost);
    if (before < frames) this.ghostFrames = this.core.advance(kGhost, frames - 1, kGhostSteps);
    return this.ghostFrames > before;
  }
}
