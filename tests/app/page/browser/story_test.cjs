// The page as a whole, in a real browser: contents, keys, loading, the live book's place, print, accessibility.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const http = require("node:http");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {test, before, after, describe} = require("node:test");
const {kOut, kOutput, kMoving, startBrowser, closeBrowser, open, openClip} = require("./made_page.cjs");

before(startBrowser);
after(closeBrowser);

// As they come on the page: "matrix-steps" and "bursts" are in the story, and so is "recorded-defaults", folded away; the others aren't. The first of
// the command is the lead.
const kIds = ["turns", "matrix-steps", "bursts", "pair", "book"];
const kInContents = ["matrix-steps", "bursts", "recorded-defaults", "turns", "pair", "book"];
const kWidths = [390, 768, 1280, 1440];
const kAxe = path.join(process.env.ROTATEBOOK_PLAYWRIGHT, "..", "axe-core", "axe.min.js");

const atTop = (page) => page.evaluate(() => document.elementsFromPoint(innerWidth * 0.6, 120).map((one) => one.closest(".figure")?.id).find(Boolean));

/** Serves the page's folder, with ranges, and counts the bytes of each file that are asked for. */
async function serve() {
  const sent = new Map();
  const server = http.createServer((request, response) => {
    const name = decodeURIComponent(new URL(request.url, "http://a").pathname.slice(1)) || "index.html";
    const file = path.join(kOut, name);
    if (!fs.existsSync(file)) { response.writeHead(404).end(); return; }
    const bytes = fs.readFileSync(file);
    const range = /bytes=(\d+)-(\d*)/.exec(request.headers.range ?? "");
    const first = range ? Number(range[1]) : 0, last = range?.[2] ? Number(range[2]) : bytes.length - 1;
    const type = {".html": "text/html", ".mp4": "video/mp4", ".png": "image/png", ".svg": "image/svg+xml"}[path.extname(name)];
    const head = {"content-type": type ?? "text/plain", "accept-ranges": "bytes", "content-length": last - first + 1};
    if (range) head["content-range"] = `bytes ${first}-${last}/${bytes.length}`;
    response.writeHead(range ? 206 : 200, head);
    sent.set(name, (sent.get(name) ?? 0) + last - first + 1);
    response.end(bytes.subarray(first, last + 1));
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {sent, address: `http://127.0.0.1:${server.address().port}/`, close: () => { server.closeAllConnections(); server.close(); }};
}

describe("the list of contents", () => {
  test("has all figures, and is always in sight", async () => {
    for (const width of kWidths) {
      const {page, close} = await open({viewport: {width, height: 800}});
      const summary = page.locator(".contents summary");
      if (await summary.isVisible()) await summary.click();
      assert.deepEqual(await page.locator(".contents li li a").evaluateAll((all) => all.map((link) => link.hash.slice(1))), kInContents);
      await page.locator(".contents a[href='#book']").click();
      await page.waitForTimeout(300);
      assert.equal(await page.locator(".contents [aria-current]").getAttribute("href"), "#book");
      const {y, height} = await page.locator(".contents").boundingBox();
      assert.ok(y >= 0 && y + height <= 801, `from ${y} to ${y + height}`);
      await close();
    }
  });

  test("has the live book and the overview, too", async () => {
    for (const [name, parts] of [["index.html", ["#page/overview"]], ["live.html", ["#page/live", "#page/overview"]]]) {
      const {page, close} = await open({viewport: {width: 390, height: 800}}, {name});
      const links = await page.locator(".contents .of-chapter").evaluateAll((all) => all.map((link) => link.getAttribute("href")));
      assert.deepEqual(links.filter((link) => link.startsWith("#page/")), parts);
      await close();
    }
  });

  test("opens at the reader's place where it covers the page", async () => {
    const {page, close} = await open({viewport: {width: 390, height: 320}}, {place: "#book"});
    await page.locator(".contents [aria-current][href='#book']").waitFor({state: "attached"});
    const before = await page.evaluate(() => scrollY);
    await page.locator(".contents summary").click();
    await page.waitForFunction(() => document.querySelector(".contents details > ol").scrollTop > 0);
    const [list, link] = await Promise.all([".contents details > ol", ".contents [aria-current]"].map((one) => page.locator(one).boundingBox()));
    assert.ok(link.y >= list.y && link.y + link.height <= list.y + list.height, `from ${link.y} in a list from ${list.y}, ${list.height} high`);
    assert.equal(await page.evaluate(() => scrollY), before);
    await close();
  });

  test("goes to the next and the previous figure, by keys, too", async () => {
    const {page, close} = await open();
    assert.equal(await atTop(page), undefined);
    for (const id of kIds) {
      await page.keyboard.press("ArrowRight");
      if (id !== "book") assert.equal(await atTop(page), id);
      assert.equal(new URL(page.url()).hash, "#" + id);
    }
    await page.locator(".contents .previous").click();
    assert.notEqual(await atTop(page), "book");
    const hash = page.url();
    await page.locator("#turns .seek").focus();
    await page.keyboard.press("ArrowRight");
    assert.equal(page.url(), hash, "arrows move a slider that has the focus");
    await close();
  });

  test("closes by escape where it covers the page", async () => {
    const {page, close} = await open({viewport: {width: 390, height: 800}});
    await page.locator(".contents summary").click();
    await page.keyboard.press("Escape");
    assert.ok(!await page.locator(".contents details").evaluate((one) => one.open));
    await close();
  });
});

describe("loading", () => {
  test("of a clip begins when it is wanted, and happens once", async () => {
    const server = await serve();
    const {page, close} = await open({reducedMotion: "no-preference"}, {address: server.address});
    const ofClips = () => [...server.sent].filter(([name]) => name.endsWith(".mp4"));
    for (const id of kIds) {
      await page.locator("#" + id).scrollIntoViewIfNeeded();
      await page.waitForTimeout(200);
    }
    assert.deepEqual(ofClips(), []);
    assert.ok(server.sent.has("bursts.poster.png") && server.sent.has("bursts.thumbnail.png"));
    await page.locator("#turns .start").click();
    for (let round = 0; round < 2; ++round) {
      await page.waitForFunction(() => document.querySelector("#turns video").currentTime > 1.2);
      await page.waitForFunction(() => document.querySelector("#turns video").currentTime < 1);
    }
    const size = fs.statSync(path.join(kOut, "turns.mp4")).size;
    assert.deepEqual(ofClips(), [["turns.mp4", size]]);
    await close();
    server.close();
  });
});

describe("a figure that is folded away", () => {
  const isShown = (page) => page.locator("#recorded-defaults .screen").isVisible();

  test("costs nothing before it is wanted, and then plays", async () => {
    const server = await serve();
    const {page, problems, close} = await open({}, {address: server.address});
    await page.locator(".chapter .folded summary").first().scrollIntoViewIfNeeded();
    await page.waitForTimeout(200);
    assert.ok(!await isShown(page));
    for (const file of ["recorded-defaults.mp4", "recorded-defaults.poster.png", "recorded-defaults.thumbnail.png"]) assert.ok(!server.sent.has(file), file);
    await page.locator(".chapter .folded > summary").focus();
    await page.keyboard.press("Enter");
    assert.ok(await isShown(page));
    await openClip(page, "recorded-defaults");
    assert.ok(server.sent.has("recorded-defaults.mp4"));
    assert.deepEqual(problems, []);
    await page.screenshot({path: path.join(kOutput, "folded.png")});
    await close();
    server.close();
  });

  test("is opened by a link, by an address and by going back to it", async () => {
    for (const place of ["#recorded-defaults", ""]) {
      const {page, close} = await open({}, {place});
      if (!place) await page.locator(".contents a[href='#recorded-defaults']").evaluate((link) => link.click());
      await page.waitForFunction(() => Math.abs(document.querySelector("#recorded-defaults").getBoundingClientRect().top) < innerHeight / 2);
      assert.ok(await isShown(page));
      await close();
    }
  });

  test("is passed over by keys until then", async () => {
    const {page, close} = await open({}, {place: "#bursts"});
    await page.keyboard.press("ArrowRight");
    assert.equal(new URL(page.url()).hash, "#pair");
    await page.locator(".chapter .folded").evaluate((folded) => { folded.open = true; });
    await page.keyboard.press("ArrowLeft");
    assert.equal(new URL(page.url()).hash, "#recorded-defaults");
    await close();
  });
});

describe("the live book's place", () => {
  const kLive = () => { window.rotatebook = {play: (...what) => { window.played = what; }}; };

  test("takes every figure's scene, and the checksum in a clip's record", async () => {
    const {page, close} = await open({}, {script: kLive, name: "live.html"});
    for (const [id, text, checksum] of [["bursts", /model = "particles"/, /^[0-9a-f]{32}$/], ["book", /title = "A book"/, /^null$/], ["matrix-steps", /\[study\]/, /^null$/]]) {
      await page.locator(`#${id} .toy button`).click();
      const [scene, motion] = await page.evaluate(() => window.played);
      assert.match(scene, text);
      assert.match(String(motion), checksum);
    }
    assert.ok(await page.locator(".live").isVisible());
    await close();
  });

  test("has its buttons' room from the start, and waits until it is ready, or gives it up", async () => {
    const {page, close} = await open({}, {name: "live.html"});
    const toy = page.locator("#bursts .toy"), button = toy.locator("button");
    assert.ok(await toy.isVisible());
    assert.ok(await button.isDisabled());
    await page.evaluate(() => {
      window.rotatebook = {play: () => {}};
      document.dispatchEvent(new Event("rotatebook-live"));
    });
    assert.ok(await button.isEnabled());
    await page.evaluate(() => {
      document.querySelector(".live").innerHTML = '<section class="rb-live" data-ready="false"></section>';
      document.dispatchEvent(new Event("rotatebook-live"));
    });
    assert.ok(await toy.isHidden());
    await close();
  });

  test("has no buttons without it", async () => {
    const {page, close} = await open();
    assert.equal(await page.locator(".live").count(), 0);
    assert.equal(await page.locator(".toy:visible").count(), 0);
    await close();
  });
});

describe("a clip of which there is only a GIF", () => {
  test("moves when it is wanted, and not before", async () => {
    const {page, problems, close} = await open({}, {address: pathToFileURL(path.join(kMoving, "index.html")).href});
    const picture = page.locator("#moves .screen img"), start = page.locator("#moves .start");
    const shown = () => picture.evaluate((image) => [image.complete && image.naturalWidth, image.src.split("/").pop()]);
    await picture.scrollIntoViewIfNeeded();
    await page.waitForFunction(() => document.querySelector("#moves .screen img").src.endsWith("poster.png"));
    await start.click();
    await page.waitForFunction(() => document.querySelector("#moves .screen img").src.endsWith(".gif"));
    await page.waitForFunction(() => document.querySelector("#moves .screen img").complete);
    assert.deepEqual(await shown(), [160, "moves.gif"]);
    assert.equal(await start.getAttribute("aria-label"), "Stop Two models, moving");
    await start.click();
    assert.equal((await shown())[1], "moves.poster.png");
    await page.locator("#moves .playhead").first().waitFor();
    assert.deepEqual(problems, []);
    await page.screenshot({path: path.join(kOutput, "gif.png")});
    await close();
  });
});

describe("the whole page", () => {
  test("needs no scrolling sideways", async () => {
    for (const width of kWidths) {
      const {page, close} = await open({viewport: {width, height: 800}});
      for (const id of kIds) await page.locator("#" + id).scrollIntoViewIfNeeded();
      await page.evaluate(() => document.querySelectorAll(".facts details").forEach((one) => { one.open = true; }));
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `${wide} pixels of ${width}`);
      await page.screenshot({path: path.join(kOutput, `whole-${width}.png`), fullPage: true});
      await close();
    }
  });

  test("has no violation of axe's rules, light and dark, narrow and wide", async () => {
    for (const colorScheme of ["light", "dark"]) {
      for (const width of [390, 1440]) {
        const {page, close} = await open({colorScheme, viewport: {width, height: 900}});
        for (const id of ["turns", "bursts", "pair"]) await openClip(page, id);
        await page.evaluate(() => document.querySelectorAll("details").forEach((one) => { one.open = true; }));
        await page.addScriptTag({path: kAxe});
        const {violations, passes} = await page.evaluate(() => window.axe.run());
        assert.ok(passes.length > 20, `${passes.length} rules`);
        assert.deepEqual(violations.map((one) => [one.id, one.nodes.map((node) => node.html.slice(0, 120))]), []);
        await close();
      }
    }
  });

  test("is printed with a page for each figure, its poster and no controls", async () => {
    const {page, close} = await open();
    await page.emulateMedia({media: "print"});
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    assert.equal(await page.locator(":is(button, input, select, summary, .controls, .film):visible").count(), 0);
    for (const [poster, whole] of await page.locator("video").evaluateAll((all) => all.map((video) => [video.getAttribute("poster"), video.dataset.poster]))) assert.equal(poster, whole);
    const curves = await page.locator(".plots").evaluateAll((all) => all.map((plots) => {
      const {right} = plots.getBoundingClientRect();
      return [...plots.querySelectorAll("canvas")].every((canvas) => canvas.checkVisibility() && canvas.getBoundingClientRect().right <= right + 1);
    }));
    assert.deepEqual(curves, curves.map(() => true), "a plot is wider than the paper");
    for (const [format, margin] of [["A4", "0"], ["A4", "10mm"], ["Letter", "10mm"]]) {
      const pdf = await page.pdf({path: path.join(kOutput, `printed-${format}-${margin}.pdf`), format, margin: {top: margin, bottom: margin, left: margin, right: margin}});
      const pages = (pdf.toString("latin1").match(/\/Type\s*\/Page\b/g) ?? []).length;
      assert.equal(pages, kInContents.length, `${format}, ${margin}`);
    }
    assert.equal(await page.locator(".folded[open]").count(), 0, "pdf() prints, and ends it");
    await close();
  });
});
