#!/usr/bin/env node
// Measures the live book: pictures a second, their size, and processor time a picture.
//
// live_book.cjs PLAY.html [chromium|firefox [WIDTHxHEIGHT [SECONDS]]], NODE_PATH=drivers of tests/browser/player/run; Firefox under xvfb-run.
"use strict";

const fs = require("node:fs");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {execFileSync} = require("node:child_process");

const kTicks = Number(execFileSync("getconf", ["CLK_TCK"], {encoding: "utf8"}));

/** Returns the processor time [s] that the processes which this one has started have taken by now. */
function processorTime() {
  const all = new Map();
  for (const name of fs.readdirSync("/proc").filter((entry) => /^\d+$/.test(entry))) {
    try {
      const fields = fs.readFileSync(`/proc/${name}/stat`, "utf8").replace(/^.*\) /, "").split(" ");
      all.set(Number(name), {parent: Number(fields[1]), time: (Number(fields[11]) + Number(fields[12])) / kTicks});
    } catch { /* It has ended. */ }
  }
  const isOurs = (id) => id === process.pid || (all.has(id) && isOurs(all.get(id).parent));
  return [...all].reduce((sum, [id, {time}]) => sum + (id !== process.pid && isOurs(id) ? time : 0), 0);
}

async function openChromium(width, height) {
  const browser = await require("playwright-core").chromium.launch({executablePath: "/usr/bin/chromium", chromiumSandbox: false,
    args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]});
  const page = await browser.newPage({viewport: {width, height}});
  return {browser, page};
}

async function openFirefox(width, height) {
  const browser = await require("puppeteer-core").launch({browser: "firefox", executablePath: "/usr/bin/firefox-esr", headless: false,
    defaultViewport: {width, height}});
  return {browser, page: await browser.newPage()};
}

/** Counts pictures for some seconds while the book moves; runs in the page. */
async function countPictures(seconds) {
  const {player} = rotatebook, {drawing} = player;
  const wait = (time) => new Promise((resolve) => { setTimeout(resolve, time); });
  player.start();
  while (!player.isComplete) await wait(50);
  await wait(3000);  // Until the picture has the size that this machine draws in time.
  let pictures = 0, script = 0;
  const draw = drawing.draw, tick = player.tick;
  drawing.draw = function(...values) { pictures += 1; return draw.apply(this, values); };
  player.tick = function(...values) {
    const start = performance.now();
    tick.apply(this, values);
    script += performance.now() - start;
  };
  await beginCount();
  const start = performance.now();
  await wait(1000 * seconds);
  const passed = (performance.now() - start) / 1000;
  await endCount();
  delete drawing.draw;
  delete player.tick;
  return {pictures, passed, script, width: drawing.picture.width, height: drawing.picture.height, box: drawing.box};
}

async function main([play, name = "chromium", size = "1280x720", seconds = "8"]) {
  const [width, height] = size.split("x").map(Number);
  const {browser, page} = await (name === "firefox" ? openFirefox : openChromium)(width, height);
  let processor = 0;
  await page.exposeFunction("beginCount", () => { processor = -processorTime(); });
  await page.exposeFunction("endCount", () => { processor += processorTime(); });
  await page.goto(pathToFileURL(path.resolve(play)).href);
  await page.waitForFunction(() => document.querySelector(".rb-live").dataset.ready === "true");
  const all = await page.evaluate(countPictures, Number(seconds));
  await browser.close();
  const {pictures, passed, script, box} = all;
  console.log(`${name}, window ${size}, picture ${box.width}x${box.height} drawn as ${all.width}x${all.height}: ` +
    `${(pictures / passed).toFixed(1)} pictures/s, ${(1000 * processor / pictures).toFixed(1)} ms of processor a picture, ` +
    `${(script / pictures).toFixed(2)} ms of them in the page's script`);
}

main(process.argv.slice(2));
