// The numbers beneath the picture, live.

const kManifold = 10;   // Larger shares are said as multiples.
const kNoAngle = 1e-6;  // Smaller ones are of rounding. [degrees]
const kMostBooks = 6;   // More have no room for their numbers and names.

function percent(share) {
  if (share < kManifold) return `${say.number((100 * share).toFixed(2))} %`;
  return `${say.number(share < 1e6 ? share.toFixed(0) : share.toExponential(1).replace("+", ""))} ×`;
}

function degrees(angle) {
  const isSmall = angle >= kNoAngle && angle < 0.005;
  return `${isSmall ? "< " : ""}${say.number(isSmall ? "0.01" : angle.toFixed(2))}°`;
}

const threeDigits = (number) => say.number(number.toFixed(3));

const energyOf = (sample) => sample[kSample.energies] + sample[kSample.energies + 1];

const isRigid = ({model}) => model === "exact" || model === "recorded";

/** Names, tooltips, how to say a sample's number, and of which motions it is, all if not said. */
const kNumbers = [
  [say("Flips"), say("How often it has turned over"), (sample) => String(sample[kSample.halfTurns])],
  [say("Tilt"), say("Angle between the axis that it was spun about and its angular momentum L"), (sample) => degrees(sample[kSample.tilt])],
  [say("Energy"), say("As a share of that at the start"), (sample, first) => percent(energyOf(sample) / energyOf(first))],
  [say("Error"), say("Angle to the exact motion from the same start"), (sample, first, motion) => (motion.model === "exact" ? "–" : degrees(sample[kSample.error])),
    (motion) => motion.model !== "exact"],
];
/** As above, beneath More. */
const kMoreNumbers = [
  [say("Stretch"), say("The shortest and the longest edge, as shares of their lengths at rest"),
    (sample) => say("{low} to {high}", {low: threeDigits(sample[kSample.stretch]), high: threeDigits(sample[kSample.stretch + 1])}), (motion) => !isRigid(motion)],
];

/** Shows rows of numbers for each book. */
function showNumbers(list, numbers, player, frame) {
  const {motions} = player.read, shown = motions.length > kMostBooks ? [] : numbers.filter(([, , , isOf]) => !isOf || motions.some(isOf));
  const key = [...motions.map(({label}) => label), ...shown.map(([name]) => name)].join("\n");
  if (list.dataset.labels !== key) {
    list.dataset.labels = key;
    list.replaceChildren(...shown.map(([name, title]) => make("div", {title}, make("dt", {}, name), ...motions.map((motion, i) => {
      const value = make("dd");
      if (motions.length > 1) value.style.setProperty("--rb-book", inkOfLook(kBookColours[i]));
      return value;
    }))));
  }
  if (shown.length === 0) return;
  motions.forEach((motion, i) => {
    const sample = player.core.sample(kPlayed, i, frame), first = player.core.sample(kPlayed, i, 0);
    shown.forEach(([, , words], row) => { list.children[row].children[1 + i].textContent = words(sample, first, motion); });
  });
}
