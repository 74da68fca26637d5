// The live book in Firefox, under a display; where WebGL 2 is switched off, which is said.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test} = require("node:test");
const {pathToFileURL} = require("node:url");
const puppeteer = require("puppeteer-core");
const {kPlay, kOutput, kTurns, render, verify} = require("./live_page.cjs");
const {kScenes, kMotions, giveFiles} = require("./shipped.cjs");

/** A page that opens files as people's Firefox does: what lies beside it is another origin. */
async function open(hasWebGl2, address = pathToFileURL(kPlay).href) {
  const browser = await puppeteer.launch({browser: "firefox", executablePath: "/usr/bin/firefox-esr", headless: false,
    extraPrefsFirefox: {"security.fileuri.strict_origin_policy": true, "ui.prefersReducedMotion": 1, "webgl.enable-webgl2": hasWebGl2}});
  const page = await browser.newPage();
  await page.goto(address);
  const [played] = [...page.frames().slice(1), page];  // That in a frame of the page, or the page.
  await played.waitForFunction(() => document.querySelector(".rb-live")?.dataset.ready === "true");
  return {page, played, close: () => browser.close()};
}

/** What the steps of the tour ask for. */
const kTourActs = [".rb-answers button:nth-child(2)", ".rb-throws [data-axis=x]", "input[name=rb-frame][value=body]", "[data-do=why]", ".rb-throws [data-axis=z]",
  ".rb-throws [data-axis=y]"];

test("the tour is gone through, and left", async () => {
  const {page, close} = await open(true, pathToFileURL(kPlay).href + "#tour=1");
  try {
    await page.select(".rb-speed select", "8");
    for (const [i, act] of kTourActs.entries()) {
      await page.waitForFunction((step) => document.querySelector(".rb-step").textContent.startsWith(`Tour, step ${step} of 6`), {}, i + 1);
      assert.equal(await page.evaluate(() => location.hash), `#tour=${i + 1}`);
      assert.ok(await page.$eval(".rb-next", (next) => next.disabled), "something is to be done");
      await page.$eval(act, (element) => element.click());
      await page.waitForFunction(() => !document.querySelector(".rb-next").disabled);
      if (i + 1 < kTourActs.length) await page.$eval(".rb-next", (next) => next.click());
    }
    await page.goBack();
    await page.waitForFunction(() => location.hash === "#tour=5" && /step 5/.test(document.querySelector(".rb-step").textContent));
    await page.$eval(".rb-answers .rb-close", (leave) => leave.click());
    await page.waitForFunction(() => location.hash === "" && document.querySelector(".rb-question").hidden);
  } finally {
    await close();
  }
});

test("it fills the screen by its button, and leaves it by the key", async () => {
  const {page, close} = await open(true);
  const isFull = (wanted) => page.waitForFunction((on) => (document.fullscreenElement !== null) === on && (document.querySelector(".rb-bare") !== null) === on, {}, wanted);
  try {
    await page.click("[data-do=full]");
    await isFull(true);
    const [label, box, size] = await page.evaluate(() => {
      const {left, top, right, bottom} = document.querySelector(".rb-player").getBoundingClientRect();
      return [document.querySelector("[data-do=full]").getAttribute("aria-label"), [left, top, right, bottom], [innerWidth, innerHeight]];
    });
    assert.deepEqual([label, ...box.map(Math.round)], ["Leave full screen", 0, 0, ...size]);
    await page.focus(".rb-picture");
    await page.keyboard.press("f");
    await isFull(false);
  } finally {
    await close();
  }
});

test("in a frame from a file it is alone, fills the frame, and is thrown", async () => {
  const course = path.join(kOutput, "course-firefox.html");
  fs.writeFileSync(course, `<!doctype html><html lang="en"><title>A course</title><iframe src="${pathToFileURL(kPlay).href}#embed" width="960" height="600" allowfullscreen></iframe>`);
  const {played, close} = await open(true, pathToFileURL(course).href);
  try {
    const seen = await played.evaluate(() => {
      const parts = [...document.querySelector(".rb-player").children].filter((element) => element.checkVisibility() && element.getBoundingClientRect().height > 1);
      const {right, bottom} = document.querySelector(".rb-transport").getBoundingClientRect();
      return {parts: parts.map((element) => element.className), ends: [right, bottom].map(Math.round), heading: document.querySelector("h1").checkVisibility()};
    });
    assert.deepEqual(seen, {parts: ["rb-scene", "rb-transport"], ends: [960, 600], heading: false});
    assert.equal(await played.$eval(".rb-whole", (link) => link.href), pathToFileURL(kPlay).href);
    await played.$eval(".rb-throws [data-axis=z]", (button) => button.click());
    await played.waitForFunction(() => rotatebook.player.outcome.spin?.axis === "largest" && rotatebook.player.frame > 5);
  } finally {
    await close();
  }
});

test("all scenes have the checksums of the table, and a clip is proved", async () => {
  const {page, close} = await open(true);
  try {
    for (const [name, checksum] of kMotions) {
      const text = fs.readFileSync(kScenes.get(name), "utf8");
      await giveFiles(page, kScenes.get(name), text);
      const motion = await page.evaluate(async (scene) => {
        const player = rotatebook.player;
        if (!player.load(scene, {isPlaying: false})) return document.querySelector(".rb-message").textContent;
        while (player.checksum === null) await new Promise((resolve) => { setTimeout(resolve, 10); });
        return player.checksum;
      }, text);
      assert.equal(motion, checksum, name);
    }
    await (await page.$("input[type=file]")).uploadFile(render("turns", kTurns));
    await page.waitForFunction(() => /Motion proved/.test(document.querySelector(".rb-message").textContent));
    const isDrawn = await page.evaluate(() => {
      const player = rotatebook.player, small = Object.assign(document.createElement("canvas"), {width: 64, height: 36}), context = small.getContext("2d");
      player.drawing.draw(10, player);
      context.drawImage(player.drawing.picture, 0, 0, 64, 36);
      const reds = context.getImageData(0, 0, 64, 36).data.filter((part, i) => i % 4 === 0);
      return !player.drawing.view.lack && Math.max(...reds) > 100 && Math.min(...reds) < 60;
    });
    assert.ok(isDrawn);
  } finally {
    await close();
  }
});

test("a clip is saved, as what this browser has an encoder for", async () => {
  const {page, close} = await open(true);
  try {
    const {name, content, said} = await page.evaluate(async (scene) => {
      const {player} = rotatebook;
      player.load(scene, {isPlaying: false});
      let blob, name;
      const create = URL.createObjectURL;
      URL.createObjectURL = (object) => create.call(URL, blob = object);
      HTMLAnchorElement.prototype.click = function() { name = this.download; };
      await player.saver.save();
      const reader = new FileReader();
      await new Promise((resolve) => { reader.onload = resolve; reader.readAsDataURL(blob); });
      return {name, content: reader.result.split(",")[1], said: document.querySelector(".rb-message").textContent};
    }, kTurns.replace("[64, 36]\nduration = 1.5", "[320, 180]\nduration = 0.5"));
    console.log(said);
    assert.match(said, /^Saved live-book\.(mp4|webm|zip): 30 pictures of 320x180, (H\.264|VP9|PNG), /);
    const file = path.join(kOutput, "clips", `firefox-${name}`);
    fs.writeFileSync(file, Buffer.from(content, "base64"));
    if (name.endsWith("zip")) return;
    const {status, output} = verify(file);
    assert.equal(status, 4, output);
    assert.match(output, /^Motion proved: /m);
  } finally {
    await close();
  }
});

test("without WebGL 2 the book is drawn plainly, which is said", async () => {
  const {page, close} = await open(false);
  try {
    assert.match(await page.$eval(".rb-said", (line) => line.textContent), /no WebGL 2/);
    const reds = await page.evaluate(() => {
      const {player} = rotatebook, {lines} = player.drawing, pixels = lines.getContext("2d").getImageData(0, 0, lines.width, lines.height).data;
      let count = 0;
      for (let i = 0; i < pixels.length; i += 4) count += pixels[i] > 2 * pixels[i + 1] && pixels[i] > 60;
      return count / (lines.width * lines.height);
    });
    assert.ok(reds > 0.03, `${reds} of the picture is red`);
  } finally {
    await close();
  }
});
