// Records of damaged and hostile clips, proofs that are given up, and a core that breaks off; without a browser.
"use strict";

const assert = require("node:assert/strict");
const {test} = require("node:test");
const {playerScripts, coreFor} = require("./live_page.cjs");

const scripts = playerScripts(["share", "record", "core", "proof"], ["readRecord", "proveClip", "RecordError", "SceneError", "Core"]);
const {proveClip, RecordError, SceneError, Core} = scripts, kCore = coreFor(scripts);

const kSum = "0123456789abcdef0123456789abcdef";
const kText = `# Made by rotatebook 1.0 from the scene turns\n# Motion: ${kSum}\n\ntitle = "Ein schönes Buch"\n`;
const kLimit = 32768;  // [bytes] of a scene's text
const kSoon = 1000;    // [ms]; measured up to 200 on a busy machine

const bytes = (...parts) => Buffer.concat(parts.map((part) => Buffer.from(part)));
const u32 = (value) => { const buffer = Buffer.alloc(4); buffer.writeUInt32BE(value); return buffer; };

/** A box of an MP4, and a whole one with a comment. */
const box = (type, ...parts) => {
  const content = bytes(...parts);
  return bytes(u32(content.length + 8), Buffer.from(type, "latin1"), content);
};
const kHead = box("ftyp", "isom", u32(0));
const list = (text) => box("ilst", box("\u00a9cmt", box("data", u32(1), u32(0), text)));
const comment = (text) => box("moov", box("udta", box("meta", u32(0), list(text))));
const mp4 = (text, ...more) => bytes(kHead, comment(text), box("mdat", "..."), ...more);

/** An element of a WebM with a size of four bytes, or an unknown one; and a whole one with a comment. */
const element = (id, ...parts) => {
  const content = bytes(...parts);
  return bytes(Buffer.from(id, "hex"), u32(0x10000000 + content.length), content);
};
const endless = (id, ...parts) => bytes(Buffer.from(id, "hex"), Buffer.from("01ffffffffffffff", "hex"), ...parts);
const simpleTag = (text, name) => element("67c8", element("45a3", name), element("4487", text));
const tags = (text, name = "COMMENT") => element("1254c367", element("7373", simpleTag(text, name)));
const kBlock = element("a3", "pictures"), kCluster = "1f43b675";
const webm = (...parts) => bytes(element("1a45dfa3", "webm"), element("18538067", ...parts));

const readRecord = async (file) => scripts.readRecord(await kCore, file);
const read = (content) => readRecord(new Blob([content]));
const refused = (content, pattern) => assert.rejects(read(content), (error) => {
  assert.ok(error instanceof RecordError, String(error.stack));
  assert.match(error.message, pattern);
  return true;
});

async function within(time, work) {
  const start = performance.now();
  await work();
  const took = performance.now() - start;
  assert.ok(took < time, `${took} ms`);
}

test("reads the records of these clips", async () => {
  for (const clip of [mp4(kText), webm(tags(kText)), webm(tags("x", "ENCODER"), element(kCluster, kBlock), tags(kText))]) {
    const record = await read(clip);
    assert.equal(record.text, kText);
    assert.equal(record.motion, kSum);
  }
});

test("a record that isn't UTF-8 is damaged", async () => {
  const broken = bytes(kText, Buffer.from([0xc3, 0x28, 0xff]));
  for (const clip of [mp4(broken), webm(tags(broken))]) await refused(clip, /^The clip’s record is damaged: it isn’t UTF-8\.$/);
  await refused(mp4(Buffer.from([0xff, 0xfe, 0xff])), /another program/);
});

test("a clip with two records is refused, whichever a player takes", async () => {
  const kOther = kText.replace("schönes", "anderes"), twice = /^The clip’s record is damaged: it is there twice\.$/;
  const item = (text) => box("\u00a9cmt", box("data", u32(1), u32(0), text));
  const listed = (...items) => bytes(kHead, box("moov", box("udta", box("meta", u32(0), box("ilst", ...items)))), box("mdat", "..."));
  assert.equal((await read(listed(item(kText)))).text, kText);
  await refused(listed(item(kText), item(kOther)), twice);
  await refused(listed(box("\u00a9cmt", box("data", u32(1), u32(0), kText), box("data", u32(1), u32(0), kOther))), twice);
  await refused(bytes(mp4(kText), comment(kOther)), twice);
  await refused(webm(tags(kText), tags(kOther)), twice);
  await refused(webm(element("1254c367", element("7373", simpleTag(kText, "COMMENT"), simpleTag(kOther, "Comment")))), twice);
  await refused(webm(element("1254c367", element("7373", element("67c8", element("45a3", "COMMENT"), element("4487", kText),
    element("4487", kOther))))), twice);
  assert.equal((await read(webm(tags(kText), tags("x", "ENCODER"), element(kCluster, kBlock)))).text, kText);
});

test("a clip that ends anywhere is refused", async () => {
  const cut = element("18538067", tags(kText)).subarray(0, 5);
  await refused(bytes(element("1a45dfa3", "webm"), cut), /cut off/);
  for (const clip of [mp4(kText), webm(endless(kCluster, kBlock), tags(kText)), webm(tags(kText))]) {
    for (let end = 0; end < clip.length; ++end) {
      // What ends after the record is whole for it, if no part of the file says that more was to come.
      await refused(clip.subarray(0, end), /cut off|too short|no record|damaged/);
    }
  }
});

test("a WebM's heads of any bytes are refused in words", async () => {
  for (const head of ["00", "0000", "01", "ff", "1f", "1f43b6", "1254c3", "a3", "a301", "a300", "a3ff", "4487", "448701",
    "a30100000000000000", "a37f00000000000000ff"]) {
    await refused(webm(Buffer.from(head, "hex")), /cut off|damaged|no record/);
    await refused(webm(element("1254c367", Buffer.from(head, "hex"))), /cut off|damaged|no record/);
  }
});

test("clusters of unknown size don't hide the record after them", async () => {
  const live = bytes(element("1a45dfa3", "webm"),
    endless("18538067", endless(kCluster, kBlock, kBlock), endless(kCluster, kBlock), tags(kText)));
  assert.equal((await read(live)).text, kText);
  const open = bytes(element("1a45dfa3", "webm"), endless("18538067", endless(kCluster, kBlock),
    endless("1254c367", endless("7373", simpleTag(kText, "COMMENT")))));
  assert.equal((await read(open)).text, kText);
  await refused(bytes(element("1a45dfa3", "webm"), endless("18538067", endless(kCluster, kBlock))), /no record/);
});

test("a clip of very many parts is refused soon", async () => {
  const many = (part, count) => Buffer.concat(new Array(count).fill(part));
  const clips = [bytes(kHead, many(box("free"), 1000000), mp4(kText)), webm(many(element("ec"), 1000000), tags(kText)),
    webm(endless(kCluster, many(kBlock, 1000000)), tags(kText))];
  for (const clip of clips) await within(kSoon, () => refused(clip, /can’t be reached: the file has more than 10000 parts\.$/));
  const few = mp4(kText, many(box("free"), 9000));
  await within(kSoon, async () => assert.equal((await read(few)).text, kText));
});

/** A file that notes how much of it is read; `get` makes its bytes. */
const fileOf = (name, size, get) => ({name, size, taken: 0, slice(begin, end) {
  const last = Math.min(end, size);
  this.taken += last - begin;
  return {arrayBuffer: async () => get(begin, last)};
}});

test("a record without end is refused before it is read", async () => {
  const long = (length) => kText + " ".repeat(length - Buffer.byteLength(kText));
  for (const clip of [mp4, (text) => webm(tags(text))]) {
    assert.equal((await read(clip(long(kLimit)))).text.length, kLimit - 1, "ö has two bytes");
    await refused(clip(long(kLimit + 1)), /^The clip’s record is damaged: it is longer than 32 KiB, the limit for a scene\.$/);
  }
  const huge = bytes(kHead, box("mdat"), comment(long(8e6)));
  const file = fileOf("huge.mp4", huge.length, (begin, end) => new Uint8Array(huge.subarray(begin, end)).buffer);
  await assert.rejects(readRecord(file), {message: /limit for a scene/});
  assert.ok(file.taken <= 4 * 65536, `${file.taken} bytes`);
  await refused(mp4("Lyrics\n".repeat(10000)), /another program/);
});

test("a folder, or a file that is gone, is said to be", async () => {
  const folder = fileOf("holiday", 4096, async () => { throw new DOMException("It could not be found.", "NotFoundError"); });
  await assert.rejects(readRecord(folder), (error) => error instanceof RecordError &&
    /^holiday can.t be read: it is a folder, or gone\.$/.test(error.message));
});

/** A core whose motions have 1000 frames, and that reads clips; `calls` are of the slots it was called with. */
const coreFrom = (reader, frames) => ({
  beginClip: (size) => reader.beginClip(size), get clipOffset() { return reader.clipOffset; }, recordText: (bytes) => reader.recordText(bytes),
  calls: [], words: {version: "1.0"}, frames: () => frames, checksum: () => kSum,
  read(slot) { this.calls.push(slot); this.simulated = 0; },
  advance() { this.simulated = Math.min(this.simulated + 1, frames); return this.simulated; }});
const coreOf = async (frames = 1000) => coreFrom(await kCore, frames);
const clipOf = (content) => new File([content], "turns.mp4");

test("a proof has a slot of its own, and can be given up", async () => {
  const core = await coreOf(), proof = await proveClip(core, clipOf(mp4(kText)), () => {});
  assert.deepEqual([proof.isProved, core.calls], [true, [2]]);
  const early = await coreOf();
  assert.equal(await proveClip(early, clipOf(mp4(kText)), () => {}, () => false), null);
  assert.deepEqual(early.calls, [], "before the core is called");
  let breaths = 0;
  const late = await coreOf(Infinity);
  assert.equal(await proveClip(late, clipOf(mp4(kText)), () => {}, () => ++breaths < 3), null);
  assert.equal(breaths, 3);
});

test("whatever breaks the module off is said in a sentence", () => {
  const moduleThat = (fail) => ({HEAPU8: new Uint8Array(1 << 16), stack: 7,
    stackSave() { return this.stack; }, stackRestore(to) { this.stack = to; },
    _rb_new: () => 1, _rb_buffer: () => 0, _rb_buffer_size: () => 1 << 20, _rb_words() { new Uint8Array(this.HEAPU8.buffer).set(Buffer.from("{}")); return 2; },
    _rb_frames() { this.stack = 99; fail(); }});
  const internal = Object.assign(new Error("too much recursion"), {name: "InternalError"});
  const overflow = () => overflow() + 1;
  for (const [fail, pattern] of [
    [() => { throw new WebAssembly.RuntimeError("Aborted(OOM). Build with -sASSERTIONS for more info."); }, /enough memory/],
    [overflow, /^The scene is nested too deeply/],
    [() => { throw internal; }, /^The scene is nested too deeply/],
    [() => { throw new WebAssembly.RuntimeError("memory access out of bounds"); }, /broken off: memory access out of bounds\. Load/],
  ]) {
    const module = moduleThat(fail);
    assert.throws(() => new Core(module).frames(0), (error) => error instanceof SceneError && pattern.test(error.message));
    assert.equal(module.stack, 7);
  }
  const mistaken = moduleThat(() => { throw new TypeError("a mistake"); });
  assert.throws(() => new Core(mistaken).frames(0), TypeError);
});
