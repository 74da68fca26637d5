// The live book in German: whatever it says comes from the list of words, and none of it is English.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {after, before, test} = require("node:test");
const {pathToFileURL} = require("node:url");
const {kPlay, kOutput, startBrowser, closeBrowser, open, checksumOf, messageOf, load} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

/** Texts of the page that are in none of its script's words: numbers, names and marks. */
const kSame = /^[\d.,:/×%°s\s–‹›_-]*$|^[xyzjrf,.+0-]$|^(x|y|z|English|Deutsch|rotatebook render|exact|rk4|\d+\/\d+)$/;

/** Returns what the page says to eyes and ears. */
function saidOn(page) {
  return page.evaluate(() => {
    const said = new Set(), texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      if (!node.parentElement.closest("script, style, noscript, textarea")) said.add(node.data.trim());
    }
    for (const name of ["aria-label", "aria-roledescription", "title"]) {
      for (const element of document.body.querySelectorAll(`[${name}]`)) said.add(element.getAttribute(name));
    }
    return [...said].filter(Boolean);
  });
}

test("takes its language from the address, or else from the browser", async () => {
  const languageOf = async (options, address) => {
    const {page, close} = await open(options, {hash: address});
    const language = await page.evaluate(() => document.documentElement.lang), play = await page.locator(".rb-word").textContent();
    await close();
    return [language, play];
  };
  assert.deepEqual(await languageOf({}, ""), ["en", "Play"]);
  assert.deepEqual(await languageOf({locale: "de-AT"}, ""), ["de", "Abspielen"]);
  assert.deepEqual(await languageOf({locale: "de-AT"}, "?lang=en"), ["en", "Play"]);
  assert.deepEqual(await languageOf({locale: "fr-FR"}, ""), ["en", "Play"]);
  assert.deepEqual(await languageOf({}, "?lang=%22%5D"), ["en", "Play"]);
});

test("says everything in German, and what is played goes along", async () => {
  const {page, problems, close} = await open({}, {hash: "?lang=de"});
  await page.locator(".rb-more summary").click();
  await page.locator("[data-do=jiggle]").click();
  await checksumOf(page);
  assert.equal(await page.title(), "Das lebendige Buch");
  assert.match(await page.locator(".rb-checksum").textContent(), /^Prüfsumme dieser Bewegung: [0-9a-f]{32}$/);
  assert.match(await page.locator(".rb-time").textContent(), /^\d+,\d\d s$/);
  const english = await page.evaluate(() => Object.keys(JSON.parse(document.querySelector("script.words").textContent)));
  const german = await page.evaluate(() => Object.values(JSON.parse(document.querySelector("script.words").textContent)));
  const left = (await saidOn(page)).filter((text) => english.includes(text) && !german.includes(text));
  assert.deepEqual(left, []);
  const spin = await page.evaluate(() => rotatebook.player.scene.tree.nudge);
  await page.locator(".languages [lang=en]").click();
  await page.waitForFunction(() => document.documentElement.lang === "en" && document.querySelector(".rb-live").dataset.ready === "true");
  assert.deepEqual(await page.evaluate(() => rotatebook.player.scene.tree.nudge), spin);
  assert.deepEqual(problems, []);
  await close();
});

test("says nothing that isn't in the list", async () => {
  // A list of its own, in which each text is marked.
  const text = fs.readFileSync(kPlay, "utf8"), [, list] = /<script type="application\/json" class="words" lang="de">(.*?)<\/script>/s.exec(text);
  const marked = Object.fromEntries(Object.keys(JSON.parse(list)).map((english) => [english, english === "decimal_mark" ? "," : `«${english}»`]));
  const file = path.join(kOutput, "marked.html");
  fs.writeFileSync(file, text.replace(list, () => JSON.stringify(marked).replaceAll("<", "\\u003C")));
  const {page, close} = await open({}, {file: pathToFileURL(file).href, hash: "?lang=de"});
  const unmarked = async () => (await saidOn(page)).filter((said) => !said.includes("«") && !kSame.test(said));
  await page.locator(".rb-more summary").click();
  await page.locator("[data-do=predict]").click();
  assert.deepEqual(await unmarked(), []);
  await page.locator(".rb-answers button").first().click();
  assert.deepEqual(await unmarked(), []);
  await load(page, "[initial]\nangular_velocity = [4, 0, 0]\n[simulation]\nmodel = \"particles\"\n");
  await page.locator("input[value=exact]").last().check({force: true});
  const integrators = await page.locator("select option").allTextContents();
  assert.deepEqual((await unmarked()).filter((said) => !integrators.includes(said)), []);
  await page.evaluate(() => rotatebook.player.open(new File([new Uint8Array(9)], "a.mp4")));
  assert.equal(await messageOf(page) === "", false);
  await close();
});
