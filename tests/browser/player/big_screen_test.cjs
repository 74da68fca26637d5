// The big screen: full screen, in proportion at any height; and the light look.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before, after} = require("node:test");
const {kRoot, kOutput, kPlayed, testOnce, startBrowser, closeBrowser, open, load, violations, playerScripts} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

const isFull = (page, wanted) => page.waitForFunction((on) => (document.fullscreenElement !== null) === on && document.querySelector(".rb-bare") !== null === on, wanted);

test("full screen by button and by key", async () => {
  const {page, problems, close} = await open({viewport: {width: 1280, height: 720}});
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
  await page.screenshot({path: path.join(kOutput, `full-${kPlayed}.png`)});
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

testOnce("the key is the player's only while it has the focus, and there is no button where the browser has no full screen", async () => {
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

/** How unlike two colours look, each [red, green, blue], as a distance in Oklab. */
function unlikeness(...colours) {
  const [a, b] = colours.map((colour) => {
    const [red, green, blue] = colour.map((part) => (part <= 10.31 ? part / 255 / 12.92 : ((part / 255 + 0.055) / 1.055) ** 2.4));
    const [l, m, s] = [[0.4122, 0.5363, 0.0514], [0.2119, 0.6807, 0.1074], [0.0883, 0.2817, 0.63]].map((row) => Math.cbrt(row[0] * red + row[1] * green + row[2] * blue));
    return [0.2105 * l + 0.7936 * m - 0.0041 * s, 1.978 * l - 2.4286 * m + 0.4506 * s, 0.0259 * l + 0.7828 * m - 0.8087 * s];
  });
  return Math.hypot(...a.map((part, i) => part - b[i]));
}

const partsOf = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));

/** The colours that a list's marks have, of those that `selector` finds. */
const marksOf = (page, selector) => page.locator(selector).evaluateAll((marks) => marks.map((mark) => {
  const {backgroundColor, backgroundImage} = getComputedStyle(mark);
  return (/rgb\((.*?)\)/.exec(backgroundImage === "none" ? backgroundColor : backgroundImage))[1].split(", ").map(Number);
}));

/** Of colours, whether a canvas has at least 20 pixels just as they are. */
const areDrawn = (page, selector, colours) => page.evaluate(([name, all]) => {
  const canvas = document.querySelector(name), {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  return all.map((colour) => {
    let count = 0;
    for (let at = 0; at < data.length; at += 4) count += data[at + 3] > 250 && colour.every((part, i) => Math.abs(part - data[at + i]) <= 2);
    return count >= 20;
  });
}, [selector, colours]);

test("in the light look each line has the colour that its legend says, unlike the others", async () => {
  const {page, problems, close} = await open({viewport: {width: 1280, height: 800}});
  await page.getByRole("button", {name: "why"}).click();
  for (const isLight of [false, true]) {
    if (isLight) await page.locator("[data-do=light]").click();
    await page.evaluate(() => rotatebook.player.seek(150));
    await page.waitForFunction(() => rotatebook.player.frame === 150 && !rotatebook.player.isDirty);
    const names = await marksOf(page, ".rb-names li:not([hidden]) i:not(.rb-tick)"), forces = await marksOf(page, ".rb-swatch");
    assert.deepEqual(await areDrawn(page, ".rb-lines", [...names.slice(0, 2), ...forces]), [true, true, true, true, true]);
    assert.deepEqual(await areDrawn(page, ".rb-timeline canvas", [names[2]]), [true]);
    const apart = [names, forces].map((list) => Math.min(...list.flatMap((a, i) => list.slice(i + 1).map((b) => unlikeness(a, b)))));
    console.log(`${isLight ? "light" : "dark"}: colours of lines at least ${apart[0].toFixed(3)} apart, of forces ${apart[1].toFixed(3)}`);
    assert.ok(Math.min(...apart) > 0.15);  // Measured 0.155 to 0.274.
    const filters = await page.locator(":is(.rb-lines, .rb-timeline canvas, .rb-names i, .rb-swatch)").evaluateAll((all) => all.map((one) => getComputedStyle(one).filter));
    assert.deepEqual([...new Set(filters)], ["none"], "that is what is seen");
  }
  // The page around is as light as the picture.
  assert.ok(luminance(await page.evaluate(() => [document.documentElement, document.body].map((element) => getComputedStyle(element).backgroundColor)
    .find((colour) => colour !== "rgba(0, 0, 0, 0)").match(/\d+/g).map(Number))) > 0.7);
  assert.deepEqual(problems, []);
  await close();
});

testOnce("the legend has the colours of the books' curves, one above six; and these have no hint over them", async () => {
  const {page, problems, close} = await open({viewport: {width: 1366, height: 768}});
  const three = `title = "t"\nsimulation.model = "exact"\n${[0.5, 1, 2].map((speed) => `[[panel]]\nlabel = "${speed}"\ninitial.angular_velocity = [4, 0, ${speed}]\n`).join("")}`;
  const many = fs.readFileSync(path.join(kRoot, "scenes/comparisons/ninety-six.toml"), "utf8");
  const coloursOf = () => page.locator(".rb-names li:not([data-of]) i").first().evaluate((mark) =>
    [...new Set(getComputedStyle(mark).backgroundImage.match(/rgb\(.*?\)/g))].map((colour) => colour.match(/\d+/g).map(Number)));
  for (const [text, count, curves] of [[three, 3, 3], [many, 96, 1]]) {
    await load(page, text);
    assert.equal(await page.evaluate(() => rotatebook.player.labels.length), count);
    await page.waitForFunction(() => rotatebook.player.isComplete && !rotatebook.player.isDirty);
    await page.evaluate(() => rotatebook.player.tick(performance.now()));
    const colours = await coloursOf();
    assert.deepEqual([colours.length, await areDrawn(page, ".rb-timeline canvas", colours)], [curves, Array(curves).fill(true)]);
    assert.equal(await page.locator(".rb-hint").isVisible(), count <= 6);
    // None of another book's colours.
    assert.deepEqual(await areDrawn(page, ".rb-timeline canvas", [partsOf("#dba3da"), partsOf("#e899d9")]), [false, false]);
    await page.screenshot({path: path.join(kOutput, `books-${count}.png`)});
  }
  assert.deepEqual(problems, []);
  await close();
});

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
  const {kColours, kBookColours, kForces, inkOf} = playerScripts(["arrows", "record", "core", "live_scene", "polhode_ball", "timeline", "forces"],
    ["kColours", "kBookColours", "kForces", "inkOf"]);
  const inks = [...Object.values(kColours).flat().filter((colour) => colour.startsWith("#")), ...kBookColours, ...kForces.map(({colour}) => colour)]
    .map((colour) => inkOf(colour, true));
  const least = inks.map((ink) => Math.min(...bright.wall.map((wall) => contrast(partsOf(ink), wall))));
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
