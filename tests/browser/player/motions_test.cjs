// Every scene that ships moves in the browser as in the program: bit for bit.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before, after} = require("node:test");
const {kRoot, startBrowser, closeBrowser, open, checksumOf, load} = require("./live_page.cjs");
const {kScenes, kMotions, giveFiles} = require("./shipped.cjs");

before(() => startBrowser());
after(closeBrowser);

test("all scenes have the checksums of the table", async () => {
  const {page, problems, close} = await open();
  assert.ok(kMotions.size >= 29);
  for (const [name, checksum] of kMotions) {
    const text = fs.readFileSync(kScenes.get(name), "utf8");
    await giveFiles(page, kScenes.get(name), text);
    assert.ok(await load(page, text), `${name}: ${await page.locator(".rb-message").textContent()}`);
    assert.equal(await checksumOf(page).catch((error) => `${error.message}; ${problems.join()}`), checksum, name);
  }
  assert.deepEqual(problems, []);
  await close();
});

test("another motion has another checksum", async () => {
  const {page, close} = await open();
  const text = fs.readFileSync(path.join(kRoot, "scenes/starter.toml"), "utf8");
  await load(page, text);
  const checksum = await checksumOf(page);
  assert.equal(checksum, kMotions.get("starter"));
  await page.evaluate(() => rotatebook.player.apply(rotatebook.player.scene.withSpeed(0, 5.0000001)));
  assert.notEqual(await checksumOf(page), checksum);
  await close();
});
