// Clips that are saved from the page.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before, after} = require("node:test");
const {kOutput, kTurns, testOnce, startBrowser, closeBrowser, open, load, verify, playerScripts, checksumOf, frameOf, messageOf, sceneOf} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

// A second, so 60 pictures, of two books, with all words.
const kShort = kTurns.replace("[64, 36]\nduration = 1.5", "[320, 180]\nduration = 1") +
  "[overlay]\nshow = [\"omega\", \"momentum\", \"polhode\", \"caption\", \"clock\", \"ghost\"]\n[[panel]]\nlabel = \"first\"\n[[panel]]\nlabel = \"second\"\n" +
  "initial = { angular_velocity = [0.0, 0.0, 5.0], tilt = [0.1, \"x\"] }\n";
// Without any encoder, as in a browser that has none.
const kNoEncoder = "delete window.VideoEncoder";
const kNoH264 = `const ask = VideoEncoder.isConfigSupported;
  VideoEncoder.isConfigSupported = (config) => (/^avc/.test(config.codec) ? Promise.resolve({supported: false}) : ask.call(VideoEncoder, config));`;

/** Opens the page with a scene, and what is beneath "More". */
async function opened(scene = kShort, options = {}, viewport = {width: 640, height: 900}) {
  const opening = await open({acceptDownloads: true, viewport}, options);
  await load(opening.page, scene);
  await opening.page.locator(".rb-more > summary").click();
  return opening;
}

/** Saves the clip; returns its file's path in the tests' output, and its name. */
async function saved(page, name) {
  const [download] = await Promise.all([page.waitForEvent("download", {timeout: 120000}), page.locator("[data-do=clip]").click()]);
  const file = path.join(kOutput, "clips", name + path.extname(download.suggestedFilename()));
  await download.saveAs(file);
  return {file, name: download.suggestedFilename()};
}

for (const [script, define] of [[null, test], [kNoH264, testOnce]]) define(`a clip is saved whole, at its own pace, ${script ? "without H.264, too, " : ""}and is what its record says`, async () => {
  const {page, problems, close} = await opened(kShort, {script});
  const start = performance.now(), {file, name} = await saved(page, "saved"), took = performance.now() - start;
  assert.match(name, script ? /^live-book\.webm$/ : /^live-book\.(mp4|webm)$/);
  assert.match(await messageOf(page), /^Saved live-book\.\w+: 60 pictures of 320x180, (H\.264|VP9), with the record of its motion\./);
  console.log(`saved in ${took.toFixed(0)} ms: ${fs.statSync(file).size} bytes`);
  const {status, output} = verify(file);
  assert.equal(status, 4, output);
  for (const line of [/claims to be 60 frames of the scene live-book/, /ok {6}size {9}320x180/, /ok {6}record {7}as rotatebook writes it/,
    /ok {6}motion /, /ok {6}frames {7}60/, /ok {6}time stamps /, /ok {6}duration {5}1 s/, /ok {6}title {8}A book that turns over/, /^Motion proved: /m]) assert.match(output, line);
  const checksum = await checksumOf(page);
  assert.match(output, new RegExp(`motion {7}${checksum}`));
  await page.locator("input[type=file]").setInputFiles(file);
  await page.waitForFunction(() => /proved/.test(document.querySelector(".rb-message").textContent));
  assert.match(await messageOf(page), /^Motion proved: .* The clip’s pictures are a browser’s own, which can’t be compared\. /);
  assert.equal((await sceneOf(page)).title, "A book that turns over");
  assert.deepEqual(problems, []);
  await close();
});

testOnce("a saved clip of which a word was changed is refused", async () => {
  const {page, close} = await opened();
  const {file} = await saved(page, "changed"), bytes = fs.readFileSync(file);
  bytes.write("[6.5", bytes.indexOf("[6.0, 0.0, 0.0]"));
  fs.writeFileSync(file, bytes);
  const {status, output} = verify(file);
  assert.equal(status, 1, output);
  assert.match(output, /FAILED {2}motion /);
  await page.locator("input[type=file]").setInputFiles(file);
  await page.waitForFunction(() => /differs/.test(document.querySelector(".rb-message").textContent));
  await close();
});

/** Returns the pixels of some of a saved clip's pictures, decoded by the browser. */
const picturesOf = (page, file, wanted, rate) => page.evaluate(async ([address, frames, fps]) => {
  const video = Object.assign(document.createElement("video"), {src: address, muted: true});
  await new Promise((resolve, reject) => { video.onloadeddata = resolve; video.onerror = () => reject(new Error("no video")); });
  const canvas = Object.assign(document.createElement("canvas"), {width: video.videoWidth, height: video.videoHeight});
  const context = canvas.getContext("2d"), pictures = [];
  for (const frame of frames) {
    await new Promise((resolve) => { video.requestVideoFrameCallback(resolve); video.currentTime = (frame + 0.5) / fps; });
    context.drawImage(video, 0, 0);
    pictures.push([...context.getImageData(0, 0, canvas.width, canvas.height).data]);
  }
  return pictures;
}, [`data:video/${path.extname(file).slice(1)};base64,${fs.readFileSync(file).toString("base64")}`, wanted, rate]);

/** Returns the pixels of a frame as the page shows it, as large as a clip. */
const shownAt = (page, frame) => page.evaluate((at) => {
  const {player} = rotatebook, canvas = Object.assign(document.createElement("canvas"), {width: 320, height: 180}), context = canvas.getContext("2d");
  player.drawing.room = () => ({left: 0, top: 0, right: player.drawing.box.width, named: 0});  // As in clips, where no buttons are over the books.
  player.drawing.room = () => ({left: 0, top: 0, right: player.drawing.box.width, named: 0});  // No buttons are over a clip.
  player.drawing.draw(at, player);
  for (const layer of ["picture", "lines"]) context.drawImage(player.drawing[layer], 0, 0, 320, 180);
  return [...context.getImageData(0, 0, 320, 180).data];
}, frame);

/** Returns how far two pictures are apart in some rows, in the mean, of 255. */
function offIn([top, bottom], picture, other) {
  let sum = 0;
  for (let at = 4 * 320 * top; at < 4 * 320 * bottom; ++at) sum += Math.abs(picture[at] - other[at]);
  return sum / (4 * 320 * (bottom - top));
}

testOnce("its pictures are those of the page, with the words", async () => {
  const {page, close} = await opened(kShort, {}, {width: 800, height: 900});  // As wide as the clip for its height.
  const frames = [10, 30, 59], {file} = await saved(page, "pictures"), pictures = await picturesOf(page, file, frames, 60);
  for (const [i, frame] of frames.entries()) {
    const shown = await shownAt(page, frame), off = (rows, other) => offIn(rows, pictures[i], other);
    const words = off([145, 180], shown), books = off([30, 130], shown), later = off([30, 130], pictures[(i + 1) % 3]);
    console.log(`frame ${frame}: off by ${books.toFixed(1)} of 255 among the books, ${later.toFixed(1)} from another frame; ${words.toFixed(1)} where the words are`);
    assert.ok(books < later / 2 && words > books, "the frame is the clip's own");
  }
  await close();
});

testOnce("the words have no dark ground where the scene says so", async () => {
  const below = [], kBelowWords = [174, 180];
  for (const band of [true, false]) {
    const scene = kShort.replace("[overlay]", `[overlay]\nband = ${band}`), {page, close} = await opened(scene, {}, {width: 800, height: 900});
    const {file} = await saved(page, "band"), [picture] = await picturesOf(page, file, [30], 60);
    below.push(offIn(kBelowWords, picture, await shownAt(page, 30)));
    await close();
  }
  console.log(`below the words: off by ${below.map((off) => off.toFixed(1)).join(" with the ground, ")} without`);
  assert.ok(below[1] < below[0] / 4, `${below}`);  // Measured 1.2 and 15.3.
});

// Five pictures a second, so 60 in 12 s.
const kLong = kTurns.replace("[64, 36]\nduration = 1.5", "[320, 180]\nfps = 5\nduration = 20");

testOnce("twelve seconds are saved from the moment that is shown, or all by choice", async () => {
  const {page, problems, close} = await opened(kLong, {}, {width: 800, height: 900});
  for (const [at, length, part, frames] of [[30, "12", "frames 30:90 of 100", 60], [95, "12", "frames 40:100 of 100", 60], [30, "Infinity", "100 frames", 100]]) {
    await page.evaluate((frame) => rotatebook.player.seek(frame), at);
    await page.locator(".rb-length").selectOption(length);
    const {file} = await saved(page, "part"), {status, output} = verify(file);
    assert.match(await messageOf(page), new RegExp(`: ${frames} pictures of 320x180`));
    assert.equal(status, 4, output);
    for (const words of [`claims to be ${part} of the scene live-book`, `ok {6}frames {7}${frames} `, `ok {6}duration {5}${frames / 5} s`, "^Motion proved: "]) {
      assert.match(output, new RegExp(words, "m"));
    }
    if (at !== 30 || length !== "12") continue;
    const [first] = await picturesOf(page, file, [0], 5), [own, other] = [offIn([30, 130], first, await shownAt(page, 30)), offIn([30, 130], first, await shownAt(page, 0))];
    assert.ok(own < other / 2, `${own} from the moment's picture, ${other} from the beginning's`);
    await page.locator("input[type=file]").setInputFiles(file);
    await page.waitForFunction(() => /proved/.test(document.querySelector(".rb-message").textContent));
    assert.equal(await frameOf(page), 30, "it is played from where it begins");
  }
  assert.deepEqual(problems, []);
  await close();
});

testOnce("the time that is left is said in round numbers that don't jitter", () => {
  const {TimeLeft} = playerScripts(["save_clip"], ["TimeLeft"]);
  const worst = {s: 0, min: 0};
  for (const whole of [30, 200, 1000]) {
    const left = new TimeLeft(), said = [];
    for (let n = 1, passed = 0; n <= 720; ++n) {
      passed += whole / 720 * (1 + 0.5 * Math.sin(n));  // Some pictures take three times as long as others.
      const words = left.wordsAt(n, 720, passed), [number, unit] = words.split(" ");
      assert.equal(words === "", n < 20);
      if (unit) worst[unit] = Math.max(worst[unit], Math.abs(number * (unit === "min" ? 60 : 1) - whole * (1 - n / 720)));
      if (words && words !== said.at(-1)) said.push(words);
    }
    assert.equal(new Set(said).size, said.length, `said again: ${said.join(", ")}`);
  }
  assert.ok(worst.s < 10.5 && worst.min < 55, JSON.stringify(worst));  // Measured 10 and 51.9.
});

test("saving is cancelled by a button, and nothing else waits for it", async () => {
  const {page, problems, close} = await opened(kTurns.replace("[64, 36]\nduration = 1.5", "[1280, 720]\nduration = 60"));
  let isSaved = false;
  page.on("download", () => { isSaved = true; });
  await page.locator("[data-do=clip]").focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector(".rb-saving progress").value > 0);
  assert.match(await page.locator(".rb-saving span").textContent(), /^Picture \d+ of 720(, about \d+ (s|min) left)?$/);
  await page.evaluate(fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8"));
  assert.deepEqual(await page.evaluate(async () => (await axe.run(document)).violations.map(({id, nodes}) => `${id}: ${nodes[0].html}`)), []);
  // A throw meanwhile changes what is played, not what is saved.
  await page.evaluate(() => { rotatebook.player.jiggle(); });
  assert.equal((await sceneOf(page)).nudge.length, 1);
  await page.locator("[data-do=cancel]").focus();
  await page.keyboard.press("Enter");
  await page.locator(".rb-saving").waitFor({state: "hidden"});
  assert.equal(await messageOf(page), "The clip isn’t saved: cancelled.");
  assert.equal(await page.evaluate(() => document.activeElement.dataset.do), "clip");
  assert.equal(isSaved, false);
  assert.deepEqual(problems, []);
  await close();
});

testOnce("without an encoder there is a ZIP of pictures, and its record", async () => {
  const {page, problems, close} = await opened(kShort, {script: kNoEncoder});
  const {file, name} = await saved(page, "pictures");
  assert.equal(name, "live-book.zip");
  assert.match(await messageOf(page), /60 pictures of 320x180, PNG/);
  const bytes = fs.readFileSync(file), names = bytes.toString("latin1").match(/frame_\d{5}\.png/g);
  assert.equal(names.length, 120, "each in its place and in the list");
  assert.equal(names[119], "frame_00059.png");
  assert.ok(bytes.includes("# Renderer: a browser, "));
  assert.deepEqual(problems, []);
  await close();
});

testOnce("an encoder that only says it encodes is passed by, and one that breaks off is said", async () => {
  const silent = await opened(kShort, {script: `VideoEncoder.prototype.encode = () => {};`});
  assert.equal((await saved(silent.page, "silent")).name, "live-book.zip");
  await silent.close();
  const broken = await opened(kShort, {script: `const encode = VideoEncoder.prototype.encode; let count = 0;
    VideoEncoder.prototype.encode = function(...values) { if (++count > 20) throw new TypeError("out of order"); return encode.apply(this, values); };`});
  await broken.page.locator("[data-do=clip]").click();
  await broken.page.waitForFunction(() => /isn’t saved/.test(document.querySelector(".rb-message").textContent));
  assert.equal(await messageOf(broken.page), "The clip isn’t saved: The browser’s encoder has broken off: out of order");
  await broken.close();
});
