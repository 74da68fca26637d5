// The words of the page, in a real browser.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before, after, describe} = require("node:test");
const {kOut, startBrowser, closeBrowser, open, openClip} = require("./made_page.cjs");

before(startBrowser);
after(closeBrowser);

/** How many curves a plot draws: the colours of its legend that are in its picture. */
async function curvesDrawn(plot) {
  return plot.evaluate((element) => {
    const canvas = element.querySelector("canvas");
    const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const isDrawn = (colour) => {
      const [r, g, b] = colour.match(/\d+/g).map(Number);
      for (let at = 0; at < data.length; at += 4) {
        if (data[at + 3] > 200 && Math.abs(data[at] - r) + Math.abs(data[at + 1] - g) + Math.abs(data[at + 2] - b) < 24) return true;
      }
      return false;
    };
    return [...element.querySelectorAll(".legend i")].filter((line) => isDrawn(getComputedStyle(line).borderTopColor)).length;
  });
}

describe("the page", () => {
  test("says in German what its scripts and templates say, and writes numbers so", async () => {
    const {page, problems, close} = await open({}, {name: "german.html"});
    const clip = await openClip(page, "turns");
    const list = JSON.parse(await page.locator("script.words").textContent());
    const said = await page.evaluate(() => {
      const texts = [], walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
      for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        if (!node.parentElement.closest("script, style, pre, .name")) texts.push(node.data.trim());
      }
      for (const name of ["aria-label", "title", "aria-valuetext", "alt", "label"]) {
        for (const element of document.body.querySelectorAll(`[${name}]`)) texts.push(element.getAttribute(name));
      }
      return texts;
    });
    assert.deepEqual(said.filter((text) => text in list && !Object.values(list).includes(text)), []);
    assert.equal(await clip.locator(".time").textContent(), "0,75 s · Bild 45");
    assert.match(await clip.locator(".curves").first().getAttribute("aria-label"), /^Energie .* von 1 bis \d,\d+$/);
    await clip.locator(".play").click();
    await clip.locator(".play[aria-label=Anhalten]").waitFor();  // Once the video plays.
    assert.deepEqual(problems, []);
    await close();
  });

  test("shows all figures in the overview, without a complaint and without a network", async () => {
    const {page, problems, close} = await open();
    assert.equal(await page.locator(".sheet li").count(), 6);
    for (const id of ["turns", "bursts", "pair"]) await openClip(page, id);
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

  test("says a caption that is in the picture once to the eye, and always to readers", async () => {
    for (const [width, isSeen] of [[1280, false], [390, true]]) {
      const {page, close} = await open({viewport: {width, height: 800}});
      const heightOf = async (id) => (await page.locator(`#${id} .caption`).boundingBox()).height;
      assert.equal(await heightOf("book") > 20, isSeen, `${width} pixels`);
      assert.ok(await heightOf("turns") > 20, "its picture doesn't say it");
      assert.match(await page.locator("#book figure").ariaSnapshot(), /A still\./);
      await close();
    }
  });

  test("names files only beside them", async () => {
    const {page, close} = await open();
    assert.deepEqual(await page.locator(".links .name").allTextContents(), ["turns", "matrix-steps", "bursts", "recorded-defaults", "pair", "book"]);
    assert.ok(!(await page.locator("header, .sheet").allTextContents()).join().includes("matrix-steps"));
    await page.locator("#bursts h2 a").click();
    assert.equal(new URL(page.url()).hash, "#bursts");
    await close();
  });

  test("tells expected from measured", async () => {
    const {page, close} = await open();
    const rows = await page.locator("#turns .checks tbody tr").allInnerTexts();
    assert.match(rows[0], /half_turns\s+how many times.*\s+at most 3\s+\d\s+✓ met/);
    assert.match(rows[1], /tilt_deg\s+angle between.*\s+at most 1\s+[\d.]+ to [\d.]+\s+✗ not met/);
    assert.match(await page.locator("#turns > header").innerText(), /1 of 2 expectations met/);
    await page.locator("#matrix-steps .expectations summary").click();
    assert.match(await page.locator("#matrix-steps .checks").innerText(), /order of rk4\s+power of the step.*\s+at least 3\s+[34]\.\d+\s+✓ met/);
    assert.match(await page.locator("#bursts .note").innerText(), /diverges at 0\.\d+ s/);
    await close();
  });

  test("begins with two sentences and the first figure, large and whole", async () => {
    const {page, close} = await open({viewport: {width: 1400, height: 900}});
    const boxOf = (selector) => page.locator(selector).first().boundingBox();
    const words = await page.locator(".intro").innerText();
    assert.equal(words.match(/[.](\s|$)/g).length, 2, words);
    const [intro, video, controls, overview] = await Promise.all([".intro", ".lead #turns video", "#turns .controls", "[id='page/overview']"].map(boxOf));
    assert.ok(intro.y + intro.height < video.y && video.y < overview.y);
    assert.ok(video.width > 900, `${video.width} pixels wide`);  // measured 1031
    assert.ok(controls.y + controls.height <= 900, `controls down to ${controls.y + controls.height}`);  // measured 858
    await close();
  });

  test("folds expectations away, but not unmet ones", async () => {
    const {page, close} = await open();
    const openOnes = await page.locator(".expectations").evaluateAll((all) => all.map((one) => [one.closest(".figure").id, one.open]));
    assert.deepEqual(openOnes, [["turns", true], ["matrix-steps", false], ["pair", true]]);
    assert.equal(await page.locator("#matrix-steps .expectations summary").innerText(), "1 of 1 expectation met");
    assert.ok(await page.locator("#matrix-steps .checks").isHidden());
    const ofOverview = await page.locator(".sheet .badge").evaluateAll((all) => all.map((one) => [one.closest("li").querySelector("a").hash.slice(1), one.innerText]));
    assert.deepEqual(ofOverview, [["turns", "1 of 2 expectations met"], ["pair", "1 of 3 expectations met"]]);
    await close();
  });

  test("has an overview of pictures", async () => {
    const {page, close} = await open();
    const sources = await page.locator(".sheet img").evaluateAll((all) => all.map((image) => image.getAttribute("src")));
    assert.deepEqual(sources.filter((name) => !name.endsWith(".svg")), ["bursts", "recorded-defaults", "turns", "pair", "book"].map((id) => id + ".thumbnail.png"));
    assert.equal(await page.locator(".sheet a[href='#matrix-steps'] img[src='matrix-steps-study.svg']").count(), 1);
    await close();
  });

  test("has a curve, a table and a CSV for each panel of a comparison", async () => {
    const {page, close} = await open();
    const clip = await openClip(page, "pair");
    const panels = ["in steps", "exact"];
    for (const plot of await clip.locator(".plot").all()) {
      assert.deepEqual(await plot.locator(".legend li").evaluateAll((all) => all.map((item) => item.firstElementChild.nextSibling.data.trim())), panels);
    }
    assert.deepEqual(await curvesDrawn(clip.locator(".plot").nth(1)), panels.length);
    const captions = await clip.locator(".checks caption").allInnerTexts();
    assert.deepEqual(captions, panels.map((label) => "Expected and measured: " + label));
    for (const [label, file] of [["in steps", "pair_in-steps.csv"], ["exact", "pair_exact.csv"]]) {
      const link = await clip.locator(".links a", {hasText: "CSV: " + label}).getAttribute("href");
      assert.equal(link, file);
      assert.ok(fs.existsSync(path.join(kOut, link)), link);
    }
    await close();
  });

  test("tells of a still only what it shows", async () => {
    const {page, close} = await open();
    assert.equal(await page.locator("#book img").getAttribute("src"), "book.png");
    assert.doesNotMatch(await page.locator("#book").innerText(), /exact|Settings|Integrator|closed form/);
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
