// Scenes of files that aren't scenes: a mesh becomes the body, a table a recorded motion.

const kMeshFile = /\.(obj|stl|ply|glb)$/i, kTableFile = /\.(csv|tsv|txt)$/i;
const kMeshDensity = 1000;  // [kg/m³]
const kLargestThing = 1e6;  // [bytes]

const isThing = (name) => kMeshFile.test(name) || kTableFile.test(name);

/** Returns scenes for a file, of which the first that the core accepts is played. */
function scenesOfThing(file, longestTitle) {
  const title = file.slice(0, longestTitle);
  if (kTableFile.test(file)) {
    // A clip must not be longer than its recording, whose length only the core reads.
    const clips = [{duration: 12}, {duration: 5}, {duration: 5, speed: 0.2}, {duration: 4, speed: 0.1}, {duration: 2, speed: 0.05}];
    return clips.map((clip) => ({title, simulation: {model: "recorded", file}, clip}));
  }
  // A GLB is in metres; the others say no unit, and most are in millimetres.
  const body = {mesh: file, density: kMeshDensity, unit: /\.glb$/i.test(file) ? "m" : "mm"};
  const spins = [..."xyz"].map((axis) => ({angular_velocity: {about: "middle", value: kStartSpeed}, tilt: [kStartTilt, axis]}));
  // Where two moments are equal no axis is the middle one.
  return [...spins, {angular_velocity: [kStartSpeed, 1, 0.5]}].map((initial) => ({title, body, simulation: {model: "exact"}, initial}));
}
