// What the core in WebAssembly can take: the longest motions, in all slots at once, and the deepest texts; without a browser.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before} = require("node:test");
const {kPlay, playerScripts} = require("./live_page.cjs");

const kFolder = path.dirname(kPlay);
const kMaxFrames = 72000;      // As bridge.h has it.
const kMemory = 256 * 2 ** 20;  // [bytes]
const kSlots = [0, 1, 2];
const {Core, SceneError} = playerScripts(["share", "core"], ["Core", "SceneError"]);

let core;

before(async () => {
  const make = require(path.join(kFolder, "rotatebook_core.js"));
  core = new Core(await make({wasmBinary: fs.readFileSync(path.join(kFolder, "rotatebook_core.wasm"))}));
});

/** A clip of so many frames of so many books; `model` decides what they cost. */
function sceneOf(frames, books, spin = 5, model = "exact") {
  const panels = books > 1 ? Array.from({length: books}, (_, book) => `[[panel]]\nlabel = "${book}"\n`) : [];
  return `[simulation]\nmodel = "${model}"\n[initial]\nangular_velocity = [${spin}.0, 0.0, 0.1]\n[camera]\nfollow = "size"\n` +
    `[clip]\nfps = 100\nsize = [64, 36]\nduration = ${frames / 100}\n${panels.join("")}`;
}

/** Simulates a slot to its end. */
function finish(slot) {
  while (core.advance(slot, 1e9, 1e6) < core.frames(slot)) { /* It goes on. */ }
}

/** Returns the end of what was ever written. [bytes] */
function highWater() {
  const words = new Uint32Array(core.module.HEAPU8.buffer);
  let last = words.length - 1;
  while (words[last] === 0) --last;
  return 4 * last;
}

test("the longest motions play in all slots at once, in any order", () => {
  let spin = 1;
  // The vectors of samples double: what is just longer than a power of two takes most.
  for (const [frames, books] of [[36000, 1], [32770, 2], [12000, 6], [kMaxFrames, 1]]) {
    for (const slot of kSlots) core.read(slot, sceneOf(frames, books, spin += 1));
    // As far as the vectors are largest without having ended.
    for (const slot of kSlots) core.advance(slot, frames - 2, 1e9);
    for (const slot of kSlots) finish(slot);
    for (const slot of kSlots) assert.equal(core.sample(slot, books - 1, frames - 1)[0], (frames - 1) * 0.01);
    console.log(`${frames} frames of ${books}: up to ${(highWater() / 2 ** 20).toFixed(1)} MiB`);
  }
  assert.equal(core.checksum(0).length, 32);
  assert.equal(core.tableChecksum(0).length, 32);
  console.log(`with a table: up to ${(highWater() / 2 ** 20).toFixed(1)} MiB of ${kMemory / 2 ** 20}`);
  assert.equal(core.module.HEAPU8.length, kMemory);
  assert.ok(highWater() < kMemory - 16 * 2 ** 20, "measured 229 MiB");
});

test("the page is one file of at most 1.2 MB", () => {
  const {size} = fs.statSync(kPlay);
  assert.ok(size < 1.2e6, `${size} bytes, measured 1.12e6`);
});

test("longer ones are refused, and what is played stays", () => {
  core.read(0, sceneOf(100, 1));
  for (const [frames, books] of [[36000, 6], [180000, 1], [kMaxFrames + 1, 1], [12001, 6]]) {
    assert.throws(() => core.read(0, sceneOf(frames, books)), (error) => error instanceof SceneError &&
      error.message.startsWith(`scene.toml: the motion is too long to be played here: ${frames} frames`));
  }
  finish(0);
  assert.equal(core.frames(0), 100);
});

test("texts of any depth are refused in words", () => {
  const keys = (count) => new Array(count).fill("a").join(".");
  const deep = "scene.toml:1:17: nested deeper than any value of a scene";
  const tooDeep = "The scene is nested too deeply for this browser.";
  const nested = (parts, count) => `${`{${keys(parts)} = `.repeat(count)}1${"}".repeat(count)}`;
  for (const [text, message] of [
    [`${keys(15000)} = 1`, tooDeep],
    [`${keys(500)} = 1`, deep],
    [`[${keys(15000)}]`, tooDeep],
    [`[${keys(500)}]`, deep.replace("17", "1")],
    [`a = ${nested(5, 250)}`, deep.replace("17", "23")],
    [`a = ${nested(1, 250)}`, deep.replace("17", "45")],
    [`${keys(1000000)} = 1`, "scene.toml: longer than 32 KiB, the limit for a scene"],
  ]) {
    const start = performance.now();
    assert.throws(() => core.treeOf(text), (error) => error instanceof SceneError && error.message === message);
    assert.throws(() => core.read(0, text), SceneError);
    assert.ok(performance.now() - start < 1000, `${performance.now() - start} ms`);
  }
  for (const text of [`a = ${"[".repeat(30000)}`, `a = ${"{a=".repeat(10000)}`]) {
    assert.throws(() => core.treeOf(text), (error) => error instanceof SceneError &&
      /^scene\.toml:1:\d+: .*nested value depth/.test(error.message));
  }
  core.read(0, sceneOf(100, 1));
  finish(0);
});

test("a scene that is only drawn otherwise keeps its motion", () => {
  core.read(0, sceneOf(50, 1));
  core.advance(0, 29, 1e9);
  core.read(0, `title = "Other"\n${sceneOf(50, 1)}`);
  assert.equal(core.advance(0, 0, 1), 30);
  core.read(0, sceneOf(50, 1, 6));
  assert.equal(core.advance(0, 0, 1), 1);
});
