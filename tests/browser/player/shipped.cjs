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

module.exports = {kScenes, kMotions};
