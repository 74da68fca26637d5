// What a browser lacks or loses: said, and the rest works.
"use strict";

const assert = require("node:assert/strict");
const {test, before, after} = require("node:test");
const {startBrowser, closeBrowser, open} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

const kLacks = [
  ["WebAssembly", "delete window.WebAssembly;", /no WebAssembly/],
  ["WebGL 2", "const get = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return kind === 'webgl2' ? null : get.call(this, kind, ...more); };",
    /no WebGL 2/],
  ["DecompressionStream", "delete window.DecompressionStream;", /no DecompressionStream/],
  ["a module that starts", "WebAssembly.instantiate = () => Promise.reject(new Error('out of memory'));", /can’t be shown/],
];
for (const [name, script, pattern] of kLacks) {
  test(`without ${name} there is a sentence`, async () => {
    const {page, close} = await open({}, {script, isReady: "false"});
    assert.match(await page.locator(".rb-lack").first().textContent(), pattern);
    assert.ok(await page.locator(".rb-lack").first().isVisible());
    assert.ok(!(await page.locator(".rb-player").isVisible()));
    assert.ok(await page.locator("h1").isVisible());
    await close();
  });
}

test("a lost context is rebuilt, with the same picture", async () => {
  const {page, close} = await open();
  const picture = () => page.evaluate(() => {
    const player = rotatebook.player, canvas = player.drawing.picture;
    player.drawing.draw(100, player);
    const small = Object.assign(document.createElement("canvas"), {width: 64, height: 36}), context = small.getContext("2d");
    context.drawImage(canvas, 0, 0, 64, 36);
    return {isLost: player.drawing.view.isLost, pixels: [...context.getImageData(0, 0, 64, 36).data]};
  });
  await page.waitForFunction(() => rotatebook.player.simulated > 100);
  const before = await picture();
  assert.equal(before.isLost, false);
  assert.ok(Math.max(...before.pixels.filter((part, i) => i % 4 === 0)) > 100, "nothing is drawn");
  await page.evaluate(() => {
    window.losing = rotatebook.player.drawing.view.gl.getExtension("WEBGL_lose_context");
    losing.loseContext();
  });
  await page.waitForFunction(() => /interrupted/.test(document.querySelector(".rb-message").textContent));
  assert.equal((await picture()).isLost, true);
  await page.evaluate(() => losing.restoreContext());
  await page.waitForFunction(() => document.querySelector(".rb-message").hidden);
  const again = await picture();
  assert.equal(again.isLost, false);
  assert.deepEqual(again.pixels, before.pixels);
  await close();
});

test("the first picture comes soon", async () => {
  const {page, close} = await open({}, {script: `addEventListener("DOMContentLoaded", () => {
    const root = document.querySelector(".rb-live");
    new MutationObserver(() => { if (root.dataset.ready) window.readyAt ??= performance.now(); }).observe(root, {attributes: true});
  });`});
  const time = await page.evaluate(() => window.readyAt);
  console.log(`ready after ${time.toFixed(0)} ms`);
  assert.ok(time < 3000, String(time));
  await close();
});
