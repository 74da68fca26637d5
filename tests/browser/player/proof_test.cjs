// Clips and scenes dropped on the page.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before, after} = require("node:test");
const {kOutput, kTurns, startBrowser, closeBrowser, open, render, messageOf, sceneOf, checksumOf} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

/** Drops a file as a hand does, by the browser's own input. */
async function drop(page, file) {
  const client = await page.context().newCDPSession(page);
  const box = await page.locator(".rb-stage").boundingBox();
  const at = {x: box.x + box.width / 2, y: box.y + box.height / 2};
  const data = {items: [], files: [path.resolve(file)], dragOperationsMask: 1};
  for (const type of ["dragEnter", "dragOver", "drop"]) await client.send("Input.dispatchDragEvent", {type, ...at, data});
}

async function saying(page, pattern) {
  await page.waitForFunction((source) => new RegExp(source).test(document.querySelector(".rb-message").textContent), pattern.source);
  return messageOf(page);
}

function fileOf(name, bytes) {
  const file = path.join(kOutput, "clips", name);
  fs.writeFileSync(file, bytes);
  return file;
}

for (const format of ["mp4", "webm"]) {
  test(`proves a dropped ${format}, and plays its scene`, async () => {
    const {page, problems, close} = await open();
    await drop(page, render("turns", kTurns, format));
    assert.match(await saying(page, /proved/), /^Motion proved: .* bit for bit\. The clip’s pictures weren’t compared: .* Checksum [0-9a-f]{32}\.$/);
    assert.equal((await sceneOf(page)).title, "A book that turns over");
    await checksumOf(page);
    assert.match(await page.locator(".rb-checksum").textContent(), /the clip’s own, bit for bit/);
    assert.deepEqual(problems, []);
    await close();
  });
}

test("says what differs in a clip of another motion", async () => {
  const {page, close} = await open();
  const bytes = fs.readFileSync(render("turns", kTurns));
  // The record's scene spins a little faster than the clip.
  const at = bytes.indexOf("[6.0, 0.0, 0.0]");
  assert.ok(at > 0);
  bytes.write("[6.1", at);
  await drop(page, fileOf("faster.mp4", bytes));
  assert.match(await saying(page, /differs/), /says that the checksum of its motion is [0-9a-f]{32}; its scene, simulated again here, gives [0-9a-f]{32}/);
  await checksumOf(page);
  assert.match(await page.locator(".rb-checksum").textContent(), /not the clip’s/);
  await close();
});

test("says so of clips without a record, cut off, of another program, or with a broken scene", async () => {
  const {page, close} = await open();
  const before = await sceneOf(page), bytes = fs.readFileSync(render("turns", kTurns));
  const edited = (find, text) => {
    const copy = Buffer.from(bytes);
    copy.write(text, copy.indexOf(find));
    return copy;
  };
  const cases = [
    ["bare.mp4", edited("udta", "free"), /no record of rotatebook/],
    ["cut.mp4", bytes.subarray(0, bytes.length - 100), /cut off/],
    ["other.mp4", edited("# Made by rotatebook", "# Made by rotatorium"), /another program/],
    ["broken.mp4", edited("angular_velocity", "angular_velocify"), /broken\.mp4: .*unknown key "angular_velocify".*did you mean "angular_velocity"/s],
    ["letter.mp4", Buffer.from("Dear reader, this is no clip."), /neither an MP4 nor a WebM/],
  ];
  for (const [name, content, pattern] of cases) {
    await drop(page, fileOf(name, content));
    await saying(page, pattern);
    assert.deepEqual(await sceneOf(page), before, name);
  }
  await close();
});

test("plays a dropped scene, and refuses a broken one with the words of check", async () => {
  const {page, close} = await open();
  await drop(page, fileOf("good.toml", kTurns));
  await page.waitForFunction(() => rotatebook.player.scene.tree.title === "A book that turns over");
  await drop(page, fileOf("bad.toml", kTurns.replace("tilt", "tlit")));
  assert.match(await saying(page, /unknown key/), /:6:1: unknown key "tlit" in \[initial\]; did you mean "tilt"\?/);
  assert.equal((await sceneOf(page)).title, "A book that turns over");
  await close();
});

/** Returns the mean colour of what is drawn in the picture's middle. */
const middleOf = (page) => page.evaluate(() => {
  const {view} = rotatebook.player.drawing, gl = view.gl, pixels = new Uint8Array(4 * 16);
  view.draw(rotatebook.player.drawing.books);
  gl.readPixels(view.canvas.width >> 1, view.canvas.height >> 1, 4, 4, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return [0, 1, 2].map((part) => pixels.filter((_, i) => i % 4 === part).reduce((sum, value) => sum + value) / 16);
});

test("makes a dropped mesh the body, and a dropped table the motion", async () => {
  const {page, close, problems} = await open();
  const box = [[-30, -50, -10], [30, -50, -10], [30, 50, -10], [-30, 50, -10], [-30, -50, 10], [30, -50, 10], [30, 50, 10], [-30, 50, 10]]
    .map((point) => "v " + point.join(" ")).join("\n") + "\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  await drop(page, fileOf("box.obj", box));
  await page.waitForFunction(() => rotatebook.player.scene.tree.body?.mesh === "box.obj");
  assert.deepEqual((await sceneOf(page)).initial.angular_velocity, {about: "middle", value: 4});
  await page.waitForFunction(() => rotatebook.player.drawing.view.bodies[0]);
  const [red, green, blue] = await middleOf(page);
  assert.ok(Math.min(red, green, blue) > 60 && Math.max(red, green, blue) - Math.min(red, green, blue) < 60, "it is grey, not the book's red");
  await drop(page, fileOf("open.obj", box.replace("f 5 6 7 8\n", "")));
  assert.match(await saying(page, /open\.obj: /), /close the hole/);
  const isTaken = await page.evaluate(() => rotatebook.player.apply(rotatebook.player.scene.changed((tree) => { tree.title = "Still the box"; })));
  assert.ok(isTaken, "the box is still here");
  await page.evaluate(() => { window.box = rotatebook.player.drawing.view.bodies[0]; });
  await drop(page, fileOf("box.obj", box.replaceAll("50", "70")));
  await page.waitForFunction(() => rotatebook.player.drawing.view.bodies[0] !== window.box, null, {timeout: 20000});
  const table = "t,wx (rad/s),wy (rad/s),wz (rad/s)\n" + Array.from({length: 101}, (_, i) => `${i / 100},0,0,2`).join("\n") + "\n";
  await drop(page, fileOf("spin.csv", table));
  await page.waitForFunction(() => rotatebook.player.scene.tree.simulation?.file === "spin.csv");
  await page.waitForFunction(() => rotatebook.player.drawing.view.bodies[0] === null);
  assert.deepEqual(problems, []);
  await close();
});

test("takes a file from its field, too", async () => {
  const {page, close} = await open();
  await page.locator(".rb-more > summary").click();
  await page.locator("input[type=file]").setInputFiles(render("turns", kTurns));
  await saying(page, /proved/);
  await close();
});
