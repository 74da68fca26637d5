// The numbers beneath the picture, live.

const percent = (share) => `${say.number((100 * share).toPrecision(share >= 1 ? 5 : 4))} %`;
const degrees = (angle) => `${say.number(Math.abs(angle) < 0.01 && angle !== 0 ? angle.toExponential(1) : angle.toFixed(2))}°`;

const threeDigits = (number) => say.number(number.toFixed(3));

const energyOf = (sample) => sample[kSample.energies] + sample[kSample.energies + 1];

/** Names, and how to say a sample's number. */
const kNumbers = [
  [say("Flips"), (sample) => String(sample[kSample.halfTurns])],
  [say("Tilt"), (sample) => degrees(sample[kSample.tilt])],
  [say("Energy"), (sample, first) => percent(energyOf(sample) / energyOf(first))],
  [say("Error"), (sample, first, motion) => (motion.model === "exact" ? "–" : degrees(sample[kSample.error]))],
  [say("Stretch"), (sample) => say("{low} to {high}", {low: threeDigits(sample[kSample.stretch]), high: threeDigits(sample[kSample.stretch + 1])})],
];

/** Shows a row of numbers for each book. */
function showNumbers(list, player, frame) {
  const {motions} = player.read;
  const key = motions.map(({label}) => label).join("\n");
  if (list.dataset.labels !== key) {
    list.dataset.labels = key;
    list.replaceChildren(...kNumbers.map(([name]) => make("div", {}, make("dt", {}, name), ...motions.map((motion, i) => {
      const value = make("dd");
      if (motions.length > 1) value.style.setProperty("--rb-book", kBookColours[i]);
      return value;
    }))));
  }
  motions.forEach((motion, i) => {
    const sample = player.core.sample(kPlayed, i, frame), first = player.core.sample(kPlayed, i, 0);
    kNumbers.forEach(([, words], row) => { list.children[row].children[1 + i].textContent = words(sample, first, motion); });
  });
}
