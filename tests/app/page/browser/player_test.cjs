// The page's players, in a real browser.
"use strict";

const assert = require("node:assert/strict");
const {test, before, after, describe} = require("node:test");
const {startBrowser, closeBrowser, open, openClip, waitForSeek} = require("./made_page.cjs");

before(startBrowser);
after(closeBrowser);

const timeOf = (clip) => clip.locator("video").evaluate((video) => video.currentTime);
const isPaused = (clip) => clip.locator("video").evaluate((video) => video.paused);
const frameOf = async (clip) => Number(await clip.locator(".seek").inputValue());
const sampleAtPlayhead = async (clip, plot = 0) =>
  Number(await clip.locator(".playhead").nth(plot).getAttribute("data-index"));

async function playUntil(page, id, seconds) {
  await page.waitForFunction(([name, wanted]) => document.querySelector("#" + name + " video").currentTime > wanted,
    [id, seconds]);
}

describe("the player", () => {
  test("plays, and the plots follow", async () => {
    const {page, problems, close} = await open();
    const clip = await openClip(page, "turns");
    assert.ok(await isPaused(clip), "moves although less motion is asked for");
    await clip.locator(".play").click();
    await playUntil(page, "turns", 0.4);
    await clip.locator(".play").click();
    // The picture goes to the frame that the plots stopped at, a moment after the click.
    await page.waitForFunction(() => {
      const video = document.querySelector("#turns video");
      return video.paused && !video.seeking && document.querySelector("#turns .seek").value === String(Math.floor(60 * video.currentTime));
    });
    const frame = await frameOf(clip);
    assert.ok(frame > 20, `frame ${frame}`);
    for (const plot of [0, 1, 2]) assert.equal(await sampleAtPlayhead(clip, plot), frame);
    assert.deepEqual(problems, []);
    await close();
  });

  test("goes where a plot is clicked", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
    for (const plot of [0, 1, 2]) {
      const over = clip.locator(".u-over").nth(plot);
      const box = await over.boundingBox();
      const share = 0.25 + 0.25 * plot;
      await over.click({position: {x: share * box.width, y: 20}});
      await waitForSeek(page, "turns");
      const wanted = share * 89 / 60;
      assert.ok(Math.abs(await timeOf(clip) - wanted) < 1.6 / 60, `at ${await timeOf(clip)} s, not ${wanted} s`);
      assert.equal(await sampleAtPlayhead(clip, 0), await frameOf(clip));
    }
    await close();
  });

  test("draws the playhead at its sample", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
    const placeOf = async (frame) => {
      await clip.locator(".seek").fill(String(frame));
      await waitForSeek(page, "turns");
      const [head, over] = [await clip.locator(".playhead").first().boundingBox(), await clip.locator(".u-over").first().boundingBox()];
      return (head.x + head.width / 2 - over.x) / over.width;
    };
    for (const frame of [0, 30, 89]) assert.ok(Math.abs(await placeOf(frame) - frame / 89) < 0.01, `frame ${frame}`);
    await close();
  });

  test("steps by buttons and keys, and plays by the space bar", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
    await clip.locator(".seek").fill("40");
    await waitForSeek(page, "turns");
    await clip.locator(".on").click();
    await waitForSeek(page, "turns");
    assert.equal(await frameOf(clip), 41);
    assert.equal(Math.floor(await timeOf(clip) * 60), 41);
    await clip.locator(".back").click();
    await clip.locator(".back").click();
    assert.equal(await frameOf(clip), 39);
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press(".");
    await page.keyboard.press(".");
    await page.keyboard.press(",");
    await waitForSeek(page, "turns");
    assert.equal(await frameOf(clip), 40);
    assert.equal(Math.floor(await timeOf(clip) * 60), 40);
    await page.keyboard.press(" ");
    await playUntil(page, "turns", 0.75);
    await page.keyboard.press(" ");
    assert.ok(await isPaused(clip));
    await close();
  });

  test("goes where the last key says, also when the video has just arrived elsewhere", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
    await clip.locator(".seek").fill("40");
    await waitForSeek(page, "turns");
    await page.evaluate(() => new Promise((resolve) => {
      const press = (key) => document.body.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true}));
      const video = document.querySelector("#turns video");
      let arrivals = 0;
      video.addEventListener("seeked", () => { if (++arrivals === 2) resolve(); });
      // Before the player hears of it: the video no longer seeks, and the second step still waits.
      window.addEventListener("seeked", () => press(","), {capture: true, once: true});
      press(".");
      press(".");
    }));
    assert.equal(await frameOf(clip), 41);
    assert.equal(Math.floor(await timeOf(clip) * 60), 41);
    await close();
  });

  test("stays within the clip", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
    await clip.locator(".seek").fill("0");
    await clip.locator(".back").click();
    assert.equal(await frameOf(clip), 0);
    await clip.locator(".seek").fill("89");
    await clip.locator(".on").click();
    await waitForSeek(page, "turns");
    assert.equal(await frameOf(clip), 89);
    assert.ok(await timeOf(clip) <= 1.5);
    await close();
  });

  test("plays at the speed that is chosen", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
    for (const [name, speed] of [["¼×", 0.25], ["½×", 0.5], ["1×", 1], ["½×", 0.5]]) {
      await clip.locator(".speed button", {hasText: name}).click();
      assert.equal(await clip.locator("video").evaluate((video) => video.playbackRate), speed);
      assert.equal(await clip.locator(".speed [aria-pressed=true]").innerText(), name);
    }
    assert.equal(await page.locator("#pair .speed [aria-pressed=true]").innerText(), "½×", "one speed for all clips");
    assert.equal((await openClip(page, "pair")) && await page.locator("#pair video").evaluate((video) => video.playbackRate), 0.5);
    await close();
  });

  test("loops unless told otherwise", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
    await clip.locator(".loop").click();
    assert.equal(await clip.locator(".loop").getAttribute("aria-pressed"), "false");
    await clip.locator(".play").click();
    await page.waitForFunction(() => document.querySelector("#turns video").ended);
    assert.equal(await frameOf(clip), 89);
    await clip.locator(".loop").click();
    await clip.locator(".play").click();
    await page.waitForFunction(() => document.querySelector("#turns video").currentTime > 1.2);
    await page.waitForFunction(() => document.querySelector("#turns video").currentTime < 1);
    await close();
  });

  test("leaves out the error where there is none but of rounding", async () => {
    const {page, close} = await open();
    const titlesOf = (id) => page.locator("#" + id + " .plot h3").evaluateAll((all) => all.map((title) => title.firstChild.data));
    assert.deepEqual(await titlesOf("turns"), ["Energy as a share of the start’s total", "Tilt of the spun axis [°]", "Error against the exact motion [°]"]);
    assert.deepEqual(await page.evaluate(() => {
      const motion = (error) => ({label: "", springs: false, kinetic: [1], potential: [0], total: [1], tilt: [0], error: [error]});
      return [[4e-14], [2e-9], [4e-14, 1], [null]].map((errors) => chartsOf({motions: errors.map(motion)}).length);
    }), [2, 3, 3, 3]);
    await close();
  });

  test("shows the poster's moment before it plays from the start", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
    assert.equal(await frameOf(clip), 45);
    for (const plot of [0, 1, 2]) {
      assert.equal(await sampleAtPlayhead(clip, plot), 45);
      const [head, over] = [await clip.locator(".playhead").nth(plot).boundingBox(), await clip.locator(".u-over").nth(plot).boundingBox()];
      assert.ok(Math.abs((head.x + head.width / 2 - over.x) / over.width - 45 / 89) < 0.01, `at ${head.x} of ${over.width}`);
    }
    await clip.locator(".speed button", {hasText: "¼×"}).click();
    await clip.locator(".play").click();
    await page.waitForFunction(() => document.querySelector("#turns video").currentTime > 0 && document.querySelector("#turns .seek").value < 30);
    await close();
  });

  test("folds a plot of lines, and says where they are", async () => {
    const {page, problems, close} = await open({}, {place: "#recorded-defaults"});
    const plot = page.locator("#recorded-defaults .plots details.plot");
    assert.deepEqual(await plot.locator("summary").allInnerTexts(), ["Energy as a share of the start’s total: 1 throughout"]);
    assert.equal(await plot.locator("canvas").count(), 0);
    await plot.locator("summary").click();
    await plot.locator("canvas").waitFor();
    assert.equal(await page.locator("#turns details.plot").count(), 0);
    const isFolded = (...series) => page.evaluate((all) => isOfLines({from: 1, least: 0.1, series: all.map((values) => ({values}))}), series);
    assert.ok(await isFolded([1, 1.0009, null], [1, 1]));
    assert.ok(!await isFolded([1, 1.0011], [1, 1]));
    assert.ok(await isFolded([null]));
    assert.deepEqual(problems, []);
    await close();
  });

  test("keeps the last sample while a clip that diverged is held", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "bursts");
    const last = Number(await clip.locator(".seek").getAttribute("max"));
    await clip.locator(".seek").fill(String(last));
    await waitForSeek(page, "bursts");
    assert.ok(await sampleAtPlayhead(clip) < last - 20, `sample ${await sampleAtPlayhead(clip)} of ${last}`);
    await close();
  });

  test("begins by its large button, one clip at a time", async () => {
    const {page, close} = await open({reducedMotion: "no-preference"});
    await page.locator("#turns .start").click();
    await playUntil(page, "turns", 0.1);
    assert.ok(await page.locator("#turns .start").isHidden());
    await page.locator("#bursts .start").click();
    await page.waitForFunction(() => !document.querySelector("#bursts video").paused);
    await page.waitForFunction(() => document.querySelector("#turns video").paused);
    await close();
  });

  test("tells what happens, in captions and in a list", async () => {
    const {page, problems, close} = await open();
    const clip = await openClip(page, "bursts");
    const cues = () => clip.locator("video").evaluate((video) => [...video.textTracks[0].activeCues ?? []].map((cue) => cue.text));
    assert.deepEqual(await cues(), []);
    await page.keyboard.press("c");
    assert.equal(await clip.locator(".words").getAttribute("aria-pressed"), "true");
    await clip.locator(".events summary").click();
    const words = await clip.locator(".events button").allInnerTexts();
    assert.match(words.at(-1), /^0\.\d\d s: burst$/);
    await clip.locator(".events button").last().click();
    await waitForSeek(page, "bursts");
    await page.waitForFunction((last) => [...document.querySelector("#bursts video").textTracks[0].activeCues ?? []].some((cue) => cue.text === last), words.at(-1));
    await clip.locator(".words").click();
    assert.equal(await clip.locator("video").evaluate((video) => video.textTracks[0].mode), "disabled");
    assert.deepEqual(problems, []);
    await close();
  });

  test("can be used without scripts", async () => {
    const {page, close} = await open({javaScriptEnabled: false});
    assert.ok(await page.locator("#turns video").getAttribute("controls") !== null);
    assert.ok(await page.locator("#turns .controls").isHidden());
    await close();
  });
});
