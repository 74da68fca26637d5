// Why the book turns over: frames of reference, forces, energies, Poinsot's construction, and slowly.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before, after} = require("node:test");
const {kRoot, kOutput, testOnce, startBrowser, closeBrowser, open, playerScripts, frameOf, sceneOf, messageOf, load} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

const kOnItsWay = 150;  // A frame in which the opening book turns over.

/** Opens the page, with the book on its way. */
async function opened() {
  const live = await open({viewport: {width: 1024, height: 768}});
  await live.page.evaluate((frame) => rotatebook.player.seek(frame), kOnItsWay);
  await live.page.waitForFunction((frame) => rotatebook.player.frame === frame && !rotatebook.player.isDirty, kOnItsWay);
  const picture = (name) => live.page.evaluate((selector) => {
    const {player} = rotatebook;
    player.drawing.draw(player.frame, player);
    return document.querySelector(selector).toDataURL();
  }, name);
  return {...live, picture, see: (frame) => live.page.locator(`input[name=rb-frame][value=${frame}]`).check()};
}

const legendOf = (page) => page.locator(".rb-legend li").allTextContents();

test("the same motion is seen from the room, with the book, and turning", async () => {
  const {page, problems, close, picture, see} = await opened();
  const seen = new Map([["world", await picture(".rb-picture")]]);
  const simulated = await page.evaluate(() => rotatebook.player.simulated);
  for (const frame of ["body", "turning"]) {
    await see(frame);
    assert.equal((await sceneOf(page)).camera.frame, frame);
    assert.equal(await frameOf(page), kOnItsWay);
    assert.ok(await page.evaluate(() => rotatebook.player.simulated) >= simulated, "all that is simulated stays");
    seen.set(frame, await picture(".rb-picture"));
  }
  assert.equal(new Set(seen.values()).size, 3);
  const attitude = await page.evaluate(() => {
    rotatebook.player.setFrame("body");
    return rotatebook.player.core.sample(0, 0, 150)[1];
  });
  assert.ok(Math.abs(attitude - 1) < 1e-12, "it rests");
  assert.ok(await page.locator("input[name=rb-frame][value=momentum]").isHidden());
  await load(page, 'title = "t"\n[initial]\nangular_velocity = [4, 0, 0.1]\n[camera]\nframe = "momentum"\n');
  assert.ok(await page.locator("label:has(> input[name=rb-frame][value=momentum])").isVisible(), "a scene's own frame is named");
  assert.deepEqual(problems, []);
  await close();
});

test("why shows forces, with a legend, and the ladder", async () => {
  const {page, problems, close, picture, see} = await opened();
  const why = page.getByRole("button", {name: "why"}), before = await picture(".rb-lines");
  await why.click();
  await page.locator(".rb-legend").waitFor();
  assert.equal(await why.getAttribute("aria-pressed"), "true");
  const scene = await sceneOf(page);
  assert.ok(["forces", "energy_ladder"].every((overlay) => scene.overlay.show.includes(overlay)));
  assert.equal(scene.camera.frame, "turning", "in the room there are no such forces");
  assert.match((await legendOf(page)).join("; "), /^held by the body; centrifugal force; Coriolis force; [\d.]+ N\/kg$/);
  await see("body");
  await page.waitForFunction(() => /Euler force/.test(document.querySelector(".rb-legend").textContent));
  assert.match((await legendOf(page)).join("; "), /^held by the body; centrifugal force; Euler force; [\d.]+ N\/kg$/);
  const withForces = await picture(".rb-lines");
  assert.notEqual(withForces, before);
  assert.ok(await page.locator(".rb-ladder").isVisible());
  assert.ok(await page.locator(".rb-hint").isHidden(), "it would lie on the arrows");
  await page.screenshot({path: path.join(kOutput, "why.png")});
  await see("turning");
  await why.click();
  assert.equal(await why.getAttribute("aria-pressed"), "false");
  assert.equal((await sceneOf(page)).camera.frame, "world", "as it was before");
  await page.locator(".rb-legend").waitFor({state: "hidden"});
  assert.equal(await picture(".rb-lines"), before);
  assert.deepEqual(problems, []);
  await close();
});

testOnce("why of several books covers none of them, nor their names; above six it has no legend and no ladder", async () => {
  const {page, problems, close} = await open();
  const many = fs.readFileSync(path.join(kRoot, "scenes/comparisons/ninety-six.toml"), "utf8");
  const panels = (count) => Array.from({length: count}, (_, i) => `[[panel]]\nlabel = "y: the smallest moment ${i}"\ninitial.angular_velocity = [4, 0, ${i}]\n`).join("");
  for (const [width, height] of [[1366, 768], [700, 768], [390, 844]]) {
    await page.setViewportSize({width, height});
    for (const count of [2, 3, 6, 96]) {
      await load(page, count > 6 ? many : `title = "t"\nsimulation.model = "exact"\n${panels(count)}`);
      assert.equal(await page.evaluate(() => rotatebook.player.labels.length), count);
      await page.evaluate(() => rotatebook.player.toggleWhy());
      await page.waitForFunction(() => !rotatebook.player.isDirty && !rotatebook.player.isWaiting);
      const seen = await page.evaluate(() => {
        const boxOf = (selector) => document.querySelector(selector).getBoundingClientRect(), {bottom} = boxOf(".rb-stage");
        const parts = [".rb-ladder", ".rb-legend", ".rb-hint"].filter((part) => boxOf(part).height > 0);
        const names = [...document.querySelectorAll(".rb-labels span")].map(({offsetHeight}) => offsetHeight);
        return {parts, over: parts.filter((part) => boxOf(part).top < bottom || boxOf(part).bottom > boxOf(".rb-transport").top), names,
          line: boxOf(".rb-timeline").bottom < innerHeight};
      });
      const isMany = count > 6;
      assert.deepEqual({...seen, names: seen.names.filter((name) => name > 24)}, {parts: isMany ? [] : [".rb-ladder", ".rb-legend"], over: [], names: [], line: true},
        `${count} at ${width}`);
      assert.equal(seen.names.length, isMany ? 0 : count);
      if (count !== 2) await page.screenshot({path: path.join(kOutput, `why-${count}-${width}.png`)});
    }
  }
  assert.deepEqual(problems, []);
  await close();
});

// The legend's bar is as long as an arrow of that force at the book's middle, across the view.
test("forces are to the legend's scale", async () => {
  const {page, close} = await opened();
  await page.getByRole("button", {name: "why"}).click();
  await page.locator(".rb-bar").waitFor();
  const {bar, wanted} = await page.evaluate(() => {
    const {player} = rotatebook, {longest} = player.core.forces(0, 0, player.frame);
    const stated = parseFloat(document.querySelector(".rb-legend li:last-child").textContent);
    const reach = Math.hypot(...player.read.motions[0].body) / 2;
    return {bar: document.querySelector(".rb-bar").getBoundingClientRect().width, wanted: stated / longest * 0.65 * reach * player.drawing.pixelsOfMetre(0)};
  });
  assert.ok(bar > 20 && Math.abs(bar - wanted) < 1, `${bar} for ${wanted}`);
  await close();
});

test("Poinsot's construction is drawn, of rigid books", async () => {
  const {page, problems, close, picture} = await opened();
  await page.locator(".rb-more > summary").click();
  const before = await picture(".rb-lines");
  await page.getByLabel("Poinsot’s construction").check();
  assert.notEqual(await picture(".rb-lines"), before);
  await page.locator(".rb-stage").screenshot({path: path.join(kOutput, "poinsot.png")});
  await page.getByLabel("Poinsot’s construction").uncheck();
  await page.locator("input[name=rb-model][value=particles]").check();
  assert.ok(await page.getByLabel("Poinsot’s construction").isHidden());
  assert.equal(await messageOf(page), "");
  assert.deepEqual(problems, []);
  await close();
});

test("what the book hides of Poinsot's construction is faint", async () => {
  const {hidingBody} = playerScripts(["core", "arrows", "poinsot"], ["hidingBody"]);
  const sample = new Float64Array(45), half = [0.1, 0.2, 0.02];
  for (let i = 0; i < 8; ++i) sample.set(half.map((side, axis) => 1 + ((i >> axis) & 1 ? side : -side)), 21 + 3 * i);
  const hides = hidingBody(sample, new Float32Array([1, 1, 3]));
  const hidden = [[1, 1, 0], [1, 1, 1], [1.09, 1.19, 1]], seen = [[1, 1, 1.5], [1, 1, 4], [1.2, 1, 0.9], [1.09, 1.23, 1]];
  assert.deepEqual([hidden, seen].map((points) => points.map(hides)), [[true, true, true], [false, false, false, false]]);
  // In the page, a book in front of it leaves less of its colours.
  const {page, close} = await opened();
  const pieces = await page.evaluate(() => {
    const {player} = rotatebook, counts = {}, drawing = CanvasRenderingContext2D.prototype, {beginPath, lineTo, stroke} = drawing;
    let count = 0;
    drawing.beginPath = function() { count = 0; beginPath.call(this); };
    drawing.lineTo = function(x, y) { count += 1; lineTo.call(this, x, y); };
    drawing.stroke = function() { counts[this.globalAlpha.toFixed(2)] = (counts[this.globalAlpha.toFixed(2)] ?? 0) + count; stroke.call(this); };
    player.see(player.scene.withShown("poinsot", true));
    player.drawing.draw(player.frame, player);
    Object.assign(drawing, {beginPath, lineTo, stroke});
    return counts;
  });
  // Of the plane's edge, whose opacity is 0.8, and of the trails, 0.9. Measured 8 and 17, none where the body hides nothing.
  assert.ok(pieces["0.24"] >= 5 && pieces["0.27"] >= 10, JSON.stringify(pieces));
  await close();
});

test("slowly while it turns over, and only then", async () => {
  const {page, close} = await opened();
  await page.locator(".rb-speed select").selectOption("flips");
  const speedAt = (frame) => page.evaluate((at) => {
    rotatebook.player.seek(at);
    rotatebook.player.tick(performance.now());
    return rotatebook.player.clock.speed;
  }, frame);
  await page.waitForFunction(() => rotatebook.player.isComplete);
  assert.deepEqual([await speedAt(10), await speedAt(kOnItsWay)], [1, 0.25]);  // Tilts of 1 and 108 degrees.
  await page.locator(".rb-speed select").selectOption("1");
  assert.equal(await speedAt(kOnItsWay), 1);
  // A book that is always tilted, and never turns over.
  await load(page, 'title = "t"\nsimulation.model = "exact"\n[initial]\nangular_velocity = [0, 4, 3]\n');
  await page.locator(".rb-speed select").selectOption("flips");
  await page.waitForFunction(() => rotatebook.player.isComplete);
  assert.equal(await speedAt(100), 1);
  await close();
});
