// What a browser lacks or loses: said, and the rest works.
"use strict";

const assert = require("node:assert/strict");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {test, before, after} = require("node:test");
const {kOutput, kPages, startBrowser, closeBrowser, open, violations, pageOfFigures, checksumOf} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

const kLacks = [
  ["WebAssembly", "delete window.WebAssembly;", /no WebAssembly/],
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
    assert.deepEqual(await page.locator(".rb-lack").first().evaluate((lack) => [lack.querySelector("img").complete, lack.querySelectorAll("a").length]), [true, 0]);
    await close();
  });
}

test("in the page, there is the way to the figures", async () => {
  const {page, close} = await open({}, {script: kLacks[0][1], isReady: "false", file: pathToFileURL(pageOfFigures()).href});
  await page.getByRole("link", {name: "Everything else on this page works."}).click();
  await page.waitForFunction(() => location.hash === "#page/figures" && document.querySelector("#turns").getBoundingClientRect().top < innerHeight);
  assert.ok(await page.locator("#turns .toy").isHidden());
  await close();
});

const kNoWebGl2 = "const get = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return kind === 'webgl2' ? null : get.call(this, kind, ...more); };";

/** The picture at a frame, small, with what is drawn over it, and what is said to lack. */
const pictureAt = (page, frame) => page.evaluate((wanted) => {
  const {player} = rotatebook, {drawing} = player;
  drawing.draw(wanted, player);
  const small = Object.assign(document.createElement("canvas"), {width: 64, height: 36}), context = small.getContext("2d");
  for (const canvas of [drawing.picture, drawing.lines]) context.drawImage(canvas, 0, 0, 64, 36);
  return {lack: drawing.view.lack, pixels: [...context.getImageData(0, 0, 64, 36).data]};
}, frame);

/** The mean difference of two pictures where either isn't wall, of 255. */
function differenceOf(a, b) {
  const differences = a.flatMap((part, i) => (i % 4 < 3 && Math.max(part, b[i]) > 80 ? [Math.abs(part - b[i])] : []));
  return differences.reduce((sum, part) => sum + part, 0) / differences.length;
}

const saidOf = (page) => page.locator(".rb-said").textContent();

/** Whether what is said, and the time line, are in the window. */
const isOnFirstScreen = (page) => page.evaluate(() => [".rb-said", ".rb-timeline"].map((part) => {
  const {top, bottom, height} = document.querySelector(part).getBoundingClientRect();
  return height > 10 && top >= 0 && bottom <= innerHeight && scrollY === 0;
}));

for (const name of Object.keys(kPages)) {
  for (const [width, height] of [[1366, 768], [1024, 768], [390, 844]]) {
    test(`why it is drawn plainly is on the first screen of ${name}.html at ${width} x ${height}`, async () => {
      const file = pathToFileURL(kPages[name]()).href;
      for (const hash of ["", "?lang=de"]) {
        const {page, close} = await open({viewport: {width, height}}, {script: kNoWebGl2, file, hash});
        assert.match(await saidOf(page), /WebGL 2/);
        assert.deepEqual(await isOnFirstScreen(page), [true, true], hash);
        await page.screenshot({path: path.join(kOutput, `plain-${name}-${width}${hash.slice(6)}.png`)});
        await close();
      }
      const {page, close} = await open({viewport: {width, height}}, {file});
      await page.evaluate(() => rotatebook.player.drawing.view.gl.getExtension("WEBGL_lose_context").loseContext());
      await page.waitForFunction(() => /interrupted/.test(document.querySelector(".rb-said").textContent));
      assert.deepEqual(await isOnFirstScreen(page), [true, true]);
      await close();
    });
  }
}

test("without WebGL 2 the book is drawn plainly, and all but saving works", async () => {
  const {page, problems, close} = await open({reducedMotion: "no-preference"}, {script: kNoWebGl2});
  assert.match(await saidOf(page), /no WebGL 2/);
  await page.waitForFunction(() => rotatebook.player.frame > 20);
  await page.evaluate(() => rotatebook.player.pause());
  await page.screenshot({path: path.join(kOutput, "no-webgl2.png")});
  const plain = await pictureAt(page, 100), later = await pictureAt(page, 160);
  assert.ok(differenceOf(plain.pixels, later.pixels) > 20, "it moves");
  await page.locator(".rb-throws [data-axis=z]").click();
  await page.evaluate(() => rotatebook.player.pause());
  const z = await pictureAt(page, 100), checksum = await checksumOf(page);
  await page.locator(".rb-more summary").click();
  await page.locator("[data-do=clip]").click();
  await page.waitForFunction(() => /no WebGL 2/.test(document.querySelector(".rb-message").textContent) && document.querySelector(".rb-saving").hidden);
  assert.deepEqual(await violations(page), []);
  assert.deepEqual(problems, []);
  await close();
  const whole = await open();
  await whole.page.evaluate(() => rotatebook.player.throwAbout("z"));
  await whole.page.evaluate(() => rotatebook.player.pause());
  assert.equal(await checksumOf(whole.page), checksum);
  const [difference, other] = await Promise.all([100, 130].map(async (frame) => differenceOf(z.pixels, (await pictureAt(whole.page, frame)).pixels)));
  console.log(`${difference} from the shaded book, ${other} from it half a second later`);
  assert.ok(difference < 50 && other > 1.5 * difference);  // measured 43, 73
  await whole.close();
});

test("while the context is lost the book is drawn plainly; then there is the same picture", async () => {
  const {page, close} = await open();
  await page.waitForFunction(() => rotatebook.player.simulated > 100);
  const before = await pictureAt(page, 100);
  assert.equal(before.lack, "");
  assert.ok(Math.max(...before.pixels.filter((part, i) => i % 4 === 0)) > 100, "nothing is drawn");
  await page.evaluate(() => {
    window.losing = rotatebook.player.drawing.view.gl.getExtension("WEBGL_lose_context");
    losing.loseContext();
  });
  await page.waitForFunction(() => /interrupted/.test(document.querySelector(".rb-said").textContent));
  await page.screenshot({path: path.join(kOutput, "lost.png")});
  const lost = await pictureAt(page, 100);
  assert.match(lost.lack, /interrupted/);
  const difference = differenceOf(lost.pixels, before.pixels);
  console.log(`${difference} from the shaded book`);
  assert.ok(difference < 40);  // measured 30
  await page.evaluate(() => losing.restoreContext());
  await page.waitForFunction(() => document.querySelector(".rb-said").hidden);
  const again = await pictureAt(page, 100);
  assert.equal(again.lack, "");
  assert.ok(again.pixels.every((part, i) => Math.abs(part - before.pixels[i]) <= 1));  // As in the light look.
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
