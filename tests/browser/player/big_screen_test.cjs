// The big screen: full screen in both pages, in proportion at any height; and the light look.
"use strict";

const assert = require("node:assert/strict");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {test, before, after} = require("node:test");
const {kOutput, kPages, startBrowser, closeBrowser, open, violations, playerScripts} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

const isFull = (page, wanted) => page.waitForFunction((on) => (document.fullscreenElement !== null) === on && document.querySelector(".rb-bare") !== null === on, wanted);

for (const [name, fileOf] of Object.entries(kPages)) {
  test(`full screen by button and by key in ${name}.html`, async () => {
    const {page, problems, close} = await open({viewport: {width: 1280, height: 720}}, {file: pathToFileURL(fileOf()).href});
    const button = page.locator("[data-do=full]");
    assert.equal(await button.getAttribute("aria-label"), "Full screen");
    await button.click();
    await isFull(page, true);
    assert.equal(await button.getAttribute("aria-label"), "Leave full screen");
    const seen = await page.evaluate(() => [...document.querySelectorAll(".rb-stage, .rb-transport, .rb-numbers, .rb-front, .rb-more, .rb-proof")]
      .map((element) => [element.className, element.offsetHeight > 0, element.getBoundingClientRect().bottom <= innerHeight]));
    assert.deepEqual(seen.filter(([, isShown]) => isShown), [["rb-stage", true, true], ["rb-transport", true, true]]);
    const boxes = await page.evaluate(() => [".rb-stage", ".rb-transport"].map((part) => document.querySelector(part).getBoundingClientRect()));
    assert.deepEqual([boxes[0].top, boxes[0].width, boxes[0].bottom, boxes[1].bottom], [0, 1280, boxes[1].top, 720]);
    assert.deepEqual(await violations(page), []);
    await page.screenshot({path: path.join(kOutput, `full-${name}.png`)});
    await page.keyboard.press("Escape");
    await isFull(page, false);
    assert.ok(await page.locator(".rb-numbers").first().isVisible());
    await page.locator(".rb-picture").focus();
    await page.keyboard.press("f");
    await isFull(page, true);
    await page.keyboard.press("x");
    await page.waitForFunction(() => rotatebook.player.outcome.spin?.axis === "middle");
    await page.keyboard.press("f");
    await isFull(page, false);
    assert.deepEqual(problems, []);
    await close();
  });
}

test("the key is the player's only while it has the focus, and there is no button where the browser has no full screen", async () => {
  const {page, close} = await open();
  await page.keyboard.press("f");
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => document.fullscreenElement), null);
  await close();
  const without = await open({}, {script: () => Object.defineProperty(Document.prototype, "fullscreenEnabled", {value: false})});
  assert.ok(await without.page.locator("[data-do=full]").isHidden());
  await without.close();
});

/** Sizes of what is drawn and written in full screen. */
async function sizesAt(width, height) {
  const {page, close} = await open({viewport: {width, height}});
  await page.locator("input[name=rb-frame][value=turning]").check();
  await page.locator("[data-do=full]").click();
  await isFull(page, true);
  const sizes = await page.evaluate(() => {
    const {player} = rotatebook;
    player.seek(0);
    player.tick(performance.now());
    player.drawing.draw(0, player);
    const {data} = player.drawing.lines.getContext("2d").getImageData(0, 0, player.drawing.lines.width, player.drawing.lines.height);
    let ink = 0;
    for (let at = 3; at < data.length; at += 4) ink += data[at] / 255;
    const sizeOf = (selector) => parseFloat(getComputedStyle(document.querySelector(selector)).fontSize);
    const heightOf = (selector) => document.querySelector(selector).getBoundingClientRect().height;
    return {ink: Math.sqrt(ink), letters: sizeOf(".rb-time"), buttons: sizeOf(".rb-throws span"), picture: heightOf(".rb-stage"), ball: heightOf(".rb-ball"),
      timeline: heightOf(".rb-timeline"), button: heightOf(".rb-play")};
  });
  await page.screenshot({path: path.join(kOutput, `full-${height}.png`)});
  await close();
  return sizes;
}

test("letters and lines are in proportion to the screen's height", async () => {
  const small = await sizesAt(1280, 720), large = await sizesAt(1920, 1080);
  const ratios = Object.fromEntries(Object.entries(large).map(([name, size]) => [name, size / small[name]]));
  console.log(`1080 to 720: ${JSON.stringify(ratios)}`);
  for (const [name, ratio] of Object.entries(ratios)) assert.ok(Math.abs(ratio - 1.5) < 0.015, `${name}: ${ratio}`);  // Measured 1.495 to 1.5.
});

const luminance = (colour) => [0.2126, 0.7152, 0.0722].reduce((sum, share, i) => {
  const part = colour[i] / 255;
  return sum + share * (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
}, 0);
const contrast = (a, b) => (Math.max(luminance(a), luminance(b)) + 0.05) / (Math.min(luminance(a), luminance(b)) + 0.05);

test("the light look: a light wall, and dark lines and letters", async () => {
  const {page, problems, close} = await open({viewport: {width: 1280, height: 800}});
  const light = page.getByRole("button", {name: "Light, for weak projectors"});
  const pictureOf = () => page.evaluate(() => {
    const {player} = rotatebook, {picture} = player.drawing, copy = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
    player.drawing.draw(player.frame, player);
    Object.assign(copy.canvas, {width: picture.width, height: picture.height});
    copy.drawImage(picture, 0, 0);
    // The wall: at the corners, and near the middle, where it is brightest in the dark.
    const places = [[0.01, 0.01], [0.99, 0.99], [0.35, 0.5], [0.65, 0.3]];
    const pixels = copy.getImageData(0, 0, picture.width, picture.height).data;
    window.firstPixels ??= pixels;
    // How far it is from the first one: a rasteriser that makes its code better as it runs rounds otherwise then.
    const change = pixels.reduce((most, part, i) => Math.max(most, Math.abs(part - firstPixels[i])), 0);
    return {change, wall: places.map(([x, y]) => [...copy.getImageData(x * picture.width, y * picture.height, 1, 1).data])};
  });
  const dark = await pictureOf();
  await light.click();
  assert.equal(await light.getAttribute("aria-pressed"), "true");
  const bright = await pictureOf();
  assert.ok(bright.change > 100, `${bright.change}`);
  const colours = playerScripts(["arrows", "record", "core", "live_scene", "polhode_ball", "timeline"], ["kColours", "kBookColours"]);
  const inks = Object.values(colours.kColours).flat().filter((colour) => colour.startsWith("#")).concat(colours.kBookColours);
  const seen = await page.evaluate((all) => {
    const context = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
    context.filter = getComputedStyle(document.querySelector(".rb-lines")).filter;
    return all.map((colour) => {
      context.fillStyle = colour;
      context.fillRect(0, 0, 4, 4);
      return [...context.getImageData(1, 1, 1, 1).data];
    });
  }, inks);
  const least = seen.map((ink) => Math.min(...bright.wall.map((wall) => contrast(ink, wall))));
  console.log(`contrast on the light wall: ${inks.map((ink, i) => `${ink} ${least[i].toFixed(2)}`).join(", ")}; wall ${bright.wall.map((wall) => wall[0])}`);
  assert.ok(Math.min(...least) >= 4.5);  // Measured 4.53, of the axis x.
  assert.ok(bright.wall.every((wall) => luminance(wall) > 0.7) && dark.wall.every((wall) => luminance(wall) < 0.1));
  await page.locator("[data-do=tour]").click();
  assert.deepEqual(await violations(page), []);
  await page.getByRole("button", {name: "Leave the tour"}).click();
  await page.locator(".rb-more summary").click();
  await page.locator("input[name=rb-books][value=same]").check();
  await page.getByRole("button", {name: "why"}).click();
  assert.deepEqual(await violations(page), []);
  await page.screenshot({path: path.join(kOutput, "light.png"), fullPage: true});
  await page.locator("[data-do=reset]").click();
  await light.click();
  await page.waitForFunction(() => !rotatebook.player.isWaiting);
  assert.ok((await pictureOf()).change <= 1);
  assert.deepEqual(problems, []);
  await close();
});
