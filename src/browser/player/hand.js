// The book in the hand: it rests there, turns with it, and is thrown from rest.

const kFastest = 30;      // [rad/s]
const kLeastThrow = 0.3;  // A slower hand puts the book back into its motion. [rad/s]
const kWheelRadius = 0.75;  // Of the book's: a hand that goes round it there turns it like a wheel.
const kNoTurn = [1, 0, 0, 0];

const sized = (vector, size) => vector.map((part) => part * size / (Math.hypot(...vector) || 1));

/** Returns the quaternion of a turn about a vector by its length [rad]. */
function quaternionOf(turn) {
  const angle = Math.hypot(...turn);
  return [Math.cos(angle / 2), ...sized(turn, Math.sin(angle / 2))];
}

/**
 * Returns the turn, about the picture's right, up and toward the viewer [rad], that a hand gives a book as it goes by `way` at a place from
 * its middle, x right and y down: along the line to the middle it rolls the book, across it the more it turns it like a wheel the farther it is.
 */
function turnOfHand([x, y], [dx, dy], radius) {
  const far = Math.hypot(x, y), [ex, ey] = far > 0 ? [x / far, y / far] : [1, 0];
  const along = dx * ex + dy * ey, across = dy * ex - dx * ey, share = Math.min(far / (kWheelRadius * radius), 1);
  const rolled = across * Math.sqrt(1 - share * share);
  return [(along * ey + rolled * ex) / radius, (along * ex - rolled * ey) / radius, -across * share / Math.max(far, kWheelRadius * radius)];
}

/** Returns the picture's right, up and toward the viewer. */
function axesOf(matrix) {
  const [[a, b, c], [d, e, f]] = Stage.axesOf(matrix);
  return [[a, b, c], [d, e, f], [b * f - c * e, c * d - a * f, a * e - b * d]];
}

class Hand {
  /** `player`: with drawing, scene, clock, frame, apply(tree, options), start(), pause(), redraw() and outcome. */
  constructor(player) {
    this.player = player;
    this.held = null;
  }

  /** Takes hold of the book at a place of the picture [CSS pixels; ms]; the motion waits. Returns whether there is one. */
  hold(place, time) {
    const {drawing, clock} = this.player, {index} = drawing.bookAt(place);
    if (index < 0) return false;
    this.held = {book: index, turn: kNoTurn, sample: drawing.books[index].sample, wasPlaying: clock.isPlaying,
      middle: drawing.middleOfBook(index), radius: drawing.bookRadius(place), axes: axesOf(drawing.books[index].matrix), time, turns: []};
    this.player.pause();
    return true;
  }

  /** The hand goes on to a place by a way. [CSS pixels; ms] */
  move(place, way, time) {
    const {held} = this;
    if (!held) return;
    const seen = turnOfHand(place.map((part, i) => part - way[i] - held.middle[i]), way, held.radius);
    const turn = [0, 1, 2].map((axis) => held.axes.reduce((sum, row, i) => sum + seen[i] * row[axis], 0));
    held.turn = times(quaternionOf(turn), held.turn);
    held.turns.push({since: held.time, time, turn});
    held.time = time;
    this.player.redraw();
  }

  /** Lets go: the book is thrown as it lies, with the spin that the hand had in the last part of its way, or goes on as before. */
  letGo(time) {
    const {held, player} = this;
    if (!held) return;
    const last = held.turns.filter((way) => time - way.time <= kThrowTime);
    const passed = Math.max(time - Math.max(last[0]?.since ?? time, time - kThrowTime), 16) / 1000;
    const spin = [0, 1, 2].map((axis) => last.reduce((sum, {turn}) => sum + turn[axis], 0) / passed);
    const size = Math.min(Math.hypot(...spin), kFastest);
    this.putBack();
    if (size < kLeastThrow) {
      if (!held.wasPlaying) player.outcome.say(say("The hand stood still, so it isn’t a throw: the book is back where it was."), true);
      return;
    }
    const attitude = times(held.turn, [...held.sample.subarray(kSample.attitude, kSample.attitude + 4)]);
    player.throwFrom(held.book, attitude, turned(undone(attitude), sized(spin, size)));
  }

  /** The book goes on as before. */
  putBack() {
    const {held, player} = this;
    this.held = null;
    if (held?.wasPlaying) player.start();
    else player.redraw();
  }

  /** Returns a sample as it is seen: that of a book in the hand rests, turned with it. */
  seen(book, sample) {
    const {held} = this;
    if (held?.book !== book) return sample;
    const turnedSample = sample.slice(), middle = middleOf(sample);
    for (let i = 0; i < 8; ++i) {
      const corner = turned(held.turn, [...cornerOf(sample, i)].map((part, axis) => part - middle[axis]));
      turnedSample.set(corner.map((part, axis) => part + middle[axis]), kSample.corners + 3 * i);
    }
    turnedSample.set(times(held.turn, [...sample.subarray(kSample.attitude, kSample.attitude + 4)]), kSample.attitude);
    return turnedSample;
  }
}
