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
