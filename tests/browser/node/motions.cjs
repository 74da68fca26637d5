// The motions of all scenes that ship, in WebAssembly beside the table of what they ought to be:
//     node motions.cjs BUILD TABLE SCENES
// BUILD is the folder of rotatebook_core.js. Prints each scene that differs, how long it took, and in
// the end "N passed, N failed"; exits with 1 if one failed.
const fs = require("fs");
const path = require("path");
const {filesOf} = require("../player/shipped.cjs");

const [build, table, scenes] = process.argv.slice(2);
const kNotMotions = new Set(["elementary-functions"]);

function rows(file) {
  return fs.readFileSync(file, "utf8").trim().split("\n").map((line) => line.split(" "))
    .filter(([name]) => !kNotMotions.has(name));
}

function sceneFiles(folder) {
  return fs.readdirSync(folder, {recursive: true, withFileTypes: true})
    .filter((entry) => entry.name.endsWith(".toml")).map((entry) => path.join(entry.path ?? entry.parentPath, entry.name));
}

class Core {
  constructor(module) { this.module = module; this.context = module._rb_new(0, 0); this.buffer = module._rb_buffer(this.context); }
  text(length) {
    const text = Buffer.from(this.module.HEAPU8.slice(this.buffer, this.buffer + Math.abs(length))).toString();
    if (length < 0) throw new Error(text);
    return text;
  }
  put(text) {
    const bytes = Buffer.from(text);
    this.module.HEAPU8.set(bytes, this.buffer);
    return bytes.length;
  }
  /** Takes the recordings and the mesh that a scene names, in place of all others. */
  takeFiles(scene, file) {
    this.text(this.module._rb_file(this.context, 0, 0));
    for (const {name, bytes} of filesOf(file, scene)) {
      this.put(Buffer.concat([Buffer.from(name), bytes]));
      this.text(this.module._rb_file(this.context, Buffer.byteLength(name), bytes.length));
    }
  }
  /** Returns the checksums of the scene's motions and of their tables. */
  checksums(scene) {
    this.text(this.module._rb_read(this.context, 0, this.put(scene)));
    while (true) {
      const frames = this.module._rb_advance(this.context, 0, 1e9, 1e9);
      if (frames < 0) throw new Error(this.text(this.module._rb_message(this.context)));
      if (frames === this.module._rb_frames(this.context, 0)) break;
    }
    return [this.text(this.module._rb_checksum(this.context, 0)), this.text(this.module._rb_table_checksum(this.context, 0))];
  }
}

async function main() {
  const module = await require(path.resolve(build, "rotatebook_core.js"))({
    wasmBinary: fs.readFileSync(path.join(build, "rotatebook_core.wasm"))});
  const core = new Core(module);
  const files = new Map(sceneFiles(scenes).map((file) => [path.basename(file, ".toml"), file]));
  let passed = 0, failed = 0;
  const check = (name, holds, text) => {
    if (holds) passed += 1; else { failed += 1; console.log(`${name}: ${text}`); }
  };
  for (const [name, ...expected] of rows(table)) {
    const file = files.get(name);
    files.delete(name);
    if (!file) { check(name, false, "there is no such scene"); continue; }
    const text = fs.readFileSync(file, "utf8");
    const start = process.hrtime.bigint();
    let found;
    try {
      core.takeFiles(text, file);
      found = core.checksums(text);
    } catch (error) { found = [error.message, ""]; }
    console.log(`${name} ${Number((process.hrtime.bigint() - start) / 1000000n)} ms`);
    check(name, found[0] === expected[0], `the motion is ${found[0]}, not ${expected[0]}`);
    check(name, found[1] === expected[1], `the table is ${found[1]}, not ${expected[1]}`);
  }
  for (const name of files.keys()) check(name, false, "the table has no row for it");
  console.log(`${passed} passed, ${failed} failed`);
  process.exitCode = failed === 0 && passed > 0 ? 0 : 1;
}

main();
