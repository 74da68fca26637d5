// Proves a clip: reads its record, simulates its scene again and compares the motion's checksum.

const kSlice = 24;  // [ms]

/** Lets the page draw and answer. */
const breath = () => new Promise((resolve) => { setTimeout(resolve); });

/** Simulates a slot to its end without keeping the page waiting; `progress` is called with shares of 1. */
async function simulateToEnd(core, slot, progress) {
  const frames = () => core.frames(slot);
  let simulated = 0, steps = 2000;
  while (simulated < frames()) {
    const start = performance.now();
    while (simulated < frames() && performance.now() - start < kSlice) simulated = core.advance(slot, frames() - 1, steps);
    progress(simulated / frames());
    await breath();
  }
}

/** Returns {isProved, words, record} of a clip. Throws RecordError or SceneError where there is nothing to compare. */
async function proveClip(core, file, progress) {
  const record = await readRecord(file);
  core.read(kSecond, record.text);
  await simulateToEnd(core, kSecond, progress);
  const motion = core.checksum(kSecond), isProved = motion === record.motion;
  if (isProved) {
    return {isProved, record, motion, words: `Motion proved: simulated again here, it is that of ${file.name} bit for bit. Checksum ${motion}.`};
  }
  const versions = record.program === core.words.version ? "" : ` The clip was made by rotatebook ${record.program}; this page is of ${core.words.version}.`;
  return {isProved, record, motion,
    words: `The motion differs: ${file.name} says that the checksum of its motion is ${record.motion}; its scene, simulated again here, gives ${motion}.${versions}`};
}
