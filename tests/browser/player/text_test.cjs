// The player's reading and writing of texts, without a browser: records of clips, links.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const {test} = require("node:test");
const {render, playerScripts, coreFor, kTurns} = require("./live_page.cjs");

const scripts = playerScripts(["share", "record", "core"], ["readRecord", "RecordError", "Core", "hashOf", "textOfHash"]);
const {RecordError, hashOf, textOfHash} = scripts, kCore = coreFor(scripts);
const kLongest = 32768;  // [bytes]

const readRecord = async (blob) => scripts.readRecord(await kCore, blob);

for (const format of ["mp4", "webm"]) {
  test(`reads the record of a ${format}, and refuses what is cut off, plain or another program's`, async () => {
    const bytes = fs.readFileSync(render("turns", kTurns, format));
    const record = await readRecord(new Blob([bytes]));
    assert.equal(record.scene, "turns");
    assert.match(record.motion, /^[0-9a-f]{32}$/);
    for (const share of [0.01, 0.5, 0.99]) {
      await assert.rejects(readRecord(new Blob([bytes.subarray(0, Math.floor(share * bytes.length))])), {message: /cut off/});
    }
    const others = Buffer.from(bytes);
    others.write("# Made at home", others.indexOf("# Made by rotatebook"));
    await assert.rejects(readRecord(new Blob([others])), {message: /another program/});
    const plain = Buffer.from(bytes);
    if (format === "mp4") plain.write("free", plain.indexOf("udta"));
    else plain.write("REMARKS", plain.indexOf("COMMENT"));
    await assert.rejects(readRecord(new Blob([plain])), {message: /no record/});
  });
}

test("refuses bytes that are no clip, or damaged anywhere, with words", async () => {
  await assert.rejects(readRecord(new Blob(["title = 'a scene'\n"])), {message: /neither an MP4 nor a WebM/});
  await assert.rejects(readRecord(new Blob(["x"])), RecordError);
  for (const format of ["mp4", "webm"]) {
    const bytes = fs.readFileSync(render("turns", kTurns, format));
    for (let at = 0; at < bytes.length; at += Math.max(Math.floor(bytes.length / 400), 1)) {
      const damaged = Buffer.from(bytes);
      damaged[at] ^= 0xff;
      await readRecord(new Blob([damaged])).catch((error) => {
        assert.ok(error instanceof RecordError, `${format}, byte ${at}: ${error.stack}`);
      });
    }
  }
});

test("numbers have digits that stay, and few of them", () => {
  const {percent, degrees, seconds} = playerScripts(["events", "numbers"], ["percent", "degrees", "seconds"]);
  assert.deepEqual([0.9991, 1, 1.0004, 9.996, 22.6, 2251, 3.2e8].map(percent), ["99.91 %", "100.00 %", "100.04 %", "999.60 %", "23 ×", "2251 ×", "3.2e8 ×"]);
  assert.deepEqual([0, 1e-16, 1e-5, 0.006, 0.8021, 179.9999].map(degrees), ["0.00°", "0.00°", "< 0.01°", "0.01°", "0.80°", "180.00°"]);
  assert.deepEqual([0, 59.999, 861120].map(seconds), ["0.00 s", "60.00 s", "861120 s"]);
});

test("books share the picture evenly, or as the scene's grid has them", () => {
  const {dividedAreas} = playerScripts(["stage"], ["dividedAreas"]);
  const rows = (...values) => {
    const areas = dividedAreas(...values), tops = [...new Set(areas.map(({y}) => y))];
    return tops.map((top) => areas.filter(({y}) => y === top).length);
  };
  assert.deepEqual([1, 2, 3, 4, 6].map((count) => rows(count, 1280, 720)), [[1], [2], [3], [2, 2], [3, 3]]);
  assert.deepEqual([2, 3, 4].map((count) => rows(count, 390, 390)), [[2], [2, 1], [2, 2]]);
  assert.deepEqual(rows(96, 1280, 720, 12), Array(8).fill(12));
});

test("a refusal names the file that was dropped, or none", () => {
  const {refusalOf} = playerScripts(["core"], ["refusalOf"]), refusal = "scene.toml:4:8: [initial]: not so";
  assert.equal(refusalOf(refusal), "[initial]: not so");
  assert.equal(refusalOf(refusal, "mine.toml"), "mine.toml:4:8: [initial]: not so");
  assert.equal(refusalOf("scene.toml: longer", "mine.toml"), "mine.toml: longer");
});

test("packs a scene into a hash, and refuses a damaged or endless one", async () => {
  const text = kTurns + "# ü\n";
  const hash = await hashOf(text);
  assert.match(hash, /^#play=[A-Za-z0-9_-]+$/);
  assert.equal(await textOfHash(hash, kLongest), text);
  assert.equal(await textOfHash("#fig05"), null);
  await assert.rejects(textOfHash(hash.slice(0, -12), kLongest), {message: /damaged or cut off/});
  await assert.rejects(textOfHash("#play=%%"), {message: /damaged or cut off/});
  await assert.rejects(textOfHash(await hashOf("x".repeat(40000)), kLongest), {message: /damaged or cut off/});
});
