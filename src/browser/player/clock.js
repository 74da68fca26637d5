// Counts the clip's frames against the wall's clock: pictures are dropped, steps never.

class Clock {
  constructor() {
    this.position = 0;  // [frames]
    this.isPlaying = false;
    this.speed = 1;
    this.rate = 60;  // [frames/s]
  }

  get frame() { return Math.floor(this.position + 1e-6); }

  play() { this.isPlaying = true; this.last = null; }
  pause() { this.isPlaying = false; this.position = this.frame; }
  go(frame) { this.position = Math.max(frame, 0); this.last = null; }

  /** Goes on to `now` [ms], but not beyond the frame `last` that is simulated. A page that slept doesn't catch up. */
  tick(now, last) {
    if (this.isPlaying && this.last !== null) {
      const passed = Math.max(0, Math.min(now - this.last, 250));  // A picture's time may be before the first call's.
      this.position = Math.min(this.position + this.speed * this.rate * passed / 1000, Math.max(last, this.position));
    }
    this.last = now;
  }
}
