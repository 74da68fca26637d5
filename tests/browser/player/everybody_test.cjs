// For everybody: no accessibility violation, no motion unasked, events told, phones.
"use strict";

const assert = require("node:assert/strict");
const path = require("node:path");
const {test, before, after} = require("node:test");
const {kOutput, startBrowser, closeBrowser, open, violations, frameOf, load, kTurns} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

for (const width of [390, 768, 1280]) {
  test(`axe finds nothing, and nothing is wider than the page, at ${width} pixels`, async () => {
    const {page, problems, close} = await open({viewport: {width, height: 800}});
    await page.screenshot({path: path.join(kOutput, `first-${width}.png`)});
    await page.locator(".rb-more > summary").click();
    await page.locator("input[name=rb-books][value=same]").check();
    assert.deepEqual(await violations(page), []);
    await page.screenshot({path: path.join(kOutput, `more-${width}.png`), fullPage: true});
    await page.locator("[data-do=predict]").click();
    assert.deepEqual(await violations(page), []);
    await load(page, "no scene");
    assert.deepEqual(await violations(page), []);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
    // No word is so narrow that its letters stand one below the other.
    const wrapped = await page.evaluate(() => [...document.querySelectorAll(".rb-live button, .rb-live label, .rb-live dd, .rb-live dt, .rb-live legend, .rb-name")]
      .filter((element) => element.offsetParent && element.clientWidth > 0 && element.textContent.trim().length > 3 && element.clientWidth < 24)
      .map((element) => element.outerHTML));
    assert.deepEqual(wrapped, []);
    assert.deepEqual(problems, []);
    await close();
  });
}

test("axe does find what is wrong", async () => {
  const {page, close} = await open();
  await page.evaluate(() => {
    document.querySelector(".rb-seek").removeAttribute("aria-label");
    document.querySelector(".rb-time").style.color = "#444";
  });
  const found = (await violations(page)).join("\n");
  assert.match(found, /^label: /m);
  assert.match(found, /^color-contrast: /m);
  await close();
});

test("nothing moves unasked where less motion is wanted, and does elsewhere", async () => {
  const still = await open({reducedMotion: "reduce"});
  await still.page.waitForTimeout(700);
  assert.equal(await frameOf(still.page), 0);
  await still.close();
  const moving = await open({reducedMotion: "no-preference"});
  await moving.page.waitForFunction(() => rotatebook.player.frame > 10);
  assert.equal(await moving.page.locator(".rb-play").textContent(), "Pause");
  await moving.close();
});

test("events are told politely, at most every 1.5 s", async () => {
  const {page, close} = await open();
  await load(page, kTurns.replace("1.5", "8"));
  await page.evaluate(() => {
    window.told = [];
    new MutationObserver(() => told.push([performance.now(), document.querySelector(".rb-events").textContent]))
      .observe(document.querySelector(".rb-events"), {childList: true, characterData: true, subtree: true});
    rotatebook.player.start();
  });
  await page.waitForFunction(() => window.told.length >= 3, null, {timeout: 20000});
  const told = await page.evaluate(() => window.told);
  assert.match(told[0][1], /^\d\.\d\d s: flip 1$/);
  told.slice(1).forEach(([time], i) => assert.ok(time - told[i][0] > 1450, JSON.stringify(told)));
  const region = page.locator(".rb-events");
  assert.deepEqual([await region.getAttribute("role"), await region.getAttribute("aria-live")], ["status", "polite"]);
  await close();
});

test("the time, which changes with each picture, isn't read aloud, but a start that keys choose on the ball is", async () => {
  const {page, close} = await open();
  assert.equal(await page.locator(".rb-time").getAttribute("aria-live"), "off");
  await page.locator(".rb-ball").focus();
  await page.keyboard.press("ArrowUp");
  await page.waitForFunction(() => /^4\.0 rad\/s, \d+ degrees off the middle axis: it turns over about every [\d.]+ s\.$/.test(document.querySelector(".rb-events").textContent));
  await close();
});

test("a motion that has ended begins again", async () => {
  const {page, close} = await open();
  await load(page, kTurns);
  await page.evaluate(() => {
    rotatebook.player.seek(80);
    rotatebook.player.start();
  });
  await page.waitForFunction(() => rotatebook.player.frame >= 80);
  await page.waitForFunction(() => rotatebook.player.frame > 3 && rotatebook.player.frame < 60, null, {polling: 20});
  assert.equal(await page.locator(".rb-play").textContent(), "Pause");
  await close();
});

test("a finger beside the book scrolls, one on it doesn't", async () => {
  const {page, close} = await open({viewport: {width: 390, height: 600}, hasTouch: true, isMobile: true});
  const session = await page.context().newCDPSession(page), stage = await page.locator(".rb-stage").boundingBox();
  const swipe = async (x) => {
    const touch = (type, ...touchPoints) => session.send("Input.dispatchTouchEvent", {type, touchPoints}), y = stage.y + stage.height / 2;
    await touch("touchStart", {x, y});
    for (let i = 1; i <= 10; ++i) await touch("touchMove", {x, y: y - 12 * i});
    await touch("touchEnd");
  };
  await page.waitForFunction(() => rotatebook.player.drawing.books.length === 1);
  await swipe(stage.x + stage.width / 2);
  assert.equal(await page.evaluate(() => scrollY), 0);
  await swipe(stage.x + 12);
  await page.waitForFunction(() => scrollY > 60);
  assert.deepEqual(await page.evaluate(() => [rotatebook.player.orbit.right, rotatebook.player.orbit.up]), [0, 0]);
  await close();
});

test("everything can be reached by Tab, and the focus is seen", async () => {
  const {page, close} = await open();
  await page.locator(".rb-more > summary").click();
  const wanted = await page.evaluate(() => {
    const groups = new Set();
    return [...document.querySelectorAll(".rb-live :is(button, input, select, summary, [tabindex='0'])")].filter((element) => {
      if (element.offsetParent === null || element.disabled) return false;
      if (element.type !== "radio") return true;
      // Of radio buttons one is a stop.
      return !groups.has(element.name) && groups.add(element.name);
    }).length;
  });
  const seen = new Set();
  for (let i = 0; i < wanted + 3; ++i) {
    await page.keyboard.press("Tab");
    const focus = await page.evaluate(() => {
      const element = document.activeElement, box = element.closest(".rb-segments label, .rb-file") ?? element;
      if (!element.closest(".rb-live")) return null;
      element.dataset.stop ??= String(Math.random());
      return {stop: element.dataset.stop, outline: getComputedStyle(box).outlineStyle, html: element.outerHTML.slice(0, 100)};
    });
    if (!focus) continue;
    seen.add(focus.stop);
    assert.notEqual(focus.outline, "none", focus.html);
  }
  assert.equal(seen.size, wanted);
  await close();
});

test("on paper there are the picture and its numbers, dark on white, and no controls", async () => {
  const {page, close} = await open();
  await page.waitForFunction(() => rotatebook.player.drawing.books.length === 1);
  const pdf = await page.pdf({path: path.join(kOutput, "printed.pdf"), format: "A4"});
  assert.equal((pdf.toString("latin1").match(/\/Type\s*\/Page\b/g) ?? []).length, 1);
  await page.emulateMedia({media: "print"});
  assert.equal(await page.locator(":is(button, input, select, summary):visible").count(), 0);
  assert.equal(await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor), "rgb(255, 255, 255)");
  const grounds = await page.locator(":is(.rb-picture, .rb-legend, .rb-ladder)").evaluateAll((all) => all.map((one) => getComputedStyle(one).printColorAdjust));
  assert.deepEqual([...new Set(grounds)], ["exact"], "what is light on dark keeps its ground");
  // The lines get larger or smaller with the picture: the same share of it.
  const shareOfLines = () => page.evaluate(() => {
    const [lines, picture] = [".rb-lines", ".rb-picture"].map((part) => document.querySelector(part).getBoundingClientRect());
    return ["left", "top"].map((side, i) => (lines[side] - picture[side]) / [picture.width, picture.height][i]).concat(lines.width / picture.width, lines.height / picture.height);
  });
  const onPaper = await shareOfLines();
  await page.addStyleTag({content: ".rb-stage { width: 50% !important; aspect-ratio: 3 !important; min-height: 0 !important; }"});
  (await shareOfLines()).forEach((share, i) => assert.ok(Math.abs(share - onPaper[i]) < 0.005, `${share} for ${onPaper[i]}`));
  assert.ok(await page.locator(".rb-picture").isVisible() && await page.locator(".rb-numbers").first().isVisible());
  const colours = await page.locator(":is(h1, .lead, .rb-numbers :is(dt, dd)):visible").evaluateAll((all) => all.map((one) => getComputedStyle(one).color));
  for (const colour of colours) assert.ok(Math.max(...colour.match(/\d+/g).slice(0, 3)) < 100, colour);  // measured 79
  await close();
});
