// The hand on the picture: throws the book, turns the view, draws near.

const kTap = 6;            // A shorter way is a tap. [CSS pixels]
const kTapTime = 400;      // A longer one holds the book. [ms]
const kThrowTime = 120;    // The last part of the way, whose speed counts. [ms]
const kOrbitStep = 0.12;   // Of a key. [rad]
const kThrowStep = 1;      // Of a key. [rad/s]
const kHighest = 1.45;     // [rad]

class Pointer {
  /** `player`: with orbit, hand, isOnBook(place) [CSS pixels], canHold(), throwBook(right, up), tap(place), redraw(). */
  constructor(canvas, player) {
    this.canvas = canvas;
    this.player = player;
    this.touching = new Map();
    canvas.addEventListener("pointerdown", (event) => this.#press(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#release(event));
    canvas.addEventListener("pointercancel", (event) => this.#cancel(event));
    // A finger on the book holds it; one beside it scrolls up and down.
    canvas.addEventListener("touchstart", (event) => {
      if (this.touching.size > 1 || this.start?.isOnBook) event.preventDefault();
    }, {passive: false});
    canvas.addEventListener("wheel", (event) => {
      // Without a key the page scrolls.
      if (!event.ctrlKey && !event.shiftKey) return;
      event.preventDefault();
      this.#zoom(Math.exp(0.002 * (event.deltaY || event.deltaX)));
    }, {passive: false});
  }

  #place(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  #press(event) {
    if (event.button !== 0) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.player.find(".rb-hint").hidden = true;  // The hand knows by now.
    const place = this.#place(event);
    this.touching.set(event.pointerId, place);
    this.player.hand.putBack();  // Two fingers draw near.
    this.start = this.touching.size === 1 ? {place, time: event.timeStamp, isOnBook: this.player.isOnBook(place)} : null;
    this.way = [[event.timeStamp, ...place]];
    this.view = {...this.player.orbit};
    if (this.start?.isOnBook && !event.shiftKey && this.player.canHold()) this.start.isHeld = this.player.hand.hold(place, event.timeStamp);
    if (this.start?.isHeld) this.canvas.style.cursor = "grabbing";
  }

  #move(event) {
    const before = this.touching.get(event.pointerId), place = this.#place(event);
    if (!this.start?.isHeld) this.canvas.style.cursor = this.player.isOnBook(place) ? "grab" : "move";
    if (!before) return;
    const apart = () => {
      const [a, b] = [...this.touching.values()];
      return Math.hypot(a[0] - b[0], a[1] - b[1]);
    };
    const earlier = this.touching.size === 2 ? apart() : 0;
    this.touching.set(event.pointerId, place);
    if (this.touching.size === 2) return this.#zoom(earlier / Math.max(apart(), 1));
    this.way.push([event.timeStamp, ...place]);
    if (!this.start) return undefined;
    if (this.start.isHeld) this.player.hand.move(place, [place[0] - before[0], place[1] - before[1]], event.timeStamp);
    else if (this.start.isOnBook) this.player.showHand(this.start.place, place);
    else this.turn((before[0] - place[0]) / 160, (place[1] - before[1]) / 160);
    return undefined;
  }

  #release(event) {
    const {start} = this, place = this.#place(event), before = this.touching.get(event.pointerId) ?? place;
    const isStill = start && Math.hypot(place[0] - start.place[0], place[1] - start.place[1]) < kTap;
    const isTap = isStill && event.timeStamp - start.time < kTapTime;
    if (start?.isHeld && !isStill) {
      // Browsers may leave the last part of the way out.
      if (place[0] !== before[0] || place[1] !== before[1]) this.player.hand.move(place, [place[0] - before[0], place[1] - before[1]], event.timeStamp);
      this.player.hand.letGo(event.timeStamp);
    }
    this.#end(event);
    if (isTap) this.player.tap(place);
    else if (start?.isOnBook && !start.isHeld && !isStill) this.#add(event.timeStamp, place);
  }

  /** The browser took the way for scrolling. */
  #cancel(event) {
    if (this.view) this.turn(this.view.right - this.player.orbit.right, this.view.up - this.player.orbit.up);
    this.#end(event);
  }

  #end(event) {
    this.touching.delete(event.pointerId);
    this.player.hand.putBack();
    this.player.showHand(null);
    this.start = null;
  }

  /** Adds to the book's spin, as if the hand held its surface until it let go. */
  #add(now, place) {
    const at = this.way.findIndex(([time]) => now - time <= kThrowTime);
    if (at < 0) return;  // The hand held still before it let go.
    const first = this.way[Math.max(at - 1, 0)];
    const passed = Math.max(now - first[0], 16) / 1000, radius = this.player.bookRadius(place);
    const rate = (way) => Math.max(Math.min(way / passed / radius, kFastest), -kFastest);
    this.player.throwBook(rate(place[1] - first[2]), rate(place[0] - first[1]));
  }

  /** Turns the view about its up and its right. [rad] */
  turn(right, up) {
    const orbit = this.player.orbit;
    orbit.right += right;
    orbit.up = Math.max(Math.min(orbit.up + up, kHighest), -kHighest);
    this.player.redraw();
  }

  #zoom(factor) {
    const orbit = this.player.orbit;
    orbit.distance = Math.max(Math.min(orbit.distance * factor, 6), 0.35);
    this.player.redraw();
  }

  /** Returns whether the key was for the picture. */
  key(event) {
    const [x, y] = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key] ?? [0, 0];
    if (x || y) {
      if (event.shiftKey) this.player.throwBook(-y * kThrowStep, x * kThrowStep);
      else this.turn(kOrbitStep * x, kOrbitStep * y);
    } else if (event.key === "+" || event.key === "=") {
      this.#zoom(0.9);
    } else if (event.key === "-") {
      this.#zoom(1 / 0.9);
    } else if (event.key === "0") {
      Object.assign(this.player.orbit, {right: 0, up: 0, distance: 1});
      this.player.redraw();
    } else {
      return false;
    }
    return true;
  }
}
