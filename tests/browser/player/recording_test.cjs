// A recording that is dropped plays its throw, and offers nothing that it refuses.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before, after} = require("node:test");
const {kRoot, startBrowser, closeBrowser, open, checksumOf, sceneOf, messageOf} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

/** Opens the page with docs/toss.csv. */
async function opened() {
  const live = await open();
  await live.page.locator(".rb-more > summary").click();
  await live.page.locator("input[type=file]").setInputFiles(path.join(kRoot, "docs/toss.csv"));
  await live.page.waitForFunction(() => rotatebook.player.scene.tree.simulation?.file === "toss.csv");
  return live;
}

test("plays its throw, slowly, and says its name", async () => {
  const {page, problems, close} = await opened();
  const {from, to} = (await sceneOf(page)).simulation;
  // `rotatebook toss` finds the flight from 1.22 to 1.98 s.
  assert.ok(from > 1.15 && from < 1.25 && to > 1.95 && to < 2.05, `${from} to ${to}`);
  await checksumOf(page);
  const {turns, lasts} = await page.evaluate(() => {
    const {player} = rotatebook;
    return {turns: player.timeline.events.length, lasts: player.simulation.frames / player.clock.rate};
  });
  assert.equal(turns, 1);
  assert.ok(lasts > 9 && lasts < 11, String(lasts));
  assert.equal(await page.locator(".rb-title").innerText(), "toss.csv");
  assert.equal(await messageOf(page), "");
  assert.deepEqual(problems, []);
  await close();
});

test("is thrown by no button, key or hand", async () => {
  const {page, problems, close} = await opened(), text = await page.evaluate(() => rotatebook.player.scene.text);
  for (const selector of [".rb-throws button", "[data-do=jiggle]", "input[name=rb-model]"]) {
    for (const control of await page.locator(selector).all()) assert.ok(await control.isDisabled(), selector);
  }
  await page.locator(".rb-picture").focus();
  for (const key of ["x", "y", "z", "j", "Shift+ArrowLeft"]) await page.keyboard.press(key);
  await page.locator(".rb-ball").focus();
  await page.keyboard.press("ArrowUp");
  const {x, y, width, height} = await page.locator(".rb-stage").boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 60, y + height / 2, {steps: 5});
  await page.mouse.up();
  assert.ok(await page.evaluate(() => rotatebook.player.orbit.right !== 0), "a hand on it turns the view");
  assert.equal(await page.evaluate(() => rotatebook.player.scene.text), text);
  assert.equal(await messageOf(page), "");
  await page.locator("[data-do=reset]").click();
  assert.equal(await page.evaluate(() => rotatebook.player.scene.text), text, "the view comes back first");
  await page.locator("[data-do=reset]").click();
  assert.equal((await sceneOf(page)).simulation.model, "exact");
  assert.ok(await page.locator(".rb-throws button").first().isEnabled());
  assert.ok(await page.locator(".rb-title").isHidden());
  assert.deepEqual(problems, []);
  await close();
});
