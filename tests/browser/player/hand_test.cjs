// Throwing the book, turning the view, the ball: with a mouse and with fingers.
"use strict";

const assert = require("node:assert/strict");
const {test, before, after} = require("node:test");
const {startBrowser, closeBrowser, open, frameOf, sceneOf} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

async function stageOf(page) {
  const box = await page.locator(".rb-stage").boundingBox();
  return {middle: [box.x + box.width / 2, box.y + box.height / 2], corner: [box.x + 20, box.y + 20]};
}

async function drag(page, [x, y], [dx, dy]) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 5; ++i) await page.mouse.move(x + dx * i / 5, y + dy * i / 5);
  await page.mouse.up();
}

/** A drag all at once: a slow machine's answers must not hold the hand still. */
async function flick(page, [x, y], [dx, dy]) {
  await page.mouse.move(x, y);
  const events = [page.mouse.down()];
  for (let i = 1; i <= 5; ++i) events.push(page.mouse.move(x + dx * i / 5, y + dy * i / 5));
  await Promise.all([...events, page.mouse.up()]);
}

test("a flick on the book adds to its spin at that time", async () => {
  const {page, close} = await open();
  await page.evaluate(() => rotatebook.player.step(60));
  await page.waitForFunction(() => rotatebook.player.frame === 60);
  const {middle} = await stageOf(page);
  await flick(page, middle, [120, 0]);
  const [nudge] = (await sceneOf(page)).nudge;
  assert.ok(Math.abs(nudge.at - 1) < 1e-6, String(nudge.at));
  assert.equal(nudge.axes, "world");
  // To the right: about what is up in the picture.
  const [x, y, z] = nudge.angular_velocity;
  assert.ok(y > 2 * Math.hypot(x, z), String(nudge.angular_velocity));  // Measured 3.6; how large depends on the machine's haste.
  const spin = await page.evaluate(() => {
    const at = (frame) => [...rotatebook.player.core.sample(0, 0, frame).subarray(5, 8)];
    return {before: at(59), after: at(61)};
  });
  assert.ok(spin.after[1] - spin.before[1] > 0.3 * nudge.angular_velocity[1], JSON.stringify(spin));
  await close();
});

test("a hand that holds still before it lets go doesn't throw", async () => {
  const {page, close} = await open();
  const {middle: [x, y]} = await stageOf(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 80, y);
  await page.waitForTimeout(600);
  await page.mouse.up();
  assert.equal((await sceneOf(page)).nudge, undefined);
  await close();
});

test("a throw in the past takes the place of later ones", async () => {
  const {page, close} = await open();
  await page.locator(".rb-lines").focus();
  for (const frame of [30, 90, 60]) {
    await page.evaluate((to) => rotatebook.player.seek(to), frame);
    await page.keyboard.press("Shift+ArrowRight");
    await page.keyboard.press("Space");
  }
  assert.deepEqual((await sceneOf(page)).nudge.map(({at}) => Math.round(60 * at)), [30, 60]);
  await close();
});

test("beside the book a drag turns the view, and the motion stays", async () => {
  const {page, close} = await open();
  const before = await sceneOf(page), {corner} = await stageOf(page);
  await drag(page, corner, [80, 30]);
  const orbit = await page.evaluate(() => rotatebook.player.orbit);
  assert.ok(orbit.right < -0.2 && orbit.up > 0.1, JSON.stringify(orbit));
  assert.deepEqual(await sceneOf(page), before);
  const shared = await page.evaluate(() => rotatebook.player.core.treeOf(rotatebook.player.sharedText()));
  assert.equal(shared.camera.position.length, 3);
  await close();
});

test("a click plays and pauses; jiggle adds a small nudge", async () => {
  const {page, close} = await open();
  await page.locator(".rb-lines").click();
  await page.waitForFunction(() => rotatebook.player.frame > 10);
  await page.locator(".rb-lines").click();
  const frame = await frameOf(page);
  await page.locator("[data-do=jiggle]").click();
  const {nudge} = await sceneOf(page);
  assert.equal(nudge.length, 1);
  const size = Math.hypot(...nudge[0].angular_velocity);
  assert.ok(size > 0.3 && size < 1, `${size} at ${frame}`);
  await close();
});

/** The direction of L at the start, in the book's axes, which are the world's then. */
const momentumOf = (page) => page.evaluate(() => {
  const momentum = [...rotatebook.player.core.sample(0, 0, 0).subarray(8, 11)];
  return momentum.map((part) => part / Math.hypot(...momentum));
});

test("a click on the ball chooses the start", async () => {
  const {page, close} = await open();
  const box = await page.locator(".rb-ball").boundingBox();
  await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  const velocity = (await sceneOf(page)).initial.angular_velocity;
  // The middle of the ball looks along (0.48, 0.41, 0.78) in the book's axes.
  const sample = await momentumOf(page);
  assert.equal(velocity.length, 3);
  assert.ok(sample.every((part, axis) => Math.abs(part - [0.477, 0.408, 0.778][axis]) < 0.02), String(sample));
  await page.locator(".rb-ball").focus();
  await page.keyboard.press("ArrowUp");
  const up = await momentumOf(page);
  assert.ok(up[1] > sample[1] + 0.03, `${up} after ${sample}`);
  await close();
});

test("fingers throw, turn and draw near", async () => {
  const {page, close} = await open({viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true});
  const {middle, corner} = await stageOf(page), client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send("Input.dispatchTouchEvent", {type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
  const flick = [touch("touchStart", middle)];
  for (let i = 1; i <= 4; ++i) flick.push(touch("touchMove", [middle[0], middle[1] - 15 * i]));
  await Promise.all([...flick, touch("touchEnd")]);
  const [nudge] = (await sceneOf(page)).nudge;
  const [x, y, z] = nudge.angular_velocity;
  assert.ok(x < -2 * Math.hypot(y, z), String(nudge.angular_velocity));  // Measured 2.4 times.
  await touch("touchStart", corner);
  for (let i = 1; i <= 4; ++i) await touch("touchMove", [corner[0] + 15 * i, corner[1]]);
  await touch("touchEnd");
  assert.ok(await page.evaluate(() => rotatebook.player.orbit.right) < -0.1);
  await touch("touchStart", [middle[0] - 40, middle[1]], [middle[0] + 40, middle[1]]);
  await touch("touchMove", [middle[0] - 80, middle[1]], [middle[0] + 80, middle[1]]);
  await touch("touchEnd");
  assert.ok(await page.evaluate(() => rotatebook.player.orbit.distance) < 0.7);
  assert.equal((await sceneOf(page)).nudge.length, 1);
  await close();
});
