// From play to clip, and links.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const {test, before, after} = require("node:test");
const {startBrowser, closeBrowser, open, render, playerScripts, recordOf, checksumOf, sceneOf, messageOf, kTurns} = require("./live_page.cjs");

const {hashOf} = playerScripts(["share"], ["hashOf"]);

before(() => startBrowser());
after(closeBrowser);

/** A scene with a throw, a knob turned, two books and a turned view. */
async function played(page) {
  await page.locator(".rb-more > summary").click();
  await page.locator(".rb-picture").focus();
  await page.evaluate(() => rotatebook.player.seek(50));
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.locator("input[name=rb-books][value=same]").check();
  await page.locator("input[name=rb-model][value=matrix]").check();
  const length = page.locator(".rb-row", {hasText: "Length"}).locator("input[type=text]");
  await length.fill("3");
  await length.press("Enter");
}

test("a copied and a saved scene render to the same motion", async () => {
  const {page, problems, close} = await open({acceptDownloads: true, permissions: ["clipboard-read", "clipboard-write"]});
  await played(page);
  const checksum = await checksumOf(page);
  await page.locator("[data-do=copy]").click();
  await page.waitForFunction(() => /clipboard/.test(document.querySelector(".rb-message").textContent));
  const text = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(text, /\[\[nudge\]\]\nat = 0\.8333/);
  const record = await recordOf(render("copied", text));
  assert.equal(record.motion, checksum);
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("[data-do=save]").click()]);
  assert.equal(fs.readFileSync(await download.path(), "utf8"), text);
  // A scene that differs a little renders to another motion.
  const other = await recordOf(render("other", text.replace("at = 0.8333", "at = 0.8334")));
  assert.notEqual(other.motion, checksum);
  assert.deepEqual(problems, []);
  await close();
});

test("a link is a scene", async () => {
  const {page, close} = await open({permissions: ["clipboard-read", "clipboard-write"]});
  await played(page);
  const checksum = await checksumOf(page);
  await page.locator("[data-do=link]").click();
  await page.waitForFunction(() => /clipboard/.test(document.querySelector(".rb-message").textContent));
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const other = await open({}, {hash: new URL(link).hash});
  assert.equal(await checksumOf(other.page), checksum);
  await other.close();
  await close();
});

for (const width of [390, 768, 1280]) {
  test(`a link changes the scene of an open page, ${width} pixels wide`, async () => {
    const {page, close} = await open({viewport: {width, height: 800}});
    await page.evaluate((hash) => { location.hash = hash; }, await hashOf(kTurns));
    await page.waitForFunction(() => rotatebook.player.scene.tree.title === "A book that turns over");
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
    await close();
  });
}

test("a damaged link, or one of a broken scene, is said, and the last good scene stays", async () => {
  const {page, close} = await open();
  const before = await sceneOf(page);
  const go = async (hash, pattern) => {
    await page.evaluate((to) => { location.hash = to; }, hash);
    await page.waitForFunction((source) => new RegExp(source).test([".rb-said", ".rb-message"].map((line) => document.querySelector(line).textContent)), pattern.source);
    assert.deepEqual(await sceneOf(page), before);
  };
  await go((await hashOf(kTurns)).slice(0, -20), /damaged or cut off/);
  await go(await hashOf(kTurns.replace("tilt", "tlit")), /unknown key "tlit"/);
  await go(await hashOf("title = ["), /Shown instead/);
  assert.match(await page.locator(".rb-said").textContent(), /^the file ends within a value or header.* closed\. Shown instead/);
  assert.equal(await messageOf(page), "");
  await close();
});

test("a page's figure is played, and its checksum compared", async () => {
  const {page, close} = await open();
  const {motion, text} = await recordOf(render("turns", kTurns));
  assert.ok(await page.evaluate((scene) => rotatebook.play(scene.text, scene.motion), {text, motion}));
  assert.equal(await checksumOf(page), motion);
  assert.match(await page.locator(".rb-checksum").textContent(), /the clip’s own, bit for bit/);
  assert.equal(await page.evaluate(() => rotatebook.play("nothing = 1")), false);
  await close();
});
