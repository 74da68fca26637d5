// What is done while something else goes on: drops, edits and throws during a simulation, a proof or a question.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const {test, before, after, describe} = require("node:test");
const {kTurns, startBrowser, closeBrowser, open, render, frameOf, sceneOf, checksumOf, messageOf, load} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

/** A motion that takes some seconds to simulate; its clip has few frames. */
const kSlow = kTurns.replace("[simulation]", "[simulation]\nmodel = \"particles\"\nsubsteps = 100000").replace("6.0, 0.0, 0.0", "5.0, 0.0, 0.0");

const fileOf = (path) => ({name: path.split("/").pop(), data: fs.readFileSync(path).toString("base64")});

/** Opens files one after the other, each while the one before is read or proved. */
const openAll = (page, files) => page.evaluate(async (all) => {
  const opened = [];
  for (const {name, data} of all) {
    const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
    opened.push(rotatebook.player.open(new File([bytes], name)));
    await new Promise((resolve) => { setTimeout(resolve, 200); });
  }
  await Promise.all(opened);
}, files);

/** Opens a file, and does something while it is proved. */
const openWhile = (page, file, action) => page.evaluate(async ([{name, data}, script]) => {
  const opened = rotatebook.player.open(new File([Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0))], name));
  while (!/Simulating slow/.test(document.querySelector(".rb-message").textContent)) await new Promise((resolve) => { setTimeout(resolve); });
  (0, eval)(script);
  await opened;
}, [file, action]);

describe("a clip that is proved", () => {
  test("gives way to the next, and neither is accused", async () => {
    const {page, problems, close} = await open();
    const slow = render("slow", kSlow), quick = render("turns", kTurns);
    await page.evaluate(() => { window.words = []; new MutationObserver(() => words.push(document.querySelector(".rb-message").textContent))
      .observe(document.querySelector(".rb-message"), {childList: true}); });
    await openAll(page, [slow, quick].map(fileOf));
    assert.match(await messageOf(page), /proved: .* turns\.mp4/);
    await openAll(page, [quick, slow].map(fileOf));
    assert.match(await messageOf(page), /proved: .* slow\.mp4/);
    assert.deepEqual((await page.evaluate(() => words)).filter((text) => /differs/.test(text)), []);
    assert.deepEqual(problems, []);
    await close();
  });

  test("goes on beside a ghost's motion", async () => {
    const {page, close} = await open();
    await load(page, kTurns);
    await openWhile(page, fileOf(render("slow", kSlow)), "rotatebook.player.apply(rotatebook.player.scene.withShown('ghost', true))");
    assert.match(await messageOf(page), /proved: .* slow\.mp4.* isn’t played/);
    await close();
  });

  test("isn't played over what was done meanwhile", async () => {
    const {page, close} = await open();
    await openWhile(page, fileOf(render("slow", kSlow)), "rotatebook.player.throwAbout('z')");
    assert.deepEqual((await sceneOf(page)).initial.angular_velocity, [0, 0, 4]);
    assert.match(await messageOf(page), /so it isn’t played; drop it again/);
    await close();
  });
});

describe("a change late in a motion", () => {
  const kLate = `[simulation]\nmodel = "particles"\nsubsteps = 1000\n[initial]\nangular_velocity = [4, 0, 0]\ntilt = [0.01, "z"]\n[clip]\nduration = 30\n`;

  test("never sends the book back in time", async () => {
    const {page, close} = await open();
    await load(page, kLate);
    await checksumOf(page);
    const frames = await page.evaluate(async () => {
      const {player} = rotatebook, seen = [];
      player.seek(1700);
      player.throwBook(0, 1);
      while (player.isWaiting) {
        seen.push(player.frame);
        await new Promise((resolve) => { setTimeout(resolve, 10); });
      }
      seen.push(player.frame);
      return seen;
    });
    assert.ok(frames.every((frame) => frame >= 1700), String(frames.filter((frame) => frame < 1700)));
    assert.equal((await sceneOf(page)).nudge.length, 1);
    await close();
  });

  test("of the overlay alone keeps all that is simulated", async () => {
    const {page, close} = await open();
    await load(page, kLate);
    const checksum = await checksumOf(page);
    const [frame, simulated] = await page.evaluate(() => {
      const {player} = rotatebook;
      player.seek(1700);
      player.apply(player.scene.withShown("axes", true));
      return [player.frame, player.simulated];
    });
    assert.deepEqual([frame, simulated], [1700, 1800]);
    assert.equal(await checksumOf(page), checksum);
    await close();
  });

  test("at its end lengthens it, so that the throw is seen", async () => {
    const {page, close} = await open();
    await load(page, kTurns);
    await checksumOf(page);
    await page.evaluate(() => {
      rotatebook.player.seek(89);
      rotatebook.player.throwBook(0, 3);
    });
    await page.waitForFunction(() => rotatebook.player.frame > 100);
    assert.ok((await sceneOf(page)).clip.duration > 11);
    await close();
  });
});

describe("a question", () => {
  const ask = async () => {
    const opened = await open();
    await opened.page.locator("[data-do=predict]").click();
    return opened;
  };
  const timeline = (page) => page.evaluate(() => document.querySelector(".rb-timeline canvas").toDataURL());

  test("keeps what happens to itself, until it is answered", async () => {
    const {page, close} = await ask();
    await checksumOf(page);
    await page.waitForTimeout(100);
    const secret = await timeline(page);
    for (const key of ["End", ".", " "]) {
      await page.locator(".rb-picture").focus();
      await page.keyboard.press(key);
    }
    assert.equal(await frameOf(page), 0);
    assert.equal(await page.evaluate(() => rotatebook.player.clock.isPlaying), false);
    await page.evaluate(() => rotatebook.player.throwAbout("y"));
    assert.equal(await page.evaluate(() => rotatebook.player.predict.isAsking), true);
    await page.evaluate(() => rotatebook.player.predict.choose(0));
    await page.waitForFunction((before) => document.querySelector(".rb-timeline canvas").toDataURL() !== before, secret);
    await page.waitForFunction(() => rotatebook.player.frame > 5);
    await close();
  });

  test("isn't answered beside the books", async () => {
    const {page, close} = await ask();
    await page.evaluate(() => rotatebook.player.predict.choosePanel(-1));
    assert.equal(await page.evaluate(() => rotatebook.player.predict.isAsking), true);
    await close();
  });

  test("goes when another scene comes", async () => {
    const {page, close} = await ask();
    await page.evaluate(`rotatebook.player.load(${JSON.stringify(kTurns)})`);
    assert.ok(await page.locator(".rb-question").isHidden());
    await page.evaluate(() => { rotatebook.player.start(); });
    await page.waitForFunction(() => rotatebook.player.frame > 60);
    assert.ok(await page.locator(".rb-question").isHidden());
    await close();
  });
});

test("a motion that can't go on pauses, and has no checksum", async () => {
  const {page, close} = await open();
  await load(page, kTurns.replace("euler\"", "dmv6\"\nsubsteps = 1").replace("6.0, 0.0, 0.0", "200.0, 100.0, 50.0"));
  await page.evaluate(() => rotatebook.player.start());
  await page.waitForFunction(() => /No checksum/.test(document.querySelector(".rb-checksum").textContent));
  await page.waitForFunction(() => !rotatebook.player.clock.isPlaying);
  assert.ok((await messageOf(page)).length > 20);
  await close();
});

test("a refused scene leaves the record of the good one", async () => {
  const {page, close} = await open();
  await page.evaluate(() => rotatebook.play("nothing = 1", "0123"));
  await checksumOf(page);
  assert.doesNotMatch(await page.locator(".rb-checksum").textContent(), /clip/);
  await close();
});

test("an address that holds a scene follows its changes", async () => {
  const {page, close} = await open();
  await page.evaluate(async (text) => { location.hash = await rotatebook.hashOf(text); }, kTurns);
  await page.waitForFunction(() => rotatebook.player.scene.tree.title === "A book that turns over");
  const hash = await page.evaluate(() => location.hash);
  await page.evaluate(() => rotatebook.player.throwAbout("z"));
  await page.waitForFunction((before) => location.hash !== before, hash);
  const other = await open({}, {hash: await page.evaluate(() => location.hash)});
  assert.deepEqual((await sceneOf(other.page)).initial.angular_velocity, [0, 0, 6]);
  await other.close();
  await close();
});
