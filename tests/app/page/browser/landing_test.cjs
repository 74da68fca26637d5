// Links to figures, in a real browser: where the window is after they have been followed.
"use strict";

const assert = require("node:assert/strict");
const {test, before, after, describe} = require("node:test");
const {startBrowser, closeBrowser, open} = require("./made_page.cjs");

before(startBrowser);
after(closeBrowser);

const kIds = ["turns", "bursts", "pair", "book", "matrix-steps"];
const kPadding = 16;  // the page's scroll-padding-top [CSS pixels]
const kMaxOff = 2;  // [CSS pixels]; measured 0.5
const kSettled = 700;  // [ms]; plots that come near the window are drawn sooner
const kWindows = {
  desktop: {viewport: {width: 1400, height: 900}},
  phone: {viewport: {width: 390, height: 844}, isMobile: true, hasTouch: true},
};

/**
 * Expects the figure's top at the window's, or below the sentence that leads to it, which is to be seen; the last figure's may be lower, where
 * the page ends.
 */
async function expectLanded(page, id, how) {
  await page.waitForTimeout(kSettled);
  const {y} = await page.locator("#" + id).boundingBox();
  const last = await page.locator("footer").boundingBox();
  const atEnd = last.y + last.height <= page.viewportSize().height + 100;
  const sentence = await page.locator("#" + id).evaluate((figure) => {
    const words = figure.previousElementSibling;
    if (!words?.matches(".between")) return null;
    return {top: words.getBoundingClientRect().top + parseFloat(getComputedStyle(words).paddingTop), room: parseFloat(getComputedStyle(figure).scrollMarginTop)};
  });
  if (sentence) assert.ok(sentence.top >= 0, `the sentence before #${id} is ${-sentence.top} pixels above the window, ${how}`);
  const off = y - kPadding - (sentence?.room ?? 0);
  assert.ok(Math.abs(off) <= kMaxOff || (atEnd && off > 0), `#${id} is ${off} pixels off, ${how}`);
}

for (const [name, window] of Object.entries(kWindows)) {
  const moving = {...window, reducedMotion: "no-preference"};
  describe("a link on a " + name, () => {
    test("of the overview leads to its figure, whatever was drawn before", async () => {
      for (const id of kIds) {
        const {page, close} = await open(moving);
        await page.locator(`.sheet a[href="#${id}"]`).click();
        await expectLanded(page, id, "on a fresh page");
        await close();
      }
      const {page, close} = await open(moving);
      for (const id of [...kIds].reverse()) {
        await page.locator(`.sheet a[href="#${id}"]`).click();
        await expectLanded(page, id, "after those below it");
      }
      await close();
    });

    test("from elsewhere does, too", async () => {
      for (const id of kIds.slice(1)) {
        const {page, close} = await open(moving, {place: "#" + id});
        await expectLanded(page, id, "opened there");
        await close();
      }
    });

    test("does so without scripts", async () => {
      for (const id of kIds.slice(2)) {
        const {page, close} = await open({...window, javaScriptEnabled: false}, {place: "#" + id});
        await expectLanded(page, id, "without scripts");
        await close();
      }
    });
  });
}

describe("the page", () => {
  test("keeps its height while curves are drawn", async () => {
    for (const window of Object.values(kWindows)) {
      const {page, close} = await open(window);
      const height = () => page.evaluate(() => document.documentElement.scrollHeight);
      const before = await height();
      for (const id of kIds) {
        await page.locator("#" + id).scrollIntoViewIfNeeded();
        await page.waitForTimeout(200);
      }
      assert.equal(await page.locator(".uplot").count(), 9);
      assert.equal(await height(), before);
      await close();
    }
  });
});
