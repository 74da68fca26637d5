// Each control changes the scene that it says, and keys do.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {test, before, after, describe} = require("node:test");
const {kOutput, startBrowser, closeBrowser, open, render, rotatebook, recordOf, checksumOf, frameOf, sceneOf, messageOf, load, kTurns} = require("./live_page.cjs");
const {kScenes} = require("./shipped.cjs");

before(() => startBrowser());
after(closeBrowser);

/** Opens the page with everything unfolded. */
async function opened(options) {
  const live = await open(options);
  await live.page.locator(".rb-more > summary").click();
  return {...live, choose: (name, value) => live.page.locator(`input[name=rb-${name}][value="${value}"]`).check()};
}

/** As opened(), with the book of springs, which has every knob. */
async function openedWithSprings() {
  const live = await opened();
  await live.choose("model", "particles");
  return live;
}

const knob = (page, label) => page.locator(".rb-row", {hasText: label});
async function type(page, label, text) {
  await knob(page, label).locator("input[type=text]").fill(text);
  await page.keyboard.press("Enter");
}

test("opens with the exact motion, which turns over as often after a flick", async () => {
  const {page, close} = await opened();
  assert.deepEqual((await sceneOf(page)).simulation, {model: "exact"});
  await type(page, "Spin [", "16");  // As after a usual toss about the axis that it has.
  await page.waitForFunction(() => rotatebook.player.isComplete && rotatebook.player.checksum !== null);
  const turns = await page.evaluate(() => rotatebook.player.timeline.events.filter(({halfTurns}) => halfTurns).length);
  assert.ok(turns > 50, String(turns));  // 55 by the program, in 60 s.
  await close();
});

describe("choices", () => {
  test("three throws, and what follows from them by the program", async () => {
    const {page, problems, close} = await opened();
    await page.evaluate(() => {
      window.told = [];
      const region = document.querySelector(".rb-events");
      new MutationObserver(() => told.push(region.textContent)).observe(region, {childList: true});
    });
    for (const [name, velocity, words] of [["like a door", [0, 4, 0], /^4\.0 rad\/s, 0\.8 degrees off the axis of the smallest moment: it spins on quietly\.$/],
      ["like a wheel", [0, 0, 4], /^4\.0 rad\/s, 0\.8 degrees off the axis of the largest moment: it spins on quietly\.$/],
      ["head over heels", [4, 0, 0], /^4\.0 rad\/s, 0\.8 degrees off the middle axis: it turns over about every (.*) s\.$/]]) {
      await page.getByRole("button", {name}).click();
      assert.deepEqual((await sceneOf(page)).initial.angular_velocity, velocity);
      await page.waitForFunction(() => rotatebook.player.frame > 5 && rotatebook.player.frame < 170, null, {polling: 20});
      assert.ok(await page.locator(".rb-said").isHidden());
      await page.locator(".rb-said").waitFor({state: "visible"});
      assert.ok(await page.evaluate(() => rotatebook.player.timeOf(rotatebook.player.frame)) >= 3);
      assert.match(await page.locator(".rb-said").textContent(), words);
      assert.ok(await page.locator(".rb-hint").isHidden());
    }
    await page.waitForFunction((words) => told.includes(words), await page.locator(".rb-said").textContent());
    const scene = path.join(kOutput, "heels.toml");
    fs.writeFileSync(scene, await page.evaluate(() => rotatebook.player.scene.text));
    const [, interval] = /then every ([\d.]+) s/.exec(rotatebook("info", scene));
    assert.match(await page.locator(".rb-said").textContent(), new RegExp(`every ${Number(interval).toPrecision(2)} s`));
    await page.getByRole("button", {name: "why"}).click();
    assert.ok(await page.locator(".rb-said").isVisible(), "it is the same throw");
    await page.locator("[data-do=jiggle]").click();
    assert.ok(await page.locator(".rb-said").isHidden(), "it is another motion");
    assert.deepEqual(problems, []);
    await close();
  });

  test("other bodies are thrown about the axes of their moments", async () => {
    const {page, close} = await opened();
    assert.ok(await load(page, 'title = "t"\n[body]\nshape = "t-handle"\n[initial]\nangular_velocity = [4, 0, 0.1]\n'), await messageOf(page));
    for (const [name, about] of [["like a door", "smallest"], ["like a wheel", "largest"], ["head over heels", "middle"]]) {
      await page.getByRole("button", {name}).click();
      assert.equal(await messageOf(page), "");
      assert.equal((await sceneOf(page)).initial.angular_velocity.about, about);
      assert.equal(await page.evaluate(() => rotatebook.player.core.spin(0, 0).axis), about);
    }
    await close();
  });

  test("of two books the one whose settings are shown is thrown", async () => {
    const {page, close, choose} = await opened();
    await choose("books", "same");
    await page.getByRole("button", {name: "like a wheel"}).click();
    assert.deepEqual((await sceneOf(page)).panel.map(({initial}) => initial.angular_velocity), [[4, 0, 0], [0, 0, 4]]);
    await close();
  });

  test("one of two books that start with the scene's spin and a tilt of their own", async () => {
    const {page, problems, close, choose} = await opened();
    const panels = '[[panel]]\nlabel = "a"\ninitial.tilt = [0.1, "z"]\n[[panel]]\nlabel = "b"\ninitial.tilt = [0.2, "z"]\n';
    assert.ok(await load(page, `title = "t"\n[initial]\nangular_velocity = [5, 0, 0]\n${panels}`), await messageOf(page));
    await choose("books", "one");
    assert.deepEqual((await sceneOf(page)).initial, {angular_velocity: [5, 0, 0], tilt: [0.1, "z"]});
    assert.deepEqual(problems, []);
    await close();
  });

  test("one of the books of a map, which names them", async () => {
    const {page, problems, close, choose} = await opened();
    assert.ok(await load(page, fs.readFileSync(kScenes.get("map-luck"), "utf8")), await messageOf(page));
    await choose("books", "one");
    assert.equal((await sceneOf(page)).panel, undefined);
    assert.deepEqual(problems, []);
    await close();
  });

  test("no loss of energy with a model that has none", async () => {
    const {page, problems, close, choose} = await opened();
    const lossy = 'title = "t"\nsimulation.dissipation = 2e-5\n[initial]\nangular_velocity = [5, 0, 0.1]\n';
    assert.ok(await load(page, lossy), await messageOf(page));
    await choose("books", "exact");
    assert.deepEqual((await sceneOf(page)).panel[1].simulation, {model: "exact", dissipation: 0});
    await choose("books", "one");
    await choose("model", "exact");
    assert.equal((await sceneOf(page)).simulation.dissipation, 0);
    assert.deepEqual(problems, []);
    await close();
  });

  test("the exact book beside one of another model alone", async () => {
    const {page, problems, close, choose} = await opened();
    const isOffered = () => page.locator("label:has(> input[name=rb-books][value=exact])").isVisible();
    assert.equal(await isOffered(), false);  // Two exact books are "two".
    await choose("model", "matrix");
    assert.equal(await isOffered(), true);
    await choose("books", "exact");
    await choose("edited", "1");
    assert.equal(await isOffered(), true);  // What is chosen stays.
    assert.deepEqual(problems, []);
    await close();
  });

  test("every model with every integrator of its own", async () => {
    const {page, problems, close, choose} = await opened();
    const models = await page.evaluate(() => rotatebook.player.core.words.models);
    assert.deepEqual(models.map(({name}) => name), ["particles", "matrix", "quaternion", "exact"]);
    for (const {name, integrators} of models) {
      await choose("model", name);
      assert.equal((await sceneOf(page)).simulation.model, name);
      const select = knob(page, "Integrator").locator("select");
      assert.equal(await select.isVisible(), integrators.length > 0);
      for (const integrator of integrators) {
        await select.selectOption(integrator);
        assert.equal((await sceneOf(page)).simulation.integrator, integrator);
        assert.equal(await messageOf(page), "", `${name}, ${integrator}`);
      }
    }
    assert.deepEqual(problems, []);
    await close();
  });

  test("two books on one clock, of any settings, and one again", async () => {
    const {page, close, choose} = await opened();
    await choose("books", "same");
    await choose("model", "quaternion");
    assert.deepEqual((await sceneOf(page)).panel.map(({simulation}) => simulation?.model), [undefined, "quaternion"]);
    assert.deepEqual(await page.evaluate(() => rotatebook.player.read.motions.map(({model}) => model)), ["exact", "quaternion"]);
    await page.waitForFunction(() => document.querySelectorAll(".rb-labels span").length === 2);
    await choose("books", "exact");
    assert.deepEqual(await page.evaluate(() => rotatebook.player.read.motions.map(({model}) => model)), ["quaternion", "exact"], "the one that was edited stays");
    await page.keyboard.press("z");
    assert.deepEqual(await page.evaluate(() => rotatebook.player.scene.tree.panel.map((panel) => panel.initial.angular_velocity)), [[0, 0, 4], [4, 0, 0]]);
    await choose("books", "one");
    const scene = await sceneOf(page);
    assert.equal(scene.panel, undefined);
    assert.deepEqual(scene.initial.angular_velocity, [0, 0, 4]);
    await close();
  });
});

describe("knobs", () => {
  const kCases = [
    ["Substeps", "1000", "simulation", "substeps", 1000], ["Time a picture", "0.02", "simulation", "time_per_frame", 0.02],
    ["Stiffness", "300", "simulation", "stiffness", 300], ["Damping", "0", "simulation", "damping", 0],
    ["Mass", "2", "body", "mass", 2], ["Thickness", "3", "body", "size", [0.1878, 0.29085, 0.03]], ["Length", "30", "clip", "duration", 30],
    ["Tilt", "0", "initial", "tilt", undefined], ["Tilt", "0.0003", "initial", "tilt", [0.0003, "z"]], ["Spin [", "6", "initial", "angular_velocity", [6, 0, 0]],
  ];

  test("typed numbers reach the scene", async () => {
    const {page, close} = await openedWithSprings();
    for (const [label, text, section, key, value] of kCases) {
      await type(page, label, text);
      assert.equal(await messageOf(page), "", label);
      assert.deepEqual((await sceneOf(page))[section][key], value, label);
    }
    await close();
  });

  test("sliders reach the scene, by keys too", async () => {
    const {page, close} = await openedWithSprings();
    for (const [label, , section, key] of kCases) {
      const before = (await sceneOf(page))[section]?.[key], slider = knob(page, label).locator("input[type=range]");
      await slider.focus();
      await page.keyboard.press("ArrowRight");
      const after = (await sceneOf(page))[section][key];
      assert.notDeepEqual(after, before, label);
      assert.equal(await messageOf(page), "", label);
    }
    await close();
  });

  test("each whole number can be reached by keys", async () => {
    const {page, close} = await openedWithSprings();
    await type(page, "Substeps", "1");
    await knob(page, "Substeps").locator("input[type=range]").focus();
    for (const steps of [2, 3, 4]) {
      await page.keyboard.press("ArrowRight");
      assert.equal((await sceneOf(page)).simulation.substeps, steps);
    }
    await page.keyboard.press("ArrowLeft");
    assert.equal((await sceneOf(page)).simulation.substeps, 3);
    await close();
  });

  test("a scene with the longest title can be changed", async () => {
    const {page, close} = await opened();
    await load(page, kTurns.replace("A book that turns over", "x".repeat(200)));
    await type(page, "Mass", "2");
    assert.equal((await sceneOf(page)).body.mass, 2);
    assert.match((await sceneOf(page)).title, /^x{191}, changed$/);
    await close();
  });

  test("what the core refuses is said, and the last good scene stays", async () => {
    const {page, close} = await opened();
    const before = await sceneOf(page);
    await type(page, "Mass", "-1");
    assert.match(await messageOf(page), /"?body\.mass"?|mass/);
    assert.deepEqual(await sceneOf(page), before);
    await type(page, "Mass", "heavy");
    assert.match(await messageOf(page), /no number/);
    assert.deepEqual(await sceneOf(page), before);
    await close();
  });

  test("checkboxes: normalising and what is shown", async () => {
    const {page, close} = await openedWithSprings();
    await page.getByLabel("Normalise after each step").uncheck();
    assert.equal((await sceneOf(page)).simulation.normalize, false);
    await page.evaluate(() => rotatebook.player.seek(180));  // At first the axes are shown in any case.
    for (const [words, overlay] of [["axes of the book", "axes"], ["springs by strain", "springs"], ["outline of the exact book", "ghost"]]) {
      const before = await page.evaluate(() => rotatebook.player.drawing.lines.toDataURL());
      await page.getByLabel(words).check();
      assert.ok((await sceneOf(page)).overlay.show.includes(overlay));
      await page.waitForFunction((old) => rotatebook.player.drawing.lines.toDataURL() !== old, before);
    }
    await page.getByLabel("ball of spins").uncheck();
    await page.locator(".rb-ball").waitFor({state: "hidden"});
    await close();
  });
});

describe("the clock", () => {
  test("plays, pauses, steps and goes back", async () => {
    const {page, close} = await open();
    assert.equal(await frameOf(page), 0);
    await page.locator("[data-do=toggle]").click();
    await page.waitForFunction(() => rotatebook.player.frame > 20);
    await page.locator("[data-do=toggle]").click();
    const frame = await frameOf(page);
    await page.locator("[data-do=forward]").click();
    assert.equal(await frameOf(page), frame + 1);
    await page.locator("[data-do=back]").click();
    await page.locator("[data-do=back]").click();
    assert.equal(await frameOf(page), frame - 1);
    await close();
  });

  test("goes where the time line is dragged, through the kept motion", async () => {
    const {page, close} = await open();
    await load(page, kTurns.replace("1.5", "10"));
    await page.waitForFunction(() => rotatebook.player.isComplete);
    const box = await page.locator(".rb-seek").boundingBox(), at = (share) => [box.x + share * box.width, box.y + box.height / 2];
    await page.mouse.move(...at(0.5));
    await page.mouse.down();
    assert.ok(Math.abs(await frameOf(page) - 300) < 12, String(await frameOf(page)));
    await page.mouse.move(...at(0.2));
    await page.mouse.up();
    assert.ok(Math.abs(await frameOf(page) - 120) < 12, String(await frameOf(page)));
    await close();
  });

  // How fast it is depends on the machine: printed, not asserted.
  test("a thousand steps a picture are all made", async () => {
    const {page, close} = await openedWithSprings();
    await type(page, "Length", "4");
    await type(page, "Substeps", "1000");
    const passed = await page.evaluate(async () => {
      const player = rotatebook.player;
      player.seek(0);
      player.start();
      const start = performance.now();
      await new Promise((resolve) => { setTimeout(resolve, 3000); });
      return {frames: player.frame, wanted: (performance.now() - start) * 0.06, simulated: player.simulated};
    });
    console.log(`a thousand steps: ${passed.frames} of ${passed.wanted.toFixed(0)} pictures' time, ${passed.simulated} simulated`);
    const checksum = await checksumOf(page), text = await page.evaluate(() => rotatebook.player.sharedText());
    const record = await recordOf(render("thousand", text));
    assert.equal(record.motion, checksum);
    await close();
  });
});

describe("keys", () => {
  test("work while the player has the focus, and only then", async () => {
    const {page, close} = await open();
    await page.keyboard.press("z");
    assert.deepEqual((await sceneOf(page)).initial.angular_velocity, [4, 0, 0]);
    await page.locator(".rb-picture").focus();
    await page.keyboard.press("z");
    assert.deepEqual((await sceneOf(page)).initial.angular_velocity, [0, 0, 4]);
    await page.keyboard.press("Space");
    await page.keyboard.press("Home");
    await page.keyboard.press(".");
    assert.equal(await frameOf(page), 1);
    await page.keyboard.press(",");
    assert.equal(await frameOf(page), 0);
    await page.keyboard.press("Space");
    await page.waitForFunction(() => rotatebook.player.frame > 5);
    await page.keyboard.press("Space");
    await page.keyboard.press("Home");
    assert.equal(await frameOf(page), 0);
    await page.keyboard.press("ArrowRight");
    assert.ok(await page.evaluate(() => rotatebook.player.orbit.right) > 0.05);
    await page.keyboard.press("0");
    assert.equal(await page.evaluate(() => rotatebook.player.orbit.right), 0);
    await page.keyboard.press("Shift+ArrowUp");
    assert.equal((await sceneOf(page)).nudge.length, 1);
    await page.keyboard.press("r");
    assert.equal((await sceneOf(page)).nudge, undefined);
    await close();
  });

  test("letters work on the ball, too", async () => {
    const {page, close} = await open();
    await page.locator(".rb-ball").focus();
    await page.keyboard.press("z");
    assert.deepEqual((await sceneOf(page)).initial.angular_velocity, [0, 0, 4]);
    await page.keyboard.press(" ");
    await page.keyboard.press("Home");
    await page.keyboard.press(".");
    assert.equal(await frameOf(page), 1);
    await close();
  });

  test("letters in a field are letters", async () => {
    const {page, close} = await opened();
    await knob(page, "Mass").locator("input[type=text]").focus();
    const before = await sceneOf(page);
    await page.keyboard.type("xyzr ");
    assert.deepEqual(await sceneOf(page), before);
    await close();
  });
});
