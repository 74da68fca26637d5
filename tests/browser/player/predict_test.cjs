// Predict, then see: what is called right must happen.
"use strict";

const assert = require("node:assert/strict");
const {test, before, after} = require("node:test");
const {startBrowser, closeBrowser, open, frameOf, sceneOf} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

/** Times at which the books turned over, of each. [s] */
const turnsOf = (page) => page.evaluate(async () => {
  const player = rotatebook.player;
  while (!player.isComplete || player.checksum === null) await new Promise((resolve) => { setTimeout(resolve, 20); });
  return player.read.motions.map((motion, i) => player.timeline.events.filter((event) => event.motion === i).map(({frame}) => player.timeOf(frame)));
});

test("three tasks, each answered by its motion", async () => {
  const {page, problems, close} = await open();
  await page.locator("[data-do=predict]").click();
  const text = () => page.locator(".rb-question-text").textContent();
  const see = async (answer, pattern) => {
    assert.equal(await frameOf(page), 0);
    await page.locator(".rb-answers button").nth(answer).click();
    await page.locator(".rb-speed select").selectOption("8");
    await page.waitForFunction((source) => new RegExp(source).test(document.querySelector(".rb-question-text").textContent), pattern.source);
  };

  assert.match(await text(), /Which of these will tumble/);
  const [y, x, z] = await turnsOf(page);
  assert.deepEqual([y.length, z.length], [0, 0]);
  assert.ok(x.length >= 2 && x[0] < 4, String(x));
  await see(0, /^Not quite\. The one about x/);

  await page.getByText("Next question").click();
  const [large, small] = await turnsOf(page);
  console.log(`a tilt ten times smaller: ${large[0]} s, then ${small[0]} s`);
  assert.ok(large[0] > 1.5 && large[0] < 3, String(large));
  const later = small[0] - large[0];
  assert.ok(later > 0.7 && later < 1.7, String(small));
  await see(1, /^Right\. A second later/);

  await page.getByText("Next question").click();
  const [short, long] = await turnsOf(page);
  console.log(`steps: ${short} s; ten times longer: ${long} s`);
  assert.ok(long.length > 0 && short.length > 0);
  assert.ok(short.some((time, i) => long[i] === undefined || Math.abs(time - long[i]) > 0.5), `${short}; ${long}`);
  await see(2, /^Not quite\. At other times/);
  assert.deepEqual(problems, []);
  await close();
});

test("the books of a question are at their places as soon as they are seen", async () => {
  const {page, close} = await open();
  const [first, last] = await page.evaluate(async () => {
    const {drawing} = rotatebook.player, draw = drawing.draw.bind(drawing), places = [];
    drawing.draw = (...what) => {
      draw(...what);
      places.push(JSON.stringify(drawing.books.map(({area}) => area)));
    };
    document.querySelector("[data-do=predict]").click();
    await new Promise((resolve) => { setTimeout(resolve, 500); });
    return [places.find((areas) => JSON.parse(areas).length === 3), places.at(-1)];
  });
  assert.equal(first, last);
  await close();
});

test("a click on a cover is an answer", async () => {
  const {page, close} = await open();
  await page.locator("[data-do=predict]").click();
  await page.waitForFunction(() => rotatebook.player.drawing.books.length === 3);
  // The middle of the second book's part of the picture; three parts meet in the picture's middle where they are in two rows.
  const [x, y] = await page.evaluate(() => {
    const {books: [, {area}], picture} = rotatebook.player.drawing, factor = picture.clientWidth / picture.width;
    return [(area.x + area.width / 2) * factor, (area.y + area.height / 2) * factor];
  });
  const box = await page.locator(".rb-stage").boundingBox();
  await page.mouse.click(box.x + x, box.y + y);
  await page.waitForFunction(() => /You said: about x/.test(document.querySelector(".rb-question-text").textContent));
  await page.waitForFunction(() => rotatebook.player.frame > 5);
  await page.locator(".rb-close").click();
  await page.locator(".rb-question").waitFor({state: "hidden"});
  assert.deepEqual((await sceneOf(page)).initial, {angular_velocity: [4, 0, 0], tilt: [0.014, "z"]}, "the book of before comes back");
  await close();
});
