// Ten minutes of play, at eight times the speed of the clock: no growth of memory.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const {test, before, after} = require("node:test");
const {kTurns, startBrowser, closeBrowser, open, load} = require("./live_page.cjs");
const {kScenes} = require("./shipped.cjs");

const kGrowth = 1.0e6;  // [bytes]

before(() => startBrowser("--enable-precise-memory-info"));
after(closeBrowser);

/** Plays pictures from one frame to another, as the page would; returns the memory in use. [bytes] */
const playTo = (page, frame) => page.evaluate(async (last) => {
  const player = rotatebook.player;
  player.clock.speed = 8;
  player.start();
  let now = performance.now();
  while (player.frame < last) {
    player.tick(now += 1000 / 60);
    if (!player.clock.isPlaying) throw new Error("stopped at " + player.frame);
    if (player.frame % 256 < 8) await new Promise((resolve) => { setTimeout(resolve); });
  }
  player.pause();
  for (let i = 0; i < 3; ++i) {
    gc();
    await new Promise((resolve) => { setTimeout(resolve, 50); });
  }
  return {heap: performance.memory.usedJSHeapSize, core: player.core.module.HEAPU8.length, frame: player.frame};
}, frame);

test("memory doesn't grow", async () => {
  const {page, problems, close} = await open();
  await page.evaluate(() => { Object.assign(document.querySelector(".rb-stage").style, {width: "96px", height: "54px", aspectRatio: "auto"}); });
  const scene = fs.readFileSync(kScenes.get("fig05-unstable-x"), "utf8");
  await load(page, scene.replace(/^duration = .*$/m, "duration = 600"));
  await page.waitForFunction(() => rotatebook.player.checksum !== null, null, {timeout: 120000});
  const early = await playTo(page, 6000), late = await playTo(page, 35000);
  console.log(`heap ${early.heap} after ${early.frame} frames, ${late.heap} after ${late.frame}; core ${early.core}, ${late.core}`);
  assert.equal(late.core, early.core);
  assert.ok(late.heap - early.heap < kGrowth, `${early.heap} to ${late.heap}`);
  assert.deepEqual(problems, []);
  await close();
});

test("memory is steady while a clip is saved", async () => {
  const {page, problems, close} = await open();
  await load(page, kTurns.replace("duration = 1.5", "duration = 8"));
  await page.evaluate(() => { rotatebook.player.saver.save(); });
  const heapAt = async (share) => {
    await page.waitForFunction((least) => document.querySelector(".rb-saving progress").value > least, share, {timeout: 120000});
    return page.evaluate(() => {
      gc();
      return performance.memory.usedJSHeapSize;
    });
  };
  const early = await heapAt(0.1), late = await heapAt(0.9);
  console.log(`heap ${early} after a tenth of a clip of 480 pictures, ${late} after nine`);
  assert.ok(late - early < kGrowth, `${early} to ${late}`);
  await page.waitForFunction(() => /^Saved/.test(document.querySelector(".rb-message").textContent));
  assert.deepEqual(problems, []);
  await close();
});

test("scenes that come and go leave nothing", async () => {
  const {page, close} = await open();
  const after = (count) => page.evaluate(async (times) => {
    const player = rotatebook.player;
    for (let i = 0; i < times; ++i) {
      player.throwAbout("xyz"[i % 3]);
      player.setBooks(["same", "exact", "one"][i % 3]);
      if (i % 10 === 0) await new Promise((resolve) => { setTimeout(resolve); });
    }
    gc();
    await new Promise((resolve) => { setTimeout(resolve, 100); });
    gc();
    return performance.memory.usedJSHeapSize;
  }, count);
  const early = await after(30), late = await after(300);
  console.log(`heap ${early} after 30 scenes, ${late} after 330`);
  assert.ok(late - early < kGrowth, `${early} to ${late}`);
  await close();
});
