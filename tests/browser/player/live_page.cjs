// The live book in Chromium, clips to drop on it, and what the tests ask of it.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const nodeTest = require("node:test");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {execFileSync, spawnSync} = require("node:child_process");
const {chromium} = require("playwright-core");

const kRoot = path.join(__dirname, "../../..");
const kPlay = path.resolve(process.env.ROTATEBOOK_PLAY), kOutput = path.resolve(process.env.ROTATEBOOK_PLAY_OUTPUT);
const kWait = 30000;  // [ms]
const kSmall = {width: 640, height: 900};  // A software rasteriser draws for the tests.

const kTurns = `title = "A book that turns over"
[simulation]
integrator = "euler"
[initial]
angular_velocity = [6.0, 0.0, 0.0]
tilt = [0.1, "z"]
[clip]
size = [64, 36]
duration = 1.5
`;

let browser;

async function startBrowser(...more) {
  browser = await chromium.launch({executablePath: "/usr/bin/chromium", chromiumSandbox: false,
    args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--js-flags=--expose-gc", ...more]});
}

const closeBrowser = () => browser?.close();

function rotatebook(...words) {
  return execFileSync(process.env.ROTATEBOOK_PROGRAM, words, {cwd: kOutput, encoding: "utf8", stdio: "pipe"});
}

/** Verifies a clip; returns the status and what is said. */
function verify(file) {
  const {status, stdout, stderr} = spawnSync(process.env.ROTATEBOOK_PROGRAM, ["verify", file], {cwd: kOutput, encoding: "utf8"});
  return {status, output: stdout + stderr};
}

/** Renders a scene's text as the smallest of clips; returns the file's name. */
function render(name, text, format = "mp4") {
  const folder = path.join(kOutput, "clips"), scene = path.join(folder, name + ".toml");
  fs.mkdirSync(folder, {recursive: true});
  fs.writeFileSync(scene, text);
  try {
    rotatebook("render", scene, "-o", folder, "--no-png", "--overwrite", "--size", "64x36", "--format", format);
  } catch (error) {
    assert.equal(error.status, 1, error.stderr);  // Only an expectation is unmet.
  }
  return path.join(folder, `${name}.${format}`);
}

/** Loads scripts of the player; returns what of theirs is named. */
function playerScripts(files, names) {
  const paths = ["assets/page/words.js", ...files.map((file) => `src/browser/player/${file}.js`)];
  const text = paths.map((file) => fs.readFileSync(path.join(kRoot, file), "utf8")).join("\n");
  return new Function(`${text}\nreturn {${names.join(", ")}};`)();
}

/** Returns a core of its own, of the classes that playerScripts() returned. */
async function coreFor({Core}) {
  const core = path.join(path.dirname(kPlay), "rotatebook_core");
  return new Core(await require(core + ".js")({wasmBinary: fs.readFileSync(core + ".wasm")}));
}

/** Returns the record of a clip's file. */
async function recordOf(file) {
  const scripts = playerScripts(["share", "record", "core"], ["readRecord", "Core"]);
  return scripts.readRecord(await coreFor(scripts), new Blob([fs.readFileSync(file)]));
}

/** Both pages with the live book: their files, made at a call. */
const kPages = {play: () => kPlay, index: pageOfFigures};
let played = null;
/** The page that the suite is run with, and its file. */
const kPlayed = process.env.ROTATEBOOK_PLAYED ?? "play", playedFile = () => played ??= kPages[kPlayed]();

/** A test for which it doesn't matter what is around the live book: it is run with play.html alone. */
const testOnce = (...test) => { if (kPlayed === "play") nodeTest.test(...test); };

/** Opens the page; `problems` grows with whatever the browser complains of or asks a network for. */
async function open(options = {}, {hash = "", script = null, isReady = "true", file = pathToFileURL(playedFile()).href} = {}) {
  const context = await browser.newContext({viewport: kSmall, reducedMotion: "reduce", ...options});
  const page = await context.newPage();
  if (script) await page.addInitScript(script);
  page.setDefaultTimeout(kWait);
  const problems = [];
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) problems.push(message.text()); });
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) problems.push("network: " + request.url()); });
  await page.goto(file + hash);
  if (isReady) await page.waitForFunction((wanted) => document.querySelector(".rb-live").dataset.ready === wanted, isReady);
  return {page, problems, close: () => context.close()};
}

/** Returns what axe finds wrong with the page. */
async function violations(page) {
  await page.evaluate(fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8"));
  const result = await page.evaluate(() => axe.run(document, {resultTypes: ["violations", "incomplete"]}));
  return result.violations.map(({id, nodes}) => `${id}: ${nodes.map(({html}) => html.slice(0, 120)).join(" | ")}`);
}

/** Makes a page of figures with the live book, and a table of contents. */
function pageOfFigures() {
  const scenes = ["turns", "turns-too"].map((name) => render(name, kTurns.replace("turns over", name)).replace(/mp4$/, "toml")), folder = path.dirname(scenes[0]);
  rotatebook("page", ...scenes, "-o", folder, "--size", "64x36", "--live", path.join(path.dirname(kPlay), "live_book.html"));
  return path.join(folder, "index.html");
}

/** Until the motion is simulated to its end; returns its checksum. */
async function checksumOf(page) {
  await page.waitForFunction(() => rotatebook.player.checksum !== null, null, {timeout: 120000});
  return page.evaluate(() => rotatebook.player.checksum);
}

const frameOf = (page) => page.evaluate(() => rotatebook.player.frame);
const sceneOf = (page) => page.evaluate(() => rotatebook.player.scene.tree);
const messageOf = (page) => page.locator(".rb-message").textContent();
const load = (page, text) => page.evaluate((scene) => rotatebook.player.load(scene, {isPlaying: false}), text);

module.exports = {kRoot, kPlay, kOutput, kTurns, startBrowser, closeBrowser, rotatebook, verify, render, playerScripts, coreFor, recordOf, open, violations, kPages, kPlayed, playedFile, testOnce, pageOfFigures, checksumOf, frameOf, sceneOf, messageOf, load};
