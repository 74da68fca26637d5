// The live book that follows a scene, by `rotatebook watch --live`.
"use strict";

const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const {spawn} = require("node:child_process");
const {before, after} = require("node:test");
const {pathToFileURL} = require("node:url");
const {startBrowser, closeBrowser, open, testOnce, kOutput, kPlay, kTurns} = require("./live_page.cjs");

const kWithin = 30000;  // [ms]

before(() => startBrowser());
after(closeBrowser);

async function until(what) {
  for (const end = Date.now() + kWithin; !what();) {
    assert.ok(Date.now() < end, String(what));
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}

testOnce("the page plays each save from where it is, with the files that it names, and says mistakes", async () => {
  const folder = path.join(kOutput, "watch"), file = (name) => path.join(folder, name);
  fs.rmSync(folder, {recursive: true, force: true});
  fs.mkdirSync(folder);
  fs.writeFileSync(file("my #1.toml"), kTurns);
  const program = spawn(process.env.ROTATEBOOK_PROGRAM, ["watch", "my #1.toml", "--live", kPlay], {cwd: folder});
  try {
    await until(() => fs.existsSync(file("my #1.live.js")));
    const {page, problems, close} = await open({}, {file: pathToFileURL(file("my #1.live.html")).href});
    const titled = (title) => page.waitForFunction((wanted) => rotatebook.player.scene.tree.title === wanted, title);
    await titled("A book that turns over");
    await page.evaluate(() => {
      rotatebook.player.seek(50);
      rotatebook.player.orbit.right = 0.5;
    });
    fs.writeFileSync(file("my #1.toml"), kTurns.replace("turns over", "turns slowly").replace("6.0", "5.0"));
    await titled("A book that turns slowly");
    assert.equal(await page.evaluate(() => rotatebook.player.frame), 50);
    assert.equal(await page.evaluate(() => rotatebook.player.orbit.right), 0.5);

    fs.writeFileSync(file("my #1.toml"), kTurns.replace("tilt", "tlit"));
    await page.waitForFunction(() => /unknown key "tlit"/.test(document.querySelector(".rb-message").textContent));
    assert.equal(await page.evaluate(() => rotatebook.player.scene.tree.title), "A book that turns slowly");

    fs.writeFileSync(file("wedge.obj"), "# é\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    fs.writeFileSync(file("my #1.toml"), kTurns.replace("turns over", "is a wedge").replace("[clip]", '[body]\nmesh = "wedge.obj"\nmass = 1\n[clip]'));
    await titled("A book that is a wedge");
    assert.equal(await page.locator(".rb-message").textContent(), "");
    assert.deepEqual(problems, []);
    await close();
  } finally {
    program.kill("SIGINT");
  }
  assert.equal(await new Promise((resolve) => program.on("exit", resolve)), 130);
});
