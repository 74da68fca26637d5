// The players in full screen, in a real browser.
"use strict";

const assert = require("node:assert/strict");
const path = require("node:path");
const {test, before, after, describe} = require("node:test");
const {kOutput, startBrowser, closeBrowser, open, openClip, waitForSeek} = require("./made_page.cjs");

before(startBrowser);
after(closeBrowser);

const inFullScreen = (page) => page.evaluate(() => document.fullscreenElement?.closest(".clip").id ?? null);
/** The player hears of it a moment after the browser. */
const waitForFullScreen = (page, wanted) => page.waitForFunction((on) => (document.fullscreenElement !== null) === on &&
  [...document.querySelectorAll(".full")].some((button) => button.getAttribute("aria-label").startsWith("Leave")) === on, wanted);

describe("full screen", () => {
  test("is entered and left by the button, its picture as large as the screen", async () => {
    for (const colorScheme of ["light", "dark"]) {
      const {page, problems, close} = await open({colorScheme, viewport: {width: 1600, height: 900}});
      const clip = await openClip(page, "turns");
      const button = clip.locator(".full");
      assert.equal(await button.getAttribute("title"), "Full screen (f)");
      await button.click();
      await waitForFullScreen(page, true);
      assert.equal(await inFullScreen(page), "turns");
      assert.equal(await button.getAttribute("aria-label"), "Leave full screen");
      await clip.locator(".seek").fill("40");
      await waitForSeek(page, "turns");
      await page.waitForTimeout(300);
      const video = await clip.locator("video").boundingBox();
      assert.deepEqual(video, {x: 0, y: 0, width: 1600, height: 900});
      const controls = await clip.locator(".controls").boundingBox();
      assert.ok(controls.y > 800 && controls.y + controls.height <= 900.5, `controls from ${controls.y}, ${controls.height} high`);
      await page.screenshot({path: path.join(kOutput, `full-screen-${colorScheme}.png`)});
      await button.click();
      await waitForFullScreen(page, false);
      assert.equal(await button.getAttribute("aria-label"), "Full screen");
      assert.deepEqual(problems, []);
      await close();
    }
  });

  test("is entered and left by the key f, and its keys are the page's", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
    await clip.locator(".seek").fill("40");
    await waitForSeek(page, "turns");
    await page.keyboard.press("f");
    await waitForFullScreen(page, true);
    await page.keyboard.press(".");
    await waitForSeek(page, "turns");
    assert.equal(await clip.locator(".seek").inputValue(), "41");
    await page.keyboard.press("f");
    await waitForFullScreen(page, false);
    assert.match(await page.locator(".keys").innerText(), /f the clip in full screen/);
    await close();
  });

  test("hides the controls while the clip plays and nobody does anything", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "bursts");
    await clip.locator(".full").click();
    await waitForFullScreen(page, true);
    const opacity = () => clip.locator(".controls").evaluate((element) => getComputedStyle(element).opacity);
    await page.waitForTimeout(3000);
    assert.equal(await opacity(), "1", "of a clip that is paused");
    await page.keyboard.press(" ");
    await page.waitForFunction(() => getComputedStyle(document.querySelector("#bursts .controls")).opacity === "0");
    await page.mouse.move(100, 100);
    await page.waitForFunction(() => getComputedStyle(document.querySelector("#bursts .controls")).opacity === "1");
    await close();
  });

  test("is offered only where there is one", async () => {
    const {page, close} = await open({}, {script: () => Object.defineProperty(Document.prototype, "fullscreenEnabled", {value: false})});
    const clip = await openClip(page, "turns");
    assert.ok(await clip.locator(".full").isHidden());
    await page.keyboard.press("f");
    await page.waitForTimeout(300);
    assert.equal(await inFullScreen(page), null);
    await close();
  });

  test("is the video's own on phones that have no other", async () => {
    const {page, close} = await open({}, {script: () => {
      Object.defineProperty(Document.prototype, "fullscreenEnabled", {value: undefined});
      HTMLVideoElement.prototype.webkitEnterFullscreen = function enter() { this.dataset.entered = "yes"; };
    }});
    const clip = await openClip(page, "turns");
    await clip.locator(".full").click();
    assert.equal(await clip.locator("video").getAttribute("data-entered"), "yes");
    await close();
  });
});
