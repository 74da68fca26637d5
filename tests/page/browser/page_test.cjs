// The page in a real browser: two clips, one of which diverges, and a study. Screenshots are left in the output folder.
"use strict";

const {test, before, after, describe} = require("node:test");
const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {execFileSync} = require("node:child_process");
const {chromium} = require(process.env.ROTATEBOOK_PLAYWRIGHT);

const kOutput = process.env.ROTATEBOOK_PAGE_OUTPUT, kOut = path.join(kOutput, "out");
const kDesktop = {width: 1280, height: 800};
const kPhone = {width: 360, height: 740};
const kWait = 20000;  // [ms]

const kScenes = {
  "turns.toml": `title = "A <b>book</b> & \\"its\\" turn"
caption = "It turns about <script>its</script> middle axis & nothing else."
[initial]
angular_velocity = [6.0, 0.0, 0.0]
tilt = [0.1, "z"]
[clip]
size = [320, 180]
duration = 1.5
[expect]
half_turns = { max = 3 }
tilt_deg = { max = 1 }
`,
  "bursts.toml": `title = "It bursts"
[simulation]
model = "particles"
substeps = 1
normalize = false
damping = 0
[initial]
angular_velocity = [5.0, 3.0, 1.0]
[clip]
size = [320, 180]
fps = 24
duration = 1
`,
  "steps.toml": `title = "Two integrators"
caption = "A study."
[initial]
angular_velocity = [2.0, 3.0, -4.0]
[clip]
fps = 15
duration = 1
[study]
integrators = ["euler", "rk4"]
steps = [1, 2, 4, 8]
[study.orders]
rk4 = { min = 3 }
`,
};

let browser;

function rotatebook(...words) {
  return execFileSync(process.env.ROTATEBOOK_PROGRAM, words, {cwd: kOutput, encoding: "utf8", stdio: "pipe"});
}

/** Exit status 1 only says that an expectation is unmet, as one of turns.toml is. */
function render(...scenes) {
  try {
    rotatebook("render", ...scenes, "-o", kOut);
  } catch (error) {
    assert.equal(error.status, 1, error.stderr);
  }
}

before(async () => {
  fs.rmSync(kOut, {recursive: true, force: true});
  for (const [name, text] of Object.entries(kScenes)) fs.writeFileSync(path.join(kOutput, name), text);
  render("turns.toml", "bursts.toml");
  rotatebook("study", "steps.toml", "-o", kOut);
  rotatebook("page", "turns.toml", "bursts.toml", "steps.toml", "-o", kOut);
  browser = await chromium.launch({executablePath: process.env.CHROMIUM, chromiumSandbox: false});
});

after(() => browser?.close());

/** Opens the page; `problems` grows with whatever the browser complains of or asks a network for. */
async function open(options = {}) {
  const context = await browser.newContext({viewport: kDesktop, reducedMotion: "reduce", ...options});
  const page = await context.newPage();
  page.setDefaultTimeout(kWait);
  const problems = [];
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) problems.push(message.text()); });
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("requestfailed", (request) => {
    // The browser breaks off loads that it needs no more.
    if (request.failure()?.errorText !== "net::ERR_ABORTED") problems.push("failed: " + request.url());
  });
  page.on("request", (request) => { if (!/^(file|data):/.test(request.url())) problems.push("network: " + request.url()); });
  await page.goto(pathToFileURL(path.join(kOut, "index.html")).href);
  return {page, problems, close: () => context.close()};
}

/** A clip whose player is there and whose first picture is loaded. */
async function openClip(page, id) {
  const clip = page.locator("#" + id);
  await clip.scrollIntoViewIfNeeded();
  await clip.locator(".playhead").first().waitFor();
  await clip.locator("video").evaluate((video) => { video.preload = "auto"; });
  await page.waitForFunction((name) => document.querySelector("#" + name + " video").readyState >= 2, id);
  return clip;
}

const timeOf = (clip) => clip.locator("video").evaluate((video) => video.currentTime);
const isPaused = (clip) => clip.locator("video").evaluate((video) => video.paused);
const frameOf = async (clip) => Number(await clip.locator(".seek").inputValue());
const sampleAtPlayhead = async (clip, plot = 0) =>
  Number(await clip.locator(".playhead").nth(plot).getAttribute("data-index"));

async function waitForSeek(page, id) {
  await page.waitForFunction((name) => !document.querySelector("#" + name + " video").seeking, id);
}

async function playUntil(page, id, seconds) {
  await page.waitForFunction(([name, wanted]) => document.querySelector("#" + name + " video").currentTime > wanted,
    [id, seconds]);
}

describe("the page", () => {
  test("shows all figures in the overview, without a complaint and without a network", async () => {
    const {page, problems, close} = await open();
    assert.equal(await page.locator(".sheet li").count(), 3);
    for (const id of ["turns", "bursts"]) await openClip(page, id);
    const pictures = await page.locator("img").evaluateAll((images) => Promise.all(images.map((image) => {
      image.loading = "eager";
      return image.decode().then(() => image.naturalWidth > 0);
    })));
    assert.deepEqual(pictures, pictures.map(() => true));
    assert.deepEqual(problems, []);
    await close();
  });

  test("shows the words of scenes as words", async () => {
    const {page, close} = await open();
    assert.equal(await page.locator("#turns h2").textContent(), 'A <b>book</b> & "its" turn');
    assert.match(await page.locator("#turns .caption").textContent(), /<script>its<\/script> middle axis &/);
    await close();
  });

  test("tells expected from measured", async () => {
    const {page, close} = await open();
    const rows = await page.locator("#turns .checks tbody tr").allInnerTexts();
    assert.match(rows[0], /half_turns\s+at most 3\s+\d\s+✓ met/);
    assert.match(rows[1], /tilt_deg\s+at most 1\s+[\d.]+ to [\d.]+\s+✗ unmet/);
    assert.match(await page.locator("#turns > header").innerText(), /1 of 2 expectations met/);
    assert.match(await page.locator("#steps .checks").innerText(), /order of rk4\s+at least 3\s+[34]\.\d+\s+✓ met/);
    assert.match(await page.locator("#bursts .note").innerText(), /diverges at 0\.\d+ s/);
    await close();
  });

  test("links to files that are there", async () => {
    const {page, close} = await open();
    const links = await page.locator(".links a").evaluateAll((all) => all.map((link) => link.href));
    assert.ok(links.length >= 12, links.join(" "));
    for (const link of links) assert.ok(fs.existsSync(new URL(link)), link);
    await close();
  });
});

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

  test("stays within the clip", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
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
    for (const speed of ["0.1", "2", "0.5"]) {
      await clip.locator(".speed input").fill(speed);
      assert.equal(await clip.locator("video").evaluate((video) => video.playbackRate), Number(speed));
    }
    assert.equal(await clip.locator(".speed output").innerText(), "0.5×");
    await close();
  });

  test("loops unless told otherwise", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "turns");
    await clip.locator(".loop").click();
    assert.equal(await clip.locator(".loop").getAttribute("aria-pressed"), "false");
    await clip.locator(".speed input").fill("2");
    await clip.locator(".play").click();
    await page.waitForFunction(() => document.querySelector("#turns video").ended);
    assert.equal(await frameOf(clip), 89);
    await clip.locator(".loop").click();
    await clip.locator(".play").click();
    await page.waitForFunction(() => document.querySelector("#turns video").currentTime > 1.2);
    await page.waitForFunction(() => document.querySelector("#turns video").currentTime < 1);
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

  test("starts by itself where motion is welcome, one clip at a time", async () => {
    const {page, close} = await open({reducedMotion: "no-preference"});
    await openClip(page, "turns");
    await playUntil(page, "turns", 0.1);
    const other = await openClip(page, "bursts");
    await other.locator("video").scrollIntoViewIfNeeded();
    await page.waitForFunction(() => !document.querySelector("#bursts video").paused);
    await page.waitForFunction(() => document.querySelector("#turns video").paused);
    await close();
  });

  test("can be used without scripts", async () => {
    const {page, close} = await open({javaScriptEnabled: false});
    assert.ok(await page.locator("#turns video").getAttribute("controls") !== null);
    assert.ok(await page.locator("#turns .controls").isHidden());
    await close();
  });
});

describe("the look", () => {
  const ground = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);

  test("is light or dark as the system has it, or as is chosen", async () => {
    const {page, close} = await open({colorScheme: "light"});
    const light = await ground(page);
    await page.locator("#theme").click();
    const dark = await ground(page);
    assert.notEqual(light, dark);
    assert.equal(await page.locator("#theme").getAttribute("aria-pressed"), "true");
    await page.reload();
    assert.equal(await ground(page), dark);
    await page.locator("#theme").click();
    assert.equal(await ground(page), light);
    await close();
    const night = await open({colorScheme: "dark"});
    assert.equal(await ground(night.page), dark);
    await night.close();
  });

  test("draws the plots anew when it changes", async () => {
    const {page, close} = await open({colorScheme: "light"});
    const clip = await openClip(page, "turns");
    const canvas = clip.locator("canvas").first();
    const before = await canvas.evaluate((element) => element.toDataURL());
    await page.locator("#theme").click();
    await page.waitForFunction((old) => document.querySelector("#turns canvas").toDataURL() !== old, before);
    await close();
  });

  test("is readable: contrast is 4.5 at least", async () => {
    for (const colorScheme of ["light", "dark"]) {
      const {page, close} = await open({colorScheme});
      const ratios = await page.evaluate(() => {
        const style = getComputedStyle(document.documentElement);
        const luminance = (name) => {
          const hex = style.getPropertyValue(name).trim();
          const [r, g, b] = [1, 3, 5].map((at) => {
            const c = parseInt(hex.slice(at, at + 2), 16) / 255;
            return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
          });
          return 0.2126 * r + 0.7152 * g + 0.0722 * b;
        };
        const contrast = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        return ["--ink", "--soft", "--accent", "--good", "--bad"].flatMap((text) =>
          ["--ground", "--card"].map((under) => [text, under, contrast(luminance(text), luminance(under))]));
      });
      for (const [text, under, ratio] of ratios) assert.ok(ratio >= 4.5, `${text} on ${under}: ${ratio} (${colorScheme})`);
      await close();
    }
  });

  test("fits a phone: nothing is wider than the window", async () => {
    const {page, problems, close} = await open({viewport: kPhone, isMobile: true, hasTouch: true});
    await openClip(page, "turns");
    await page.locator("#steps").scrollIntoViewIfNeeded();
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= kPhone.width, `${width} > ${kPhone.width}`);
    assert.deepEqual(problems, []);
    await close();
  });

  test("names every control", async () => {
    const {page, close} = await open();
    await openClip(page, "turns");
    const unnamed = await page.locator("button:visible, input:visible").evaluateAll((all) => all.filter((control) =>
      !control.getAttribute("aria-label") && !control.textContent.trim() && !control.closest("label")).map((control) => control.outerHTML));
    assert.deepEqual(unnamed, []);
    await close();
  });

  test("is left as pictures to look at", async () => {
    for (const [name, options] of Object.entries({
      "light": {colorScheme: "light"}, "dark": {colorScheme: "dark"},
      "phone": {colorScheme: "light", viewport: kPhone, isMobile: true, hasTouch: true, deviceScaleFactor: 2},
    })) {
      const {page, close} = await open(options);
      for (const id of ["turns", "bursts"]) {
        const clip = await openClip(page, id);
        await clip.locator(".seek").fill("20");
        await waitForSeek(page, id);
      }
      const file = path.join(kOutput, `page-${name}.png`);
      await page.screenshot({path: file, fullPage: true});
      assert.ok(fs.statSync(file).size > 20000);
      await close();
    }
  });
});
