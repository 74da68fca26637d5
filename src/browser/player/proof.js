// Proves a clip: reads its record, simulates its scene again and compares the motion's checksum.

const kSlice = 24;  // [ms]

/** Lets the page draw and answer. */
const breath = () => new Promise((resolve) => { setTimeout(resolve); });

/**
 * Simulates a slot to its end without keeping the page waiting; `progress` is called with shares of 1. Returns whether it got
 * there: it stops once `isWanted` says no.
 */
async function simulateToEnd(core, slot, progress, isWanted) {
  const kSteps = 2000;
  let simulated = 0;
  while (simulated < core.frames(slot)) {
    const start = performance.now();
    do simulated = core.advance(slot, core.frames(slot) - 1, kSteps);
    while (simulated < core.frames(slot) && performance.now() - start < kSlice);
    progress(simulated / core.frames(slot));
    await breath();
    if (!isWanted()) return false;
  }
  return true;
}

/** Returns the words of the comparison. */
function verdict(core, file, record, motion) {
  if (motion === record.motion) {
    const pictures = record.isOfBrowser ? say("The clip’s pictures are a browser’s own, which can’t be compared.") :
      say("The clip’s pictures weren’t compared: rotatebook verify does that.");
    return say("Motion proved: simulated again here, it is that of {file}’s record bit for bit. {pictures} Checksum {motion}.", {file: file.name, pictures, motion});
  }
  const versions = record.program === core.words.version ? "" :
    " " + say("The clip was made by rotatebook {program}; this page is of {version}.", {program: record.program, version: core.words.version});
  return say("The motion differs: {file} says that the checksum of its motion is {stated}; its scene, simulated again here, gives {motion}.",
    {file: file.name, stated: record.motion, motion}) + versions;
}

/**
 * Returns {isProved, words, record, motion} of a clip; null once `isWanted` says no. Throws RecordError or SceneError where there is
 * nothing to compare.
 */
async function proveClip(core, file, progress, isWanted = () => true) {
  const record = await readRecord(core, file, isWanted);
  if (!record) return null;
  core.read(kProof, record.text);
  if (!await simulateToEnd(core, kProof, progress, isWanted)) return null;
  const motion = core.checksum(kProof);
  return {isProved: motion === record.motion, record, motion, words: verdict(core, file, record, motion)};
}
