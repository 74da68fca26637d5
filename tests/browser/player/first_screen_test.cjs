// What it takes to throw a book and to see why is on the first screen, in both pages.
"use strict";

const assert = require("node:assert/strict");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {test, before, after} = require("node:test");
const {kOutput, kPlay, kTurns, startBrowser, closeBrowser, open, render, rotatebook} = require("./live_page.cjs");

const kSizes = [[1366, 768], [1024, 768], [390, 844]];
const kControls = [".rb-throws button", ".rb-views label", ".rb-views button", ".rb-transport button", ".rb-timeline", ".rb-speed select"];

before(() => startBrowser());
after(closeBrowser);

/** Makes a page of figures with the live book, and a table of contents. */
function pageOfFigures() {
  const scenes = ["turns", "turns-too"].map((name) => render(name, kTurns).replace(/mp4$/, "toml")), folder = path.dirname(scenes[0]);
  rotatebook("page", ...scenes, "-o", folder, "--size", "64x36", "--live", path.join(path.dirname(kPlay), "live_book.html"));
  return path.join(folder, "index.html");
}

/** Returns what is wrong with the controls: outside the window, beneath something, over one another. */
const faultsOf = (page) => page.evaluate((selectors) => {
  const controls = selectors.flatMap((selector) => [...document.querySelectorAll(selector)]).filter((element) => element.offsetParent), faults = [];
  const nameOf = (element) => element.textContent.trim() || element.className || element.tagName;
  controls.forEach((element, i) => {
    const box = element.getBoundingClientRect();
    if (box.top < 0 || box.left < 0 || box.bottom > innerHeight || box.right > innerWidth) faults.push(`${nameOf(element)}: ${box.left}, ${box.top} to ${box.right}, ${box.bottom}`);
    for (const [x, y] of [[box.left + box.width / 2, box.top + box.height / 2], [box.left + box.width / 2, box.bottom - 3]]) {
      const top = document.elementFromPoint(x, y);
      if (!element.contains(top)) faults.push(`${nameOf(element)} is beneath ${top?.outerHTML.slice(0, 80)}`);
    }
    for (const other of controls.slice(i + 1)) {
      const its = other.getBoundingClientRect();
      if (box.left < its.right && its.left < box.right && box.top < its.bottom && its.top < box.bottom) faults.push(`${nameOf(element)} over ${nameOf(other)}`);
    }
  });
  return {faults, count: controls.length, scrolled: scrollY};
}, kControls);

for (const name of ["play", "index"]) {
  for (const [width, height] of kSizes) {
    test(`all is there in ${name}.html at ${width} x ${height}`, async () => {
      const file = name === "play" ? kPlay : pageOfFigures();
      const {page, problems, close} = await open({viewport: {width, height}}, {file: pathToFileURL(file).href});
      await page.screenshot({path: path.join(kOutput, `first-${name}-${width}.png`)});
      const {faults, count, scrolled} = await faultsOf(page);
      assert.deepEqual([faults, count, scrolled], [[], 12, 0]);
      await page.getByRole("button", {name: "why"}).click();
      await page.waitForFunction(() => !document.querySelector(".rb-legend").hidden);
      await page.screenshot({path: path.join(kOutput, `why-${name}-${width}.png`)});
      assert.deepEqual((await faultsOf(page)).faults, []);
      assert.deepEqual(problems, []);
      await close();
    });
  }
}
