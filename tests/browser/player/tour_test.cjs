// The tour: six steps, each done as it asks, by mouse and by keyboard; links, and the way out.
"use strict";

const assert = require("node:assert/strict");
const {test, before, after} = require("node:test");
const {testOnce, startBrowser, closeBrowser, open, violations, checksumOf, frameOf, sceneOf, messageOf} = require("./live_page.cjs");

const kSteps = 6;

before(() => startBrowser());
after(closeBrowser);

const lineOf = (page) => page.locator(".rb-step").textContent();
const nextOf = (page) => page.locator(".rb-next");
const hashOf = (page) => page.evaluate(() => location.hash);

async function waitForStep(page, step) {
  await page.waitForFunction((wanted) => document.querySelector(".rb-step").textContent.startsWith(wanted), `Tour, step ${step} of ${kSteps}: `);
  assert.equal(await hashOf(page), `#tour=${step}`);
  assert.equal(await page.evaluate(() => document.activeElement.className), "rb-question-text", "it is read");
}

const waitUntilDone = (page) => page.waitForFunction(() => !document.querySelector(".rb-next").disabled);

const thrownAbout = (page, axis) => page.locator(`.rb-throws [data-axis=${axis}]`);

/** Presses Tab, or Shift and Tab, until an element has the focus. */
async function tabTo(page, selector, key = "Tab") {
  for (let i = 0; i < 40; ++i) {
    if (await page.evaluate((wanted) => document.activeElement.matches(wanted), selector)) return;
    await page.keyboard.press(key);
  }
  assert.fail(`${selector} isn't reached`);
}

const press = async (page, selector, key = "Enter", way = "Tab") => {
  await tabTo(page, selector, way);
  await page.keyboard.press(key);
};

/** What each step asks for. */
const kWays = {
  mouse: {
    next: (page) => nextOf(page).click(),
    acts: [(page) => page.locator(".rb-answers button").nth(1).click(), (page) => thrownAbout(page, "x").click(),
      (page) => page.locator("input[name=rb-frame][value=body]").check(), (page) => page.getByRole("button", {name: "why", exact: true}).click(),
      (page) => thrownAbout(page, "z").click(), (page) => thrownAbout(page, "y").click()],
  },
  keyboard: {
    next: (page) => press(page, ".rb-next"),
    acts: [(page) => press(page, ".rb-answers button:nth-child(2)"), (page) => page.keyboard.press("x"),
      (page) => press(page, "input[name=rb-frame]:checked", "ArrowRight", "Shift+Tab"), (page) => press(page, "[data-do=why]", "Enter", "Shift+Tab"),
      (page) => page.keyboard.press("z"), (page) => page.keyboard.press("y")],
  },
};

const kShownInstead = "Shown instead: A book thrown about its middle axis.";
const notAStep = (part) => `“${part}” in this link is no step of the tour, from #tour=1 to #tour=6; in a frame, #embed&tour=1. ${kShownInstead}`;

for (const [device, {next, acts}] of Object.entries(kWays)) {
  test(`six steps by ${device}`, async () => {
    const {page, problems, close} = await open({viewport: {width: 1024, height: 768}});
    await page.locator(".rb-speed select").selectOption("8");
    await page.evaluate(() => {
      window.told = [];
      const region = document.querySelector(".rb-events");
      new MutationObserver(() => told.push(region.textContent)).observe(region, {childList: true, characterData: true, subtree: true});
    });
    if (device === "mouse") await page.locator("[data-do=tour]").click();
    else await press(page, "[data-do=tour]");
    for (let step = 1; step <= kSteps; ++step) {
      await waitForStep(page, step);
      assert.ok(await nextOf(page).isDisabled(), "something is to be done");
      await page.waitForTimeout(200);
      assert.ok(await nextOf(page).isDisabled(), "and it is not done by waiting");
      await acts[step - 1](page);
      await waitUntilDone(page);
      if (device === "mouse") assert.deepEqual(await violations(page), []);
      await next(page);
    }
    await page.locator(".rb-question").waitFor({state: "hidden"});
    assert.equal(await hashOf(page), "");
    assert.equal((await sceneOf(page)).initial.angular_velocity[1], 4, "one's own book stays");
    assert.ok((await page.evaluate(() => told)).includes("Done. Go on: “Next”."));
    assert.deepEqual([problems, await messageOf(page)], [[], ""]);
    await close();
  });
}

test("a link opens a step, and the ways back", async () => {
  const {page, problems, close} = await open({}, {hash: "#tour=3"});
  const titleOf = async () => (await sceneOf(page)).title;
  await waitForStep(page, 3);
  assert.equal(await titleOf(), "Ride with it");
  await page.evaluate(() => { location.hash = "#tour=5"; });
  await waitForStep(page, 5);
  assert.equal(await titleOf(), "Why not the others");
  await page.goBack();
  await waitForStep(page, 3);
  await page.locator("[data-do=reset]").click();
  await waitForStep(page, 3);
  await page.evaluate(() => { location.hash = "#elsewhere"; });
  await page.locator(".rb-question").waitFor({state: "hidden"});
  assert.equal(await titleOf(), "A book thrown about its middle axis");
  await page.evaluate(() => { location.hash = "#tour=3"; });
  await waitForStep(page, 3);
  await page.evaluate(() => { location.hash = "#tour=7"; });
  await page.locator(".rb-question").waitFor({state: "hidden"});
  assert.equal(await page.locator(".rb-said").textContent(), notAStep("#tour=7"));
  assert.equal(await hashOf(page), "");
  assert.deepEqual(problems, []);
  await close();
});

for (const hash of ["#tour=0", "#tour=abc", "#tour=2&embed", "#embed#tour=3", "#embed&tour=9", "#play=x", "#embed&play=x"]) {
  testOnce(`a broken link, ${hash}, is said, and what is shown instead`, async () => {
    const {page, problems, close} = await open({viewport: {width: 1024, height: 768}}, {hash});
    assert.equal(await page.locator(".rb-said").textContent(), /play/.test(hash) ? `The scene in this link can’t be read: it is damaged or cut off. ${kShownInstead}` : notAStep(hash));
    const {y, height} = await page.locator(".rb-said").boundingBox();
    assert.ok(y > 0 && y + height < 768 && await page.locator(".rb-question").isHidden());
    assert.deepEqual(problems, []);
    await close();
  });
}

testOnce("who leaves has the book as it was", async () => {
  const {page, problems, close} = await open({viewport: {width: 1366, height: 768}});
  await page.evaluate(() => {
    const {player} = rotatebook;
    player.throwAbout("z");
    player.pause();
    player.toggleWhy();
    player.seek(100);
    player.orbit.right = 0.5;
    player.redraw();
  });
  const stateOf = () => page.evaluate(() => {
    const {scene, original, frame, clock, orbit, isTurnedForWhy} = rotatebook.player;
    return {text: scene.text, original, frame, isPlaying: clock.isPlaying, orbit: {...orbit}, isTurnedForWhy};
  });
  const before = await stateOf(), checksum = await checksumOf(page);
  await page.locator("[data-do=tour]").click();
  await page.locator(".rb-answers button").first().click();
  await page.waitForFunction(() => rotatebook.player.frame > 5);
  await page.evaluate(() => rotatebook.player.tour.open(3));
  await thrownAbout(page, "x").click();
  assert.notDeepEqual(await stateOf(), before);
  await page.getByRole("button", {name: "Leave the tour"}).click();
  await page.waitForFunction(() => rotatebook.player.frame === 100);
  assert.deepEqual(await stateOf(), before);
  assert.equal(await checksumOf(page), checksum);
  assert.equal(await hashOf(page), "");
  assert.equal(await page.evaluate(() => document.activeElement.className), "rb-picture");
  assert.deepEqual(problems, []);
  await close();
});

testOnce("a scene from elsewhere, or a question, ends the tour", async () => {
  const {page, close} = await open({}, {hash: "#tour=2"});
  await waitForStep(page, 2);
  await page.evaluate(() => rotatebook.play("title = \"t\"\n[initial]\nangular_velocity = [4, 0, 0.1]\n"));
  assert.ok(await page.locator(".rb-question").isHidden());
  assert.deepEqual([await lineOf(page), await hashOf(page), (await sceneOf(page)).title], ["", "", "t"]);
  await page.evaluate(() => rotatebook.player.tour.open(2));
  await page.locator("[data-do=predict]").click();
  assert.deepEqual([await lineOf(page), await hashOf(page)], ["", ""]);
  await thrownAbout(page, "x").click();
  assert.equal((await sceneOf(page)).panel.length, 3, "first choose an answer");
  await page.locator(".rb-answers button").first().click();
  await page.waitForFunction(() => rotatebook.player.frame > 5);
  await page.locator(".rb-close").click();
  assert.ok(await page.locator(".rb-question").isHidden());
  await close();
});

testOnce("a change that closes the question of a step goes on with the tour", async () => {
  const {page, close} = await open({}, {hash: "#tour=1"});
  await waitForStep(page, 1);
  await page.locator("input[name=rb-frame][value=body]").check();
  await waitUntilDone(page);
  assert.match(await page.locator(".rb-question-text").textContent(), /^The one about x/);
  assert.equal(await frameOf(page), 0);
  await close();
});
