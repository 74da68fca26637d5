// Calls of the core in WebAssembly; bridge.h says what each does.

const kFirst = 0, kSecond = 1;  // Slots: the motion that is played; that of the ghost, or of a clip to prove.
const kSample = {time: 0, attitude: 1, omega: 5, momentum: 8, energies: 11, tilt: 14, halfTurns: 15, stretch: 16, error: 18, regime: 19,
  held: 20, corners: 21, numbers: 45};
const kParts = ["front", "spine", "back", "pages", "lining"];

/** What the core refuses: the message that the program prints. */
class SceneError extends Error {}

class Core {
  /** `module`: as emscripten makes it. */
  constructor(module) {
    this.module = module;
    this.buffer = module._rb_buffer();
    this.size = module._rb_buffer_size();
    this.words = JSON.parse(this.#text(module._rb_words()));
  }

  static async load(packed) {
    const bytes = await throughStream(bytesOfBase64(packed), new DecompressionStream("gzip"));
    return new Core(await createRotatebookCore({wasmBinary: bytes}));
  }

  #put(text) {
    const bytes = new TextEncoder().encode(text);
    if (bytes.length > this.size) throw new SceneError("The scene is too long.");
    this.module.HEAPU8.set(bytes, this.buffer);
    return bytes.length;
  }

  /** The buffer's first bytes; a negative length is that of a message. */
  #text(length) {
    const text = new TextDecoder().decode(this.module.HEAPU8.slice(this.buffer, this.buffer + Math.abs(length)));
    if (length < 0) throw new SceneError(text);
    return text;
  }

  treeOf(text) { return JSON.parse(this.#text(this.module._rb_toml_to_json(this.#put(text)))); }
  read(slot, text) { return JSON.parse(this.#text(this.module._rb_read(slot, this.#put(text)))); }
  sceneText(slot) { return this.#text(this.module._rb_scene_text(slot)); }
  frames(slot) { return this.module._rb_frames(slot); }
  checksum(slot) { return this.#text(this.module._rb_checksum(slot)); }
  tableChecksum(slot, motion) { return this.#text(this.module._rb_table_checksum(slot, motion)); }

  /** Returns how many frames are simulated. */
  advance(slot, frame, steps) {
    const frames = this.module._rb_advance(slot, frame, steps);
    if (frames < 0) throw new SceneError(this.#text(this.module._rb_message()));
    return frames;
  }

  /** Returns a copy of a sample's numbers. */
  sample(slot, motion, frame) {
    const address = this.module._rb_sample(slot, motion, frame);
    return new Float64Array(this.module.HEAPU8.slice(address, address + 8 * kSample.numbers).buffer);
  }

  /** Returns some of a sample's numbers, by index. */
  numbers(slot, motion, frame, indices) {
    const address = this.module._rb_sample(slot, motion, frame);
    const all = new Float64Array(this.module.HEAPU8.buffer, address, kSample.numbers);
    return indices.map((index) => all[index]);
  }

  /** Returns {matrix, eye} of the scene's camera, turned by `orbit` {right, up [rad], distance}. */
  camera(slot, motion, frame, width, height, orbit) {
    const place = this.buffer;
    const heap = this.module.HEAPU8.buffer;
    new Float64Array(heap, place, 2).set([orbit.right, orbit.up]);
    this.module._rb_camera(slot, motion, frame, width, height, place, orbit.distance, place + 16, place + 80);
    return {matrix: new Float32Array(heap.slice(place + 16, place + 80)), eye: new Float32Array(heap.slice(place + 80, place + 92))};
  }

  mesh() {
    const heap = this.module.HEAPU8.buffer, count = this.buffer;
    const counted = () => new Int32Array(heap, count, 1)[0];
    const vertices = this.module._rb_mesh_vertices(count);
    const mesh = {vertices: new Float32Array(heap.slice(vertices, vertices + 40 * counted())), parts: {}};
    kParts.forEach((name, part) => {
      const indices = this.module._rb_mesh_indices(part, count);
      mesh.parts[name] = new Uint16Array(heap.slice(indices, indices + 2 * counted()));
    });
    return mesh;
  }
}
