// Your own toss, in Chromium: sensors are emulated by events of a known motion.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before, after} = require("node:test");
const {kOutput, kPlayed, testOnce, startBrowser, closeBrowser, rotatebook, playerScripts, coreFor, open, sceneOf, messageOf} = require("./live_page.cjs");

const kAxe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const kRate = 60, kRest = 1, kFlight = 0.65;  // [Hz, s, s]
const kPhone = `body.shape = "phone"\nsimulation.model = "exact"\ninitial = { angular_velocity = [11.0, 0.6, 0.9] }\nclip = { fps = ${kRate}, duration = ${kFlight} }\n`;
/** Timers ten times as fast. */
const kSoon = "{ const later = setTimeout; window.setTimeout = (action, time = 0) => later(action, time / 10); }";

before(() => startBrowser());
after(closeBrowser);

const rounded = (values) => values.map((value) => Math.round(10 * value) / 10);  // As browsers do, to 0.1 deg/s and 0.1 m/s².
const times = ([w, x, y, z], [a, b, c, d]) =>
  [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a];
const undone = ([w, x, y, z]) => [w, -x, -y, -z];
const angleBetween = (a, b) => 360 / Math.PI * Math.asin(Math.min(1, Math.hypot(...times(undone(a), b).slice(1))));
const turned = (by, vector) => times(times(by, [0, ...vector]), undone(by)).slice(1);

/** Returns the exact motion of a tossed phone by the core: attitudes, moments, and what its sensors read at rest, in flight and at rest. */
async function exactToss() {
  const scripts = playerScripts(["share", "core"], ["Core"]), core = await coreFor(scripts);
  const {motions} = core.read(0, kPhone), frames = core.frames(0);
  core.advance(0, frames - 1, 1e9);
  const samples = Array.from({length: frames}, (_, frame) => core.sample(0, 0, frame));
  const attitudes = samples.map((sample) => [...sample.subarray(1, 5)]);
  const rates = samples.map((sample, i) => turned(undone(attitudes[i]), [...sample.subarray(5, 8)]));
  const rest = Array.from({length: kRest * kRate}, () => ({rate: [0, 0, 0], force: [0, 0, 9.8]}));
  const flight = rates.map((rate) => ({rate: rounded(rate.map((part) => part * 180 / Math.PI)), force: [0, 0, 0]}));
  return {attitudes, moments: motions[0].moments, readings: [...rest, ...flight, ...rest]};
}

/** Presses the button, and lets the sensors read once they are listened to; `said` is what the page says meanwhile. */
async function toss(page, readings, rate = kRate) {
  if (!await page.locator("[data-do=toss]").isVisible()) await page.locator(".rb-more summary").click();
  await page.evaluate(([all, frequency]) => {
    const line = document.querySelector(".rb-toss [role=status]"), send = () => all.forEach(({rate: [alpha, beta, gamma], force: [x, y, z]}, i) => {
      const event = new DeviceMotionEvent("devicemotion", {rotationRate: {alpha, beta, gamma}, accelerationIncludingGravity: {x, y, z}});
      Object.defineProperty(event, "timeStamp", {value: 1000 * i / frequency});
      window.dispatchEvent(event);
    });
    window.said = [];
    window.watcher?.disconnect();
    window.watcher = new MutationObserver(() => said.push(line.textContent));
    watcher.observe(line, {childList: true});
    const listen = window.addEventListener;
    window.addEventListener = (name, ...more) => {
      listen.call(window, name, ...more);
      if (name !== "devicemotion") return;
      window.addEventListener = listen;
      send();
    };
  }, [readings, rate]);
  await page.locator("[data-do=toss]").focus();
  await page.keyboard.press("Enter");
}

async function violations(page) {
  await page.evaluate(kAxe);
  return page.evaluate(async () => (await axe.run(document, {resultTypes: ["violations"]})).violations.map(({id, nodes}) => `${id}: ${nodes[0].html}`));
}

const saying = async (page, pattern) => {
  await page.locator(".rb-toss [role=status]", {hasText: pattern}).waitFor();
  return page.locator(".rb-toss [role=status]").textContent();
};

test("plays a toss beside the exact motion, and saves what `rotatebook toss` reads", async () => {
  const exact = await exactToss();
  const spied = "window.listened = 0; const listen = addEventListener; window.addEventListener = (name, ...more) => { listened += name === 'devicemotion'; listen.call(window, name, ...more); };";
  const {page, problems, close} = await open({viewport: {width: 390, height: 844}}, {script: spied});
  await page.locator(".rb-more summary").click();
  assert.equal(await page.evaluate(() => window.listened), 0, "no sensor is read unasked");
  await page.locator(".rb-toss").screenshot({path: path.join(kOutput, "toss-steps.png")});
  await toss(page, exact.readings);
  await page.waitForFunction(() => rotatebook.player.scene.tree.title === "Your own toss");
  assert.deepEqual(await page.evaluate(() => [said, listened]), [["3 …", "2 …", "1 …", "Toss it now!", ""], 1]);
  const {panel: [measured, model], body} = await sceneOf(page), {from, to} = measured.simulation;
  assert.deepEqual(body, {shape: "phone"});
  // The first and last 2 % may be the hand's.
  assert.ok(Math.abs(from - (kRest + 1 / kRate)) < 1e-5 && Math.abs(to - from - (exact.attitudes.length - 3) / kRate) < 1e-5, `${from} to ${to}`);
  const played = await page.evaluate(() => Array.from({length: rotatebook.player.simulation.frames}, (_, frame) =>
    [0, 1].map((motion) => [...rotatebook.player.core.sample(0, motion, frame).subarray(1, 5)])));
  let most = [0, 0];
  for (let i = 0; 10 * i < played.length; ++i) {
    const attitude = times(undone(exact.attitudes[1]), exact.attitudes[1 + i]);  // A tenth of the speed, and from the flight's first reading.
    most = most.map((angle, motion) => Math.max(angle, angleBetween(played[10 * i][motion], attitude)));
  }
  console.log(`the measured motion is within ${most[0].toFixed(3)}°, the exact one within ${most[1].toFixed(3)}°`);
  assert.ok(played.length > 300 && most[0] < 0.02 && most[1] < 0.1, "measured 0.005 and 0.025");
  assert.match(await messageOf(page), /^It flew for 0\.6\d s, and ends 0\.\d° from the exact motion/);
  await page.screenshot({path: path.join(kOutput, "toss-played.png")});
  assert.deepEqual(await violations(page), []);
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("[data-do=keep]").click()]);
  const table = path.join(kOutput, "toss.csv");
  await download.saveAs(table);
  const fit = JSON.parse(rotatebook("toss", table, "--json")), [least, middle, largest] = [...exact.moments].sort((a, b) => a - b);
  console.log(`I1/I3 ${fit.I1_over_I3.value} of ${least / largest}, I2/I3 ${fit.I2_over_I3.value} of ${middle / largest}`);
  assert.ok(Math.abs(fit.I2_over_I3.value - middle / largest) < 0.002 && Math.abs(fit.from_s - from) < 1e-9, "measured 0.0004");
  assert.deepEqual(problems, []);
  await close();
});

testOnce("says what a recording lacks, and the scene stays", async () => {
  const {readings} = await exactToss(), {page, problems, close} = await open({}, {script: kSoon});
  const title = (await sceneOf(page)).title;
  await toss(page, readings.filter(({force}) => force[2] !== 0));
  assert.match(await saying(page, /flew/), /^Nothing flew: no spinning free fall was found\.$/);
  await toss(page, readings, 20);
  assert.match(await saying(page, /a second/), /^Only 20 readings a second; a toss needs 30\.$/);
  assert.equal((await sceneOf(page)).title, title);
  assert.deepEqual(await violations(page), []);
  assert.ok(await page.locator("[data-do=keep]").isVisible(), "it can be saved all the same");
  assert.deepEqual(problems, []);
  await close();
});

test("says that no sensors answer, in German, too", async () => {
  const answers = [["en", /^No motion sensors answer here\. Or .*phyphox/], ["de", /^Hier antworten keine .*phyphox/]];
  for (const [language, pattern] of answers.slice(0, kPlayed === "play" ? 2 : 1)) {  // The page of figures here is in English.
    const {page, problems, close} = await open({}, {script: kSoon, hash: `?lang=${language}`});
    await toss(page, []);
    assert.match(await saying(page, /phyphox/), pattern);
    assert.equal(await page.evaluate(() => said.length), 1, "it doesn't count first");
    assert.deepEqual(problems, []);
    await close();
  }
});

testOnce("asks within the press, and takes no for an answer", async () => {
  for (const answer of ["Promise.resolve('denied')", "Promise.reject(new DOMException('No.', 'NotAllowedError'))"]) {
    const script = `DeviceMotionEvent.requestPermission = () => { window.isPressed = navigator.userActivation.isActive; return ${answer}; };`;
    const {page, problems, close} = await open({}, {script});
    await page.locator(".rb-more summary").click();
    await page.locator("[data-do=toss]").click();
    assert.match(await saying(page, /permission/), /^The sensors may not be read: permission refused\. Or record “Gyroscope” with the app phyphox/);
    assert.equal(await page.evaluate(() => window.isPressed), true);
    assert.deepEqual(problems, []);
    await close();
  }
});

test("shows the way by phyphox where there are no sensors, or no https", async () => {
  for (const [script, pattern] of [["delete window.DeviceMotionEvent;", /^No motion sensors answer here\. Or .*phyphox/],
    ["Object.defineProperty(window, 'isSecureContext', {value: false});", /^Motion sensors need a page from https\. Or .*phyphox/]]) {
    const {page, problems, close} = await open({}, {script});
    await page.locator(".rb-more summary").click();
    assert.match(await page.locator(".rb-toss [role=status]").textContent(), pattern);
    assert.equal(await page.locator("[data-do=toss]").isVisible(), false);
    assert.deepEqual(await violations(page), []);
    assert.deepEqual(problems, []);
    await close();
  }
});
