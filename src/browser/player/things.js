// Scenes of files that aren't scenes: a mesh becomes the body, a table a recorded motion.

const kMeshFile = /\.(obj|stl|ply|glb)$/i, kTableFile = /\.(csv|tsv|txt)$/i;
const kMeshDensity = 1000;  // [kg/m³]
const kLargestThing = 1e6;  // [bytes]
const kRecordingLasts = 10, kLongestRecording = 600;  // [s]
const kOverlaysOfThing = {show: ["omega", "momentum", "polhode"]};

const isThing = (name) => kMeshFile.test(name) || kTableFile.test(name);

/** Returns the clip of a recording's `length` [s]: slower than it was if it is short, and not beyond its end. */
function clipOfRecording(length) {
  const speed = Math.min(Number((length / kRecordingLasts).toPrecision(1)), 1);
  return {speed, duration: Math.floor(Math.min(length / speed, kLongestRecording) * 60 - 1) / 60};
}

/** Returns the scene of a recording: of the part in which the body turns as in a throw, if there is one. */
function sceneOfRecording(title, file, {duration, turning}) {
  const [from, to] = turning ?? [], part = turning ? {from, to} : {};
  return {title, simulation: {model: "recorded", file, ...part}, clip: clipOfRecording(turning ? to - from : duration), overlay: kOverlaysOfThing};
}

/** Returns scenes for a file, of which the first that the core accepts is played. */
function scenesOfThing(file, core) {
  const title = file.slice(0, core.words.keys.title.max);
  if (kTableFile.test(file)) return [sceneOfRecording(title, file, core.recording(file))];
  // A GLB is in metres; the others say no unit, and most are in millimetres.
  const body = {mesh: file, density: kMeshDensity, unit: /\.glb$/i.test(file) ? "m" : "mm"};
  const spins = [..."xyz"].map((axis) => ({angular_velocity: {about: "middle", value: kStartSpeed}, tilt: [kStartTilt, axis]}));
  // Where two moments are equal no axis is the middle one.
  return [...spins, {angular_velocity: [kStartSpeed, 1, 0.5]}].map((initial) => ({title, body, simulation: {model: "exact"}, initial, overlay: kOverlaysOfThing}));
}
