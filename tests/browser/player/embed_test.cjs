// In a frame of another page: the picture and its controls alone, with a link to the whole; and the lines to copy for it.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const http = require("node:http");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {test, before, after} = require("node:test");
const {kOutput, kPlayed, playedFile, startBrowser, closeBrowser, open, violations, checksumOf, messageOf} = require("./live_page.cjs");

before(() => startBrowser());
after(closeBrowser);

/** Opens a page of a file with a line of HTML in it; returns it, and the frame. */
async function openCourse(name, line, folder = kOutput) {
  const file = path.join(folder, name);
  fs.writeFileSync(file, `<!doctype html><html lang="en"><title>A course</title><main><h1>A course</h1>\n${line}\n</main>`);
  const course = await open({viewport: {width: 1100, height: 800}}, {file: pathToFileURL(file).href, isReady: null});
  return {...course, frame: course.page.frames()[1]};
}

test("in a frame from file:", async () => {
  const address = pathToFileURL(playedFile()).href;
  const {page, frame, problems, close} = await openCourse(`course-${kPlayed}.html`, `<iframe src="${address}#embed" title="The live book" width="960" height="600" allowfullscreen></iframe>`);
  await frame.waitForFunction(() => document.querySelector(".rb-live")?.dataset.ready === "true" && document.readyState === "complete");
  const seen = await frame.evaluate(() => {
    const isSeen = (element) => element.checkVisibility() && element.getBoundingClientRect().height > 1;
    const outside = [...document.body.querySelectorAll("*")].filter((element) => isSeen(element) && !element.closest(".rb-live") && !element.querySelector(".rb-live"));
    const parts = [...document.querySelector(".rb-player").children].filter(isSeen).map((element) => element.className);
    const {right, bottom} = document.querySelector(".rb-transport").getBoundingClientRect();
    return {outside: outside.length, parts, ends: [right, bottom], scrolls: document.documentElement.scrollHeight > innerHeight};
  });
  assert.deepEqual(seen, {outside: 0, parts: ["rb-scene", "rb-transport"], ends: [960, 600], scrolls: false});
  const link = frame.locator(".rb-whole");
  assert.equal(await link.getAttribute("href"), address);
  await frame.locator(".rb-throws [data-axis=z]").click();
  await frame.waitForFunction(() => rotatebook.player.outcome.spin?.axis === "largest" && rotatebook.player.frame > 5);
  await page.screenshot({path: path.join(kOutput, `embed-${kPlayed}.png`)});
  await frame.locator("[data-do=full]").click();
  await page.waitForFunction(() => document.fullscreenElement?.localName === "iframe");
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => document.fullscreenElement === null);
  assert.ok(await frame.locator(".rb-bare").isVisible(), "it stays alone");
  const [whole] = await Promise.all([page.context().waitForEvent("page"), link.click()]);
  await whole.waitForFunction(() => document.querySelector(".rb-live").dataset.ready === "true");
  assert.ok(await whole.locator(".rb-numbers").first().isVisible());
  assert.deepEqual(problems, []);
  assert.deepEqual(await violations(page), []);  // Last, as axe's own messages between files are refused.
  await close();
});

/** Where the book and the controls are, and how large the book is, over the first turns; all in the frame's pixels. */
const seenIn = (page) => page.evaluate(() => {
  const {player} = rotatebook, {drawing} = player, names = [".rb-stage", ".rb-throws", ".rb-views", ".rb-transport", ".rb-timeline", ".rb-play", ".rb-whole"];
  const boxOf = (element) => (({left, top, right, bottom}) => [left, top, right, bottom])(element.getBoundingClientRect());
  const boxes = Object.fromEntries(names.map((name) => [name, boxOf(document.querySelector(name))])), scale = drawing.picture.width / drawing.box.width;
  const books = Array.from({length: 40}, (_, i) => {
    drawing.draw(15 * i, player);
    const {x, y, width, height} = drawing.view.boxes[0];
    return [x, y, x + width, y + height].map((part) => part / scale);
  });
  const radius = drawing.bookRadius(drawing.middleOfBook(0)), blank = boxes[".rb-transport"][1] - boxes[".rb-stage"][3];
  const hit = [".rb-play", ".rb-seek", ".rb-whole"].filter((name) => {
    const element = document.querySelector(name), [left, top, right, bottom] = boxOf(element);
    return document.elementFromPoint((left + right) / 2, (top + bottom) / 2)?.closest(name) === element;
  });
  return {boxes, books, radius, blank, hit};
});

const isOver = ([left, top, right, bottom], [x, y, end, low]) => left < end && x < right && top < low && y < bottom;

for (const [width, height] of [[960, 600], [640, 400], [480, 320], [320, 240], [960, 300]]) {
  test(`a frame of ${width} x ${height} shows the whole book, and what it is played with`, async () => {
    const {page, problems, close} = await open({viewport: {width, height}}, {hash: "#embed"});
    await page.waitForFunction(() => rotatebook.player.simulated > 600);
    const {boxes, books, radius, blank, hit} = await seenIn(page);
    await page.screenshot({path: path.join(kOutput, `embed-${width}x${height}.png`)});
    assert.deepEqual([boxes[".rb-transport"][3], blank, hit], [height, 0, [".rb-play", ".rb-seek", ".rb-whole"]]);
    const share = radius / Math.min(width, height);
    console.log(`${width} x ${height}: half the book is ${share.toFixed(3)} of the shorter side`);
    assert.ok(share > 0.33, `${share}`);  // Measured 0.347 to 0.398; with the layout of phones 0.083 to 0.198 in those less than 640 wide.
    for (const book of books) {
      assert.ok(book[0] > 0 && book[1] > 0 && book[2] < width && book[3] < boxes[".rb-stage"][3], `${book} is cut off`);
      if (height < 480) assert.ok(!isOver(book, boxes[".rb-throws"]) && !isOver(book, boxes[".rb-views"]), `${book} is under buttons`);
    }
    assert.ok(boxes[".rb-timeline"][2] - boxes[".rb-timeline"][0] > 100);
    assert.equal(await page.getByRole("button", {name: "head over heels"}).count(), 1);
    assert.equal(await page.getByRole("button", {name: /^(Play|Pause)$/}).count(), 1);
    assert.deepEqual(await violations(page), []);
    assert.deepEqual(problems, []);
    await close();
  });
}

test("the line to copy is a frame of what is played", async () => {
  const {page, problems, close} = await open({permissions: ["clipboard-read", "clipboard-write"]});
  await page.locator(".rb-throws [data-axis=y]").click();
  const checksum = await checksumOf(page);
  await page.locator(".rb-more summary").click();
  await page.getByRole("button", {name: "Copy for a course page"}).click();
  await page.waitForFunction(() => /clipboard/.test(document.querySelector(".rb-message").textContent));
  assert.match(await messageOf(page), /^A line of HTML for the course page is in the clipboard/);
  const line = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(line, /^<iframe src="(play|index).html#embed&amp;play=[\w-]+" title="The live book" width="960" height="600" allow="accelerometer; gyroscope" allowfullscreen="" loading="lazy"><\/iframe>$/);
  await close();
  // Beside the page, or a copy of it.
  if (kPlayed === "play") fs.copyFileSync(playedFile(), path.join(kOutput, "play.html"));
  const course = await openCourse("course-copied.html", line, kPlayed === "play" ? kOutput : path.dirname(playedFile()));
  await course.frame.waitForFunction(() => document.querySelector(".rb-live")?.dataset.ready === "true");
  assert.equal(await checksumOf(course.frame), checksum);
  assert.match(await course.frame.locator(".rb-whole").getAttribute("href"), /\.html#play=/);
  assert.deepEqual([...problems, ...course.problems], []);
  await course.close();
});

test("a frame from elsewhere has the sensors of a toss, and full screen", async () => {
  const pages = {"/live.html": fs.readFileSync(playedFile())};
  const server = http.createServer(({url}, response) => response.writeHead(pages[url] ? 200 : 404, {"content-type": "text/html"}).end(pages[url]));
  await new Promise((resolve) => { server.listen(0, resolve); });
  const {port} = server.address();
  const {page, close} = await open({}, {file: `http://127.0.0.1:${port}/live.html`});
  await page.evaluate(() => { navigator.clipboard.writeText = async (text) => { window.copied = text; }; });
  await page.locator(".rb-more summary").click();
  await page.locator("[data-do=frame]").click();
  await page.waitForFunction(() => window.copied);
  const line = await page.evaluate(() => copied);
  await close();
  pages["/course.html"] = `<!doctype html><title>A course</title>\n${line}\n${line.replace(/ allow="[^"]*"/, "")}`;
  const course = await open({}, {file: `http://localhost:${port}/course.html`, isReady: null});
  const allowed = await Promise.all(course.page.frames().slice(1).map(async (frame) => {
    await frame.waitForFunction(() => document.querySelector(".rb-live")?.dataset.ready === "true");
    return frame.evaluate(() => ["accelerometer", "gyroscope", "fullscreen"].map((name) => document.featurePolicy.allowsFeature(name)));
  }));
  assert.deepEqual(allowed, [[true, true, true], [false, false, true]]);
  await course.close();
  server.close();
});

test("a step of the tour in a frame", async () => {
  const {page, problems, close} = await open({}, {hash: "#embed&tour=3"});
  assert.match(await page.locator(".rb-step").textContent(), /step 3/);
  assert.ok(await page.locator(".rb-whole").isVisible() && await page.locator("h1").isHidden());
  assert.match(await page.locator(".rb-whole").getAttribute("href"), /\.html#tour=3$/);
  assert.deepEqual(await violations(page), []);
  await page.getByRole("button", {name: "Leave the tour"}).click();
  assert.ok(await page.locator(".rb-bare").isVisible());
  assert.deepEqual(problems, []);
  await close();
});

if (kPlayed === "index") test("the page has each clip's line", async () => {
  const file = playedFile(), {page, close} = await open();
  const line = await page.locator("#turns .elsewhere pre").evaluate((pre) => pre.textContent);
  assert.match(line, /^<video controls loop muted playsinline preload="none" width="64" height="36" poster="turns[^"]*\.png" src="turns\.mp4"><\/video>$/);
  await close();
  const course = path.join(path.dirname(file), "course-clip.html");
  fs.writeFileSync(course, `<!doctype html><title>A course</title>${line}`);
  const other = await open({}, {file: pathToFileURL(course).href, isReady: null});
  const size = await other.page.evaluate(() => new Promise((resolve, reject) => {
    const video = document.querySelector("video");
    video.onloadedmetadata = () => resolve([video.videoWidth, video.videoHeight]);
    video.onerror = reject;
    video.load();
    video.play();
  }));
  assert.deepEqual(size, [64, 36]);
  assert.deepEqual(other.problems, []);
  await other.close();
});
