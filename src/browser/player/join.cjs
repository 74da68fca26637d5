// Joins the live book into one page that needs no other file: join.cjs CORE.js CORE.wasm MUXER.js VERSION OUTPUT-FOLDER.
"use strict";

const fs = require("node:fs");
const path = require("node:path");
const zlib = require("node:zlib");
const {execFileSync} = require("node:child_process");

const kHere = __dirname, kRoot = path.join(kHere, "../../..");
const kPictures = {front: 660, back: 660, spine: 176, paper: 256};  // Widths. [pixels]
const kQuality = "80";
// In this order, in one function: pages that are opened as files can't load modules.
const kScripts = ["record", "share", "core", "live_scene", "things", "clock", "book_view", "arrows", "plain_book", "polhode_ball", "forces", "poinsot", "ladder", "timeline",
  "events", "knobs", "controls", "hand", "pointer", "proof", "predict", "tour", "stage", "clip_picture", "picture_zip", "clip_files", "save_clip", "numbers", "simulation",
  "throws", "outcome", "files", "loaded", "toss", "big_screen", "player", "commands", "begin"];
const kShaders = {book: "body.vert", whole_picture: "whole_picture.vert", cover: "cover.frag", surface: "surface.frag", paper: "paper.frag", studio: "studio.frag",
  stars: "stars.frag", studio_scatter: "studio_scatter.glsl", studio_shine: "studio_shine.glsl", tone_curve: "tone_curve.frag"};

const read = (...names) => fs.readFileSync(path.join(...names), "utf8");

/**
 * The browser's version line comes from the player. What is handed from vertices to pixels is taken within the triangle: at the edge, where only
 * some of a pixel's samples are in it, it would be that of a place beside the triangle, and shine. The program takes one sample a pixel.
 */
function shader(file) {
  const handedOn = file.endsWith(".vert") ? /^out /gm : /^in /gm;
  return read(kRoot, "shaders", file).replace(/^#version .*\n/, "").replace(/^\s*\/\/.*\n/gm, "").replace(handedOn, "centroid $&");
}

function picture(name, width, folder) {
  const file = path.join(folder, name + ".webp");
  execFileSync("cwebp", ["-quiet", "-q", kQuality, "-m", "6", "-resize", String(width), "0", path.join(kRoot, "assets", name + ".png"), "-o", file]);
  return "data:image/webp;base64," + fs.readFileSync(file).toString("base64");
}

const mapped = (object, action) => Object.fromEntries(Object.entries(object).map(([key, value]) => [key, action(value, key)]));

/** The list of words in a language but for those of the page's figures, as JSON: each of its lines is a key and a text as JSON has them, too. */
function wordsIn(file) {
  const own = read(kRoot, "assets/words", file).split("\n[story]\n")[0];
  return Object.fromEntries([...own.matchAll(/^("(?:[^"\\]|\\.)*") = ("(?:[^"\\]|\\.)*")$/gm)].map(([, english, text]) => [JSON.parse(english), JSON.parse(text)]));
}

/** A script's text must not end its element. */
const inScript = (text) => text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");

/** Shortens scripts or styles, by the esbuild that joined the muxer; names that all of them share stay. */
function shortened(text, muxer, loader = "js") {
  const esbuild = path.join(path.dirname(muxer), "node_modules/.bin/esbuild");
  return execFileSync(esbuild, ["--minify", "--charset=utf8", "--loader=" + loader], {input: text, encoding: "utf8"});
}

const zipped = (content) => zlib.gzipSync(content, {level: 9}).toString("base64");

function fragment(glue, wasm, muxer, folder) {
  const data = {
    core: zipped(fs.readFileSync(wasm)),
    muxer: zipped(fs.readFileSync(muxer)),
    shaders: zipped(JSON.stringify(mapped(kShaders, shader))),
    pictures: mapped(kPictures, (width, name) => picture(name, width, folder)),
  };
  const scripts = [read(kRoot, "assets/page/words.js"), ...kScripts.map((name) => read(kHere, name + ".js"))];
  const script = ["(() => {", "\"use strict\";", read(glue), `const kData = ${JSON.stringify(data)};`, shortened(scripts.join("\n"), muxer), "})();"].join("\n");
  return `<style>\n${shortened(read(kHere, "player.css"), muxer, "css")}</style>\n${read(kHere, "player.html")}<script>\n${inScript(script)}\n</script>\n`;
}

const [glue, wasm, muxer, version, folder] = process.argv.slice(2);
fs.mkdirSync(folder, {recursive: true});
const live = fragment(glue, wasm, muxer, folder);
fs.writeFileSync(path.join(folder, "live_book.html"), live);
const icon = /<link rel="icon"[^>]*>/.exec(read(kRoot, "assets/page/index.html"))[0];
const german = JSON.stringify(wordsIn("german.toml")).replaceAll("<", "\\u003C");
const values = {version, icon, german, words: read(kRoot, "assets/page/words.js"), "live-book": live};
fs.writeFileSync(path.join(folder, "play.html"), read(kHere, "page.html").replace(/\{\{([a-z-]+)\}\}/g, (place, name) => values[name]));
