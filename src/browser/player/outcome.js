// One line: after a throw, what was done, and what follows from it; else what the browser or an address lacks.

const kSaidAfter = 3;  // [s]
const kQuiet = 10;     // A spin as near to its axis goes on quietly. [degrees]
const kAxisNames = {smallest: say("the axis of the smallest moment"), middle: say("the middle axis"), largest: say("the axis of the largest moment")};

/** Returns what a body does that is spun so; `spin`: of the core. */
function outcomeOf({axis, offAxis, isSteady, flipInterval}) {
  if (flipInterval) {
    const often = Math.round(1 / flipInterval);
    if (often > 1) return say("it turns over about {count} times a second", {count: often});
    if (flipInterval < 1.5) return say("it turns over about once a second");
    return say("it turns over about every {time} s", {time: say.number(flipInterval.toPrecision(2))});
  }
  if (isSteady && axis === "middle") return say("nothing disturbs it, so it spins on");
  return offAxis < kQuiet ? say("it spins on quietly") : say("it wobbles, but doesn’t turn over");
}

class Outcome {
  /** `line`: the paragraph that says it, in place of `hint`. */
  constructor(line, hint, announcer) {
    Object.assign(this, {line, hint, announcer, lack: ""});
    this.forget();
  }

  /** After a throw with this spin. */
  expect(spin) {
    this.spin = spin;
    const speed = say.number(spin.speed < 10 ? spin.speed.toFixed(1) : Math.round(spin.speed));
    const angle = say.number(spin.offAxis < 1 ? Number(spin.offAxis.toPrecision(1)) : Math.round(spin.offAxis));
    this.words = say("{speed} rad/s, {angle} degrees off {axis}: {outcome}.", {speed, angle, axis: kAxisNames[spin.axis], outcome: outcomeOf(spin)});
  }

  /** Another motion comes. */
  forget() {
    this.spin = null;
    this.#rest();
  }

  /** Says why the book is drawn plainly; with an empty `lack`, no longer. */
  warn(lack) {
    this.lack = lack;
    this.#rest();
    if (lack) this.announcer.announce(lack);
  }

  /** Says something else, until another motion comes, or this one plays. */
  say(text, isUntilPlayed = false) {
    this.words = "";
    this.isUntilPlayed = isUntilPlayed;
    this.#show(text);
    this.announcer.announce(text);
  }

  plays() {
    if (this.isUntilPlayed) this.#rest();
  }

  #rest() {
    this.words = "";
    this.isUntilPlayed = false;
    this.#show(this.lack);
  }

  #show(text) {
    this.line.textContent = text;
    this.line.hidden = !text;
    if (text) this.hint.hidden = true;
  }

  /** Called as time passes. [s] */
  tick(time) {
    if (!this.words || this.line.textContent === this.words || time < kSaidAfter) return;
    this.#show(this.words);
    this.announcer.announce(this.words);
  }
}
