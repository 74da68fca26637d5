// The scenes that ship, and the table of their motions' checksums.
"use strict";

const fs = require("node:fs");
const path = require("node:path");

const kRoot = path.join(__dirname, "../../..");

const below = (folder) => fs.readdirSync(folder, {withFileTypes: true}).flatMap((entry) =>
  entry.isDirectory() ? below(path.join(folder, entry.name)) : [path.join(folder, entry.name)]);

const kScenes = new Map(below(path.join(kRoot, "scenes")).filter((file) => file.endsWith(".toml")).map((file) => [path.basename(file, ".toml"), file]));

/** Lines of the table: name, checksum of the motion, checksum of the tables. Other lines are no scene's. */
const kMotions = new Map(fs.readFileSync(path.join(kRoot, "tests/same_bits/motions.txt"), "utf8").split("\n")
  .map((line) => line.split(" ")).filter(([name, , tables]) => tables && kScenes.has(name)).map(([name, motion]) => [name, motion]));

/** Returns the meshes and recordings that a scene's text names, from the folder of its file: {name, bytes}. */
function filesOf(file, text) {
  return [...text.matchAll(/^(?:(?:simulation\.)?file|(?:body\.)?mesh) = "(.*)"$/gm)].map(([, name]) =>
    ({name, bytes: fs.readFileSync(path.join(path.dirname(file), name))}));
}

/** Gives a page the files of a scene. */
async function giveFiles(page, file, text) {
  const files = filesOf(file, text).map(({name, bytes}) => ({name, base64: bytes.toString("base64")}));
  await page.evaluate((all) => rotatebook.player.core.takeFiles(all.map(({name, base64}) =>
    ({name, bytes: Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))}))), files);
}

module.exports = {kScenes, kMotions, filesOf, giveFiles};
