// The forces on the body's masses, as clips draw them: arrows to one scale, which the legend states.

const kLongestForce = 0.65, kShortestForce = 0.02;  // In units of the distance from the middle of the book to its corners.
/** Kinds, and the frames that have them. */
const kForces = [
  {name: "held", words: say("held by the body"), colour: "#f7f5ed", isIn: () => true},
  {name: "centrifugal", words: say("centrifugal force"), colour: "#f28c40", isIn: (frame) => frame === "turning" || frame === "body"},
  {name: "coriolis", words: say("Coriolis force"), colour: "#5ca8fa", isIn: (frame) => frame === "turning"},
  {name: "euler", words: say("Euler force"), colour: "#4dcc9e", isIn: (frame) => frame === "body"},
];

/** Rounds down to 1, 2 or 5 times a power of ten. */
function roundedDown(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [5, 2, 1].find((digit) => value >= digit * power * (1 - 1e-9)) * power;
}

/** Draws the forces of `core.forces()` over a book. */
function drawForces(overlay, {longest, masses}, motion, frame) {
  if (!(longest > 0)) return;
  const reach = Math.hypot(...motion.body) / 2, kinds = kForces.filter(({isIn}) => isIn(frame));
  for (const mass of masses) {
    for (const {name, colour} of kinds) {
      const size = Math.hypot(...mass[name]), length = Math.min(size / longest, 1) * kLongestForce * reach;
      if (!(length > kShortestForce * reach)) continue;
      overlay.arrow(mass.place, [...mass.place].map((part, axis) => part + mass[name][axis] * length / size), colour, "", name === "held" ? 1.2 : 2);
    }
    overlay.dot(mass.place, kForces[0].colour, 2);
  }
}

/** Returns the kinds that a legend names, and how long its bar is. [m] */
function legendOf(longest, bar, motion, frame) {
  return {kinds: kForces.filter(({isIn}) => isIn(frame)), length: bar / longest * kLongestForce * Math.hypot(...motion.body) / 2};
}

/** The legend of the kinds in `frame`, with a bar for a force. `pixels`: of the picture in a metre at the book. */
function showLegend(list, {longest}, motion, frame, pixels) {
  list.hidden = !(longest > 0);
  if (list.hidden) return;
  const bar = roundedDown(0.35 * longest), key = frame + bar, {kinds, length} = legendOf(longest, bar, motion, frame);
  if (list.dataset.key !== key) {
    list.dataset.key = key;
    list.replaceChildren(...kinds.map(({words, colour}) => {
      const swatch = make("span", {className: "rb-swatch"});
      swatch.style.background = inkOfLook(colour);
      return make("li", {}, swatch, words);
    }), make("li", {}, make("span", {className: "rb-bar"}), `${say.number(String(bar))} N/kg`));
  }
  list.querySelector(".rb-bar").style.width = `${length * pixels}px`;
}
