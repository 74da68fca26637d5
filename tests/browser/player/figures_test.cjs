// The live book in the page of figures.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {test, before, after} = require("node:test");
const {kOutput, kPlay, kTurns, startBrowser, closeBrowser, open, render, rotatebook, checksumOf, recordOf} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

test("plays a figure at a click, and finds its checksum that of the clip", async () => {
  const clip = render("turns", kTurns), folder = path.dirname(clip);
  rotatebook("page", path.join(folder, "turns.toml"), "-o", folder, "--size", "64x36", "--live", path.join(path.dirname(kPlay), "live_book.html"));
  const {page, problems, close} = await open({}, {file: pathToFileURL(path.join(folder, "index.html")).href});
  const toy = page.locator("#turns .toy button");
  assert.ok(await toy.isVisible());
  await toy.click();
  await page.waitForFunction(() => rotatebook.player.scene.tree.title === "A book that turns over");
  const {motion} = await recordOf(clip);
  assert.equal(await checksumOf(page), motion);
  assert.match(await page.locator(".rb-checksum").textContent(), /the clip’s own, bit for bit/);
  assert.ok(await page.locator(".rb-stage").evaluate((stage) => stage.getBoundingClientRect().top >= 0 && stage.getBoundingClientRect().top < innerHeight));
  assert.match(await page.locator(".rb-title").innerText(), /^A book that turns over\s+Back to the figure$/);
  const seesFigure = () => page.waitForFunction(() => {
    const {top} = document.querySelector("#turns").getBoundingClientRect();
    return location.hash === "#turns" && top > -5 && top < innerHeight / 2;
  });
  await page.goBack();
  await seesFigure();
  await page.goForward();
  await page.waitForFunction(() => location.hash === "#play" && document.querySelector("#play").getBoundingClientRect().top < innerHeight / 2);
  await page.getByRole("link", {name: "Back to the figure"}).click();
  await seesFigure();
  await page.evaluate(() => rotatebook.player.throwAbout("z"));
  assert.equal(await page.locator(".rb-title strong").textContent(), "A book that turns over, changed");
  await page.locator(".rb-checksum").waitFor({state: "hidden"});  // It is another motion.
  await page.evaluate(() => rotatebook.player.reset());
  assert.equal(await checksumOf(page), motion);
  assert.ok(await page.getByRole("link", {name: "Back to the figure"}).isVisible());
  await page.locator(".rb-live").scrollIntoViewIfNeeded();
  await page.waitForFunction(() => rotatebook.player.isSeen);
  await page.evaluate(() => { rotatebook.player.start(); });
  await page.evaluate(() => {
    const video = document.querySelector("#turns video");
    video.muted = true;
    return video.play();
  });
  await page.waitForFunction(() => !rotatebook.player.clock.isPlaying);  // The clip drops no picture because of it.
  assert.deepEqual(problems, []);
  const size = fs.statSync(path.join(kOutput, "clips", "index.html")).size;
  assert.ok(size < 2e6, `${size} bytes`);
  await close();
});
