// The page that tests look at: three clips, one of which diverges, one folded away; a comparison, a still and a study.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {execFileSync} = require("node:child_process");
const {chromium} = require(process.env.ROTATEBOOK_PLAYWRIGHT);

const kOutput = process.env.ROTATEBOOK_PAGE_OUTPUT, kOut = path.join(kOutput, "out"), kMoving = path.join(kOutput, "moving");
const kDesktop = {width: 1280, height: 800};
const kWait = 20000;  // [ms]

const kScenes = {
  "turns.toml": `title = "A <b>book</b> & \\"its\\" turn"
caption = "It turns about <script>its</script> middle axis & nothing else."
[simulation]
integrator = "euler"
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
  "pair.toml": `title = "Two models"
[simulation]
integrator = "euler"
[initial]
angular_velocity = [5.0, 3.0, 1.0]
[clip]
size = [160, 90]
fps = 24
duration = 0.5
[[panel]]
label = "in steps"
simulation.substeps = 1
expect.error_deg = [{ max = 0.5 }, { max = 0.5, from = 0.2, to = 0.45 }]
[[panel]]
label = "exact"
simulation.model = "exact"
expect.rotational_ratio = { min = 0.999999, max = 1.000001, from = 0.125, to = 0.375 }
`,
  "recorded-defaults.toml": `title = "Folded away"
[initial]
angular_velocity = [5.0, 3.0, 1.0]
[clip]
size = [160, 90]
fps = 24
duration = 0.5
`,
  "book.toml": `title = "A book"
caption = "A still."
[simulation]
model = "exact"
[initial]
angular_velocity = [4.0, 0.0, 0.0]
[clip]
size = [160, 90]
duration = 1
[overlay]
show = ["caption"]
`,
  "matrix-steps.toml": `title = "Two integrators"
caption = "A study."
[initial]
angular_velocity = [2.0, 3.0, -4.0]
[clip]
fps = 15
duration = 1
[study]
x = { key = "simulation.substeps", values = [1, 2, 4, 8] }
curves = { key = "simulation.integrator", values = ["euler", "rk4"] }
expect = [{ of = "order", curve = "rk4", min = 3 }]
`,
};

let browser;
// By their options but the window's size. A new context, and a page that is alone in it, take processes of their own: half a second.
const contexts = new Map();
let left = null;  // The page that was closed last is there until the next one is.

function rotatebook(...words) {
  return execFileSync(process.env.ROTATEBOOK_PROGRAM, words, {cwd: kOutput, encoding: "utf8", stdio: "pipe"});
}

/** Exit status 1 only says that an expectation is unmet, as one of turns.toml is. */
function render(...words) {
  try {
    rotatebook("render", ...words);
  } catch (error) {
    assert.equal(error.status, 1, error.stderr);
  }
}

function makePage() {
  for (const folder of [kOut, kMoving]) fs.rmSync(folder, {recursive: true, force: true});
  fs.writeFileSync(path.join(kOutput, "moves.toml"), kScenes["pair.toml"].replace("Two models", "Two models, moving"));
  for (const [name, text] of Object.entries(kScenes)) fs.writeFileSync(path.join(kOutput, name), text);
  render("turns.toml", "bursts.toml", "pair.toml", "recorded-defaults.toml", "-o", kOut);
  rotatebook("still", "book.toml", "--time", "0", "-o", path.join(kOut, "book.png"));
  rotatebook("study", "matrix-steps.toml", "-o", kOut);
  const fragment = path.join(kOutput, "fragment.html");
  fs.writeFileSync(fragment, "<h2>The live book</h2>");
  rotatebook("page", ...Object.keys(kScenes), "-o", kOut, "--live", fragment);
  fs.renameSync(path.join(kOut, "index.html"), path.join(kOut, "live.html"));
  rotatebook("page", ...Object.keys(kScenes), "-o", kOut, "--no-thumbnails", "--language", "german");
  fs.renameSync(path.join(kOut, "index.html"), path.join(kOut, "german.html"));
  rotatebook("page", ...Object.keys(kScenes), "-o", kOut);
  render("moves.toml", "-o", kMoving, "--no-png", "--format", "gif");
  rotatebook("page", "moves.toml", "-o", kMoving);
}

async function startBrowser() {
  browser = await chromium.launch({executablePath: process.env.CHROMIUM, chromiumSandbox: false});
}

const closeBrowser = () => browser?.close();

async function newPage({viewport = kDesktop, ...options}) {
  const key = JSON.stringify(options);
  if (!contexts.has(key)) contexts.set(key, await browser.newContext({viewport, reducedMotion: "reduce", ...options}));
  const page = await contexts.get(key).newPage();
  await page.setViewportSize(viewport);
  return page;
}

/**
 * Opens the page, or another `name` of it, or that at an `address`, at `place` if there is one ("#turns"), after `script` has run in it; `problems` grows with whatever the
 * browser complains of or asks a network for.
 */
async function open(options = {}, {place = "", script = null, name = "index.html", address = ""} = {}) {
  const page = await newPage(options);
  if (script) await page.addInitScript(script);
  page.setDefaultTimeout(kWait);
  const problems = [];
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) problems.push(message.text()); });
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("requestfailed", (request) => {
    // The browser breaks off loads that it needs no more.
    if (request.failure()?.errorText !== "net::ERR_ABORTED") problems.push("failed: " + request.url());
  });
  page.on("request", (request) => { if (!/^(file|data):/.test(request.url()) && !(address && request.url().startsWith(address))) problems.push("network: " + request.url()); });
  await page.goto((address || pathToFileURL(path.join(kOut, name)).href) + place);
  await left?.close();
  left = null;
  const close = async () => {
    if (options.javaScriptEnabled !== false) await page.evaluate(() => localStorage.clear());
    left = page;
  };
  return {page, problems, close};
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

/** Until the video is at the frame that the player tells. */
async function waitForSeek(page, id) {
  await page.waitForFunction((name) => {
    const find = (selector) => document.querySelector("#" + name + " " + selector);
    const {rate} = JSON.parse(find("script.data").textContent);
    const video = find("video");
    const {value, max} = find(".seek");
    // At its end, a video's time is the end of its last frame.
    return !video.seeking && Math.min(Math.floor(video.currentTime * rate[0] / rate[1]), Number(max)) === Number(value);
  }, id);
}

module.exports = {kOutput, kOut, kMoving, makePage, startBrowser, closeBrowser, open, openClip, waitForSeek};

if (require.main === module) makePage();
