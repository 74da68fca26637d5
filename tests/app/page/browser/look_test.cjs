// The look of the page, in a real browser. Screenshots are left in the output folder.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before, after, describe} = require("node:test");
const {kOutput, startBrowser, closeBrowser, open, openClip, waitForSeek} = require("./made_page.cjs");

before(startBrowser);
after(closeBrowser);

const kPhone = {width: 390, height: 844};
const kSmallPhone = {width: 360, height: 740};

describe("the look", () => {
  const ground = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);

  test("is light or dark as the system has it, or as is chosen", async () => {
    const {page, close} = await open({colorScheme: "light"});
    const theme = page.getByRole("button", {name: /^Switch to (light|dark)$/});
    const light = await ground(page);
    assert.equal(await theme.innerText(), "Switch to dark");
    await theme.click();
    const dark = await ground(page);
    assert.notEqual(light, dark);
    assert.equal(await theme.innerText(), "Switch to light");
    await page.reload();
    assert.equal(await ground(page), dark);
    assert.equal(await theme.innerText(), "Switch to light");
    await theme.click();
    assert.equal(await ground(page), light);
    await page.emulateMedia({colorScheme: "dark"});
    assert.equal(await ground(page), light, "a choice outlasts the system's");
    await close();
    const night = await open({colorScheme: "dark"});
    assert.equal(await ground(night.page), dark);
    assert.equal(await night.page.locator(".theme").innerText(), "Switch to light");
    await night.page.emulateMedia({colorScheme: "light"});
    assert.equal(await ground(night.page), light);
    // The system's choice is an event, which comes in its own time.
    await night.page.getByRole("button", {name: "Switch to dark"}).waitFor();
    await night.close();
  });

  test("is dark without scripts, too", async () => {
    const grounds = [];
    for (const colorScheme of ["light", "dark"]) {
      const {page, close} = await open({colorScheme, javaScriptEnabled: false});
      assert.ok(await page.locator(".theme").isHidden());
      grounds.push((await page.locator("body").screenshot({clip: {x: 0, y: 0, width: 8, height: 8}})).toString("base64"));
      await close();
    }
    assert.notEqual(...grounds);
  });

  test("draws the plots anew when it changes", async () => {
    const {page, close} = await open({colorScheme: "light"});
    const clip = await openClip(page, "turns");
    const canvas = clip.locator("canvas").first();
    const before = await canvas.evaluate((element) => element.toDataURL());
    await page.locator(".theme").click();
    await page.waitForFunction((old) => document.querySelector("#turns canvas").toDataURL() !== old, before);
    await close();
  });

  test("is readable: contrast is 4.5 at least", async () => {
    for (const colorScheme of ["light", "dark"]) {
      const {page, close} = await open({colorScheme});
      const ratios = await page.evaluate(() => {
        const luminance = (name) => {
          const [r, g, b] = colourOf(name).match(/\d+/g).map((part) => {
            const c = part / 255;
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

  test("fits a phone: nothing is wider than the window, and no verdict is cut off", async () => {
    for (const viewport of [kPhone, kSmallPhone]) {
      const {page, problems, close} = await open({viewport, isMobile: true, hasTouch: true});
      for (const id of ["turns", "pair"]) await openClip(page, id);
      await page.locator("#matrix-steps").scrollIntoViewIfNeeded();
      await page.locator("details").evaluateAll((all) => all.forEach((one) => { one.open = true; }));
      const {content, tables, verdicts} = await page.evaluate(() => {
        const boxes = (selector) => [...document.querySelectorAll(selector)].map((element) => element.getBoundingClientRect());
        return {
          content: document.documentElement.scrollWidth,
          tables: [...document.querySelectorAll(".checks")].map((table) => table.parentElement.scrollWidth - table.parentElement.clientWidth),
          verdicts: boxes("td.met, td.unmet").map(({left, right, height}) => ({left, right, height})),
        };
      });
      assert.ok(content <= viewport.width, `${content} > ${viewport.width}`);
      assert.deepEqual(tables, tables.map(() => 0), "a table is wider than its place");
      assert.ok(verdicts.length >= 4);
      for (const {left, right, height} of verdicts) assert.ok(left >= 0 && right <= viewport.width && height > 0, `a verdict from ${left} to ${right}`);
      assert.deepEqual(problems, []);
      await close();
    }
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
      "phone-dark": {colorScheme: "dark", viewport: kPhone, isMobile: true, hasTouch: true, deviceScaleFactor: 2},
    })) {
      const {page, close} = await open(options);
      for (const id of ["turns", "bursts", "pair"]) {
        const clip = await openClip(page, id);
        await clip.locator(".seek").fill("10");
        await waitForSeek(page, id);
      }
      const file = path.join(kOutput, `page-${name}.png`);
      await page.screenshot({path: file, fullPage: true});
      assert.ok(fs.statSync(file).size > 20000);
      await close();
    }
  });
});
