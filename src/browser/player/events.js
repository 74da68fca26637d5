// What is said: events, politely and not too often, to those who listen; messages to everybody.

const kSilence = 1500;  // [ms]

const seconds = (time) => `${say.number(time.toFixed(time < 1e4 ? 2 : 0))} s`;

class Announcer {
  constructor(region, message) {
    this.region = region;
    this.message = message;
    this.last = -Infinity;
    this.waiting = null;
  }

  /** Of several events in a short time the last is announced. */
  announce(text) {
    this.next = text;
    if (this.waiting !== null) return;
    const wait = Math.max(this.last + kSilence - performance.now(), 0);
    this.waiting = setTimeout(() => {
      this.waiting = null;
      this.last = performance.now();
      this.region.textContent = this.next;
    }, wait);
  }

  /** Shows a message; `kind` is "good", "bad" or "". An empty text takes it away. */
  show(text, kind = "") {
    this.message.textContent = text;
    this.message.hidden = !text;
    this.message.dataset.kind = kind;
  }
}

/** Returns the words for the events of a time line between two frames. */
function wordsOfEvents(events, from, to, labels, timeOf) {
  return events.filter(({frame}) => frame > from && frame <= to).map(({frame, motion, halfTurns, isEnd}) => {
    const who = labels.length > 1 ? `${labels[motion]}: ` : "";
    const what = isEnd ? say("the motion diverged, and ends") : `${say("flip")} ${halfTurns}`;
    return `${who}${seconds(timeOf(frame))}: ${what}`;
  });
}
