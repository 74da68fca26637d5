// Calls of the core in WebAssembly; bridge.h says what each does.

const kPlayed = 0, kGhost = 1, kProof = 2;  // Slots: the motion that is played, that of its ghost, that of a clip to prove.
const kSample = {time: 0, attitude: 1, omega: 5, momentum: 8, energies: 11, tilt: 14, halfTurns: 15, stretch: 16, error: 18,
  regime: 19, held: 20, corners: 21, numbers: 45};
const kRecordPiece = 65536;  // [bytes]
const kParts = ["front", "spine", "back", "pages", "lining"];

/** What the core refuses: the message that the program prints. */
class SceneError extends Error {}

/** Returns a refusal for people, who know no scene.toml: with the `file` and the place in it, or without both. */
const refusalOf = (message, file = "") => message.replace(/^scene\.toml((?::\d+)*): /, (all, place) => (file ? `${file}${place}: ` : ""));

/** Returns what stopped the module in the middle of a call, as people can understand it; other errors as they are. */
function understandable(error) {
  const problem = (words) => new SceneError(words, {cause: error});
  if (error instanceof RangeError || error.name === "InternalError") return problem(say("The scene is nested too deeply for this browser."));
  if (!(error instanceof WebAssembly.RuntimeError)) return error;
  if (/OOM|out of memory/i.test(error.message)) {
    return problem(say("There isn’t enough memory for this scene here; rotatebook render makes its clip."));
  }
  return problem(say("The simulation has broken off: {problem}. Load the page again.", {problem: error.message}));
}

const missing = (slot, motion) => new Error(`There is no motion ${motion} in slot ${slot}.`);

class Core {
  /** `module`: as emscripten makes it. */
  constructor(module) {
    this.module = module;
    this.context = module._rb_new(0, 0);
    this.buffer = this.#call("buffer");
    this.size = this.#call("buffer_size");
    this.words = JSON.parse(this.#text(this.#call("words")));
  }

  static async load(packed) {
    return new Core(await createRotatebookCore({wasmBinary: await unpacked(packed)}));
  }

  /** Calls a function of the module. One that is broken off leaves its part of the module's stack behind, which is taken back. */
  #call(name, ...values) {
    const stack = this.module.stackSave();
    try {
      return this.module["_rb_" + name](this.context, ...values);
    } catch (error) {
      this.module.stackRestore(stack);
      throw understandable(error);
    }
  }

  #put(text) {
    const bytes = new TextEncoder().encode(text);
    if (bytes.length > this.size) throw new SceneError("scene.toml: longer than 32 KiB, the limit for a scene");
    this.module.HEAPU8.set(bytes, this.buffer);
    return bytes.length;
  }

  /** The buffer's first bytes; a negative length is that of a message. */
  #text(length, Refusal = SceneError) {
    const text = new TextDecoder().decode(this.module.HEAPU8.slice(this.buffer, this.buffer + Math.abs(length)));
    if (length < 0) throw new Refusal(text);
    return text;
  }

  textOf(tree) { return this.#text(this.#call("json_to_toml", this.#put(JSON.stringify(tree)))); }
  treeOf(text) { return JSON.parse(this.#text(this.#call("toml_to_json", this.#put(text)))); }
  read(slot, text) { return JSON.parse(this.#text(this.#call("read", slot, this.#put(text)))); }
  /** Takes files {name, bytes} that scenes may name, in place of all others. */
  takeFiles(files) {
    this.#text(this.#call("file", 0, 0));
    for (const {name, bytes} of files) {
      const nameBytes = new TextEncoder().encode(name);
      this.module.HEAPU8.set(nameBytes, this.buffer);
      this.module.HEAPU8.set(bytes, this.buffer + nameBytes.length);
      this.#text(this.#call("file", nameBytes.length, bytes.length));
    }
  }

  /** Returns {duration, turning: [from, to], null if there is none} of a recording that was taken. */
  recording(name) { return JSON.parse(this.#text(this.#call("recording", this.#put(name)))); }

  /** Begins to look for the record in a clip of `size` bytes. */
  beginClip(size) { this.#call("clip", size); }
  /** Where the next piece of the clip begins. */
  get clipOffset() { return this.#call("clip_offset"); }
  /** Takes the next piece, of kRecordPiece bytes or what is left; returns the record's text, empty before it is found. */
  recordText(bytes) {
    this.module.HEAPU8.set(bytes, this.buffer);
    return this.#text(this.#call("record", bytes.length), RecordError);
  }

  /** Returns the mesh of a motion's body, {vertices, indices, parts}; null for the book. */
  body(slot, motion) {
    const body = JSON.parse(this.#text(this.#call("body", slot, motion)));
    if (!body) return null;
    const copied = (address, length) => this.module.HEAPU8.slice(address, address + 4 * length).buffer;
    return {parts: body.parts, vertices: new Float32Array(copied(this.#call("body_vertices"), 13 * body.vertices)),
      indices: new Uint32Array(copied(this.#call("body_indices"), body.indices))};
  }

  sceneText(slot) { return this.#text(this.#call("scene_text", slot)); }
  frames(slot) { return this.#call("frames", slot); }
  checksum(slot) { return this.#text(this.#call("checksum", slot)); }
  tableChecksum(slot, motion) { return this.#text(this.#call("table_checksum", slot, motion)); }

  /** Returns how many frames are simulated. */
  advance(slot, frame, steps) {
    const frames = this.#call("advance", slot, frame, steps);
    if (frames < 0) throw new SceneError(this.#text(this.#call("message")));
    return frames;
  }

  #sampleAt(slot, motion, frame) {
    const address = this.#call("sample", slot, motion, frame);
    if (address === 0) throw missing(slot, motion);
    return address;
  }

  /** Returns a copy of a sample's numbers. */
  sample(slot, motion, frame) {
    const address = this.#sampleAt(slot, motion, frame);
    return new Float64Array(this.module.HEAPU8.slice(address, address + 8 * kSample.numbers).buffer);
  }

  /** Returns some of a sample's numbers, by index. */
  numbers(slot, motion, frame, indices) {
    const address = this.#sampleAt(slot, motion, frame);
    const all = new Float64Array(this.module.HEAPU8.buffer, address, kSample.numbers);
    return indices.map((index) => all[index]);
  }

  /** Returns {matrix, eye} of the scene's camera, turned by `orbit` {right, up [rad], distance}. */
  camera(slot, motion, frame, width, height, orbit) {
    const place = this.buffer;
    const heap = this.module.HEAPU8.buffer;
    new Float64Array(heap, place, 2).set([orbit.right, orbit.up]);
    const values = [width, height, place, orbit.distance, place + 16, place + 80, place + 96];
    if (!this.#call("camera", slot, motion, frame, ...values)) throw missing(slot, motion);
    const floats = (begin, end) => new Float32Array(heap.slice(place + begin, place + end));
    return {matrix: floats(16, 80), eye: floats(80, 92), sky: floats(96, 160)};
  }

  /** Returns the numbers that a function answers with, empty if there are none. */
  #counted(name, ...values) {
    const address = this.#call(name, ...values, this.buffer), heap = this.module.HEAPU8.buffer;
    return new Float64Array(heap.slice(address, address + 8 * new Int32Array(heap, this.buffer, 1)[0]));
  }

  /** Returns {from, to, start [rad/s]} of the flight in readings [time, rate x y z, force x y z]; null if nothing flew. [s, rad/s, m/s²] */
  flight(readings) {
    const first = this.buffer + 16;  // Behind the count of the answer.
    new Float64Array(this.module.HEAPU8.buffer, first, 7 * readings.length).set(readings.flat());
    const [from, to, ...start] = this.#counted("flight", first, readings.length);
    return from === undefined ? null : {from, to, start};
  }

  /** Returns {longest, masses: [{place, held, centrifugal, coriolis, euler}]}. [N/kg] */
  forces(slot, motion, frame) {
    const numbers = this.#counted("forces", slot, motion, frame), masses = [];
    for (let at = 1; at < numbers.length; at += 15) {
      const [place, held, centrifugal, coriolis, euler] = [0, 3, 6, 9, 12].map((first) => numbers.subarray(at + first, at + first + 3));
      masses.push({place, held, centrifugal, coriolis, euler});
    }
    return {longest: numbers[0], masses};
  }

  /** Returns {now: {height, reach, angle, margin}, rungs: [{axis, isTurned, height, reach}], outline: [{height, reach}]}. */
  ladder(slot, motion, frame) {
    const numbers = this.#counted("ladder", slot, motion, frame), [height, reach, angle, margin] = numbers, outline = [];
    const rungs = [4, 8, 12].map((at) => ({axis: numbers[at], isTurned: numbers[at + 1] === 1, height: numbers[at + 2], reach: numbers[at + 3]}));
    for (let at = 16; at < numbers.length; at += 2) outline.push({height: numbers[at], reach: numbers[at + 1]});
    return {now: {height, reach, angle, margin}, rungs, outline};
  }

  /** Returns Poinsot's construction with trails of up to `trail` frames; null of a body at rest. */
  poinsot(slot, motion, frame, trail) {
    const numbers = this.#counted("poinsot", slot, motion, frame, trail), polhode = [], herpolhode = [];
    if (numbers.length === 0) return null;
    const [distance, least, greatest, longest] = numbers, vector = (at) => [...numbers.subarray(at, at + 3)];
    for (let at = 25; at < numbers.length; at += 6) {
      polhode.push(vector(at));
      herpolhode.push(vector(at + 3));
    }
    return {distance, least, greatest, longest, centre: vector(4), ellipsoid: [7, 10, 13].map(vector), plane: [vector(16), vector(19)], normal: vector(22),
      polhode, herpolhode};
  }

  /** Returns the spin that a motion starts with, and what follows from it; bridge.h says its names. */
  spin(slot, motion) { return JSON.parse(this.#text(this.#call("spin", slot, motion))); }

  mesh() {
    const heap = this.module.HEAPU8.buffer, count = this.buffer;
    const counted = () => new Int32Array(heap, count, 1)[0];
    const vertices = this.#call("mesh_vertices", count);
    const mesh = {vertices: new Float32Array(heap.slice(vertices, vertices + 52 * counted())), parts: {}};
    kParts.forEach((name, part) => {
      const indices = this.#call("mesh_indices", part, count);
      mesh.parts[name] = new Uint16Array(heap.slice(indices, indices + 2 * counted()));
    });
    return mesh;
  }
}
