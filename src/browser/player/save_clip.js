// Saves what is played as a clip: each frame of the scene's own clock, however long that takes, with its record.

const kClipName = "live-book";
const kNoHand = {held: null, seen: (book, sample) => sample};  // Nobody holds a book in a clip.
const kLargestClip = [1920, 1080];  // [pixels]
const kFirstGuess = 20;             // Pictures, from which on the time left is said.

/** Lets the page draw and answer, in a tab that is hidden, too, whose timers are slow. */
const gap = () => new Promise((resolve) => {
  const {port1, port2} = new MessageChannel();
  port1.onmessage = () => {
    port1.close();
    resolve();
  };
  port2.postMessage(null);
});

/** Returns the size [pixels] at which a clip is saved: even, and no larger than kLargestClip. */
function savedSize([width, height]) {
  const share = Math.min(1, kLargestClip[0] / width, kLargestClip[1] / height);
  return [width, height].map((side) => Math.max(2 * Math.round(share * side / 2), 16));
}

/** Says the time that is left, rounded to 10 s or to minutes; what was said stays until it is clearly off. */
class TimeLeft {
  /** Returns the words when n of all pictures took so long [s]; empty as long as that is too early to say. */
  wordsAt(n, all, passed) {
    if (n < kFirstGuess) return "";
    const left = passed * (all / n - 1), step = left < 105 ? 10 : 60;
    if (this.said === undefined || Math.abs(left - this.said) > 0.75 * step) this.said = Math.max(step * Math.round(left / step), step);
    return this.said < 120 ? `${this.said} s` : `${this.said / 60} min`;
  }
}

/** Returns the record of a clip, or of its frames in `part`, whose pictures are this browser's, as the program writes records. */
function recordOfClip({version, motion, text, part}, kind) {
  const [, name = "unknown", number = ""] = /(Firefox|Edg|Chrome|Version)\/(\d+)/.exec(navigator.userAgent) ?? [];
  const browser = {Edg: "Edge", Version: "Safari"}[name] ?? name;
  return `# Made by rotatebook ${version} from the scene ${kClipName}\n# Renderer: ${kBrowserRenderer}${browser} ${number}, WebGL 2, ${kind}\n` +
    `# Motion: ${motion}\n${part ? `# Frames: ${part}\n` : ""}\n${text}`;
}

/** Returns the core with the clip's motion, in the slot for proofs, in place of what is played; `ghosts`: its ghost's samples by motion and frame. */
function coreOfClip(core, ghosts) {
  return new Proxy(core, {get: (target, name) => {
    if (typeof target[name] !== "function") return target[name];
    if (name === "sample") {
      return (slot, motion, frame) => (slot === kGhost ? ghosts[motion][frame] : target.sample(kProof, motion, frame));
    }
    return (slot, ...values) => target[name](slot === kPlayed ? kProof : slot, ...values);
  }});
}

class ClipSaver {
  /** `player`: with core, scene, read, orbit, book, simulation, materials, announcer, sharedText(). */
  constructor(root, player) {
    this.player = player;
    this.row = root.querySelector(".rb-saving");
    this.button = root.querySelector("[data-do=clip]");
    this.length = root.querySelector(".rb-length");
    this.job = null;
  }

  get isSaving() { return this.job !== null; }
  cancel() { this.job = null; }

  async save() {
    if (this.isSaving) return;
    const job = this.job = {isWanted: () => this.job === job}, {announcer} = this.player;
    announcer.show("");
    this.player.job = job;  // A clip that is being proved gives up its place.
    this.#show(0, say("Saving the clip …"));
    this.row.hidden = false;
    this.button.setAttribute("aria-disabled", "true");
    try {
      await this.#save(job);
      announcer.show(...(job.isWanted() ? [job.words, "good"] : [say("The clip isn’t saved: cancelled.")]));
    } catch (error) {
      announcer.show(say("The clip isn’t saved: {problem}", {problem: error.message}), "bad");
      if (!(error instanceof ClipError || error instanceof SceneError)) throw error;
    } finally {
      job.file?.close();
      job.picture?.close();
      this.job = null;
      if (this.row.contains(document.activeElement)) this.button.focus();
      this.row.hidden = true;
      this.button.removeAttribute("aria-disabled");
    }
  }

  #show(share, words) {
    this.row.querySelector("progress").value = share;
    this.row.querySelector("span").textContent = words;
  }

  async #save(job) {
    const clip = await this.#simulate(job);
    if (!clip) return;
    const {core, materials} = this.player, {size, first, frames} = clip, left = new TimeLeft();
    const picture = job.picture = new ClipPicture(coreOfClip(core, clip.ghosts), materials, size, clip.state);
    picture.draw(first);
    const file = job.file = await fileFor(picture.canvas, clip, materials.muxer);
    await file.start();
    const start = performance.now();
    for (let n = 1; n <= frames; ++n) {
      picture.draw(first + n - 1);
      await file.add(n - 1);
      const time = left.wordsAt(n, frames, (performance.now() - start) / 1000), numbers = {n, all: frames, time};
      this.#show(n / frames, time ? say("Picture {n} of {all}, about {time} left", numbers) : say("Picture {n} of {all}", numbers));
      await gap();
      if (!job.isWanted()) return;
    }
    const blob = await file.finish(), name = `${kClipName}.${file.ending}`;
    if (!job.isWanted()) return;
    saveBlob(blob, name);
    job.words = say("Saved {name}: {frames} pictures of {width}x{height}, {kind}, with the record of its motion. Drop it here to prove it.",
      {name, frames, width: size[0], height: size[1], kind: file.kind});
  }

  /** Returns the first of the frames to save, of `all`, and how many: those from `shown` on, or the last ones if they are too few. */
  #partOf(all, shown, rate) {
    const frames = Math.min(all, Math.round(Number(this.length.value) * rate)), first = Math.min(shown, all - frames);
    return {first, frames, part: frames < all ? `${first}:${first + frames}` : ""};
  }

  /** Simulates the clip in the slot for proofs, and what its ghost does before; null once it isn't wanted. */
  async #simulate({isWanted}) {
    const {player} = this, {core, frame: shown} = player, {ghostText} = player.simulation, book = player.book;
    const orbit = player.canShareView ? {right: 0, up: 0, distance: 1} : {...player.orbit};
    const tree = core.treeOf(player.sharedText());
    const size = savedSize(player.scene.explicit.clip.size);
    tree.clip = {...tree.clip, size};
    const text = core.textOf(tree);
    const progress = (share) => this.#show(0, say("Simulating … {share} %", {share: Math.floor(100 * share)}));
    const ghosts = ghostText === null ? [] : await ghostSamples(core, ghostText, progress, isWanted);
    if (!ghosts) return null;
    const read = core.read(kProof, text);
    if (!await simulateToEnd(core, kProof, progress, isWanted)) return null;
    const whole = core.sceneText(kProof), scene = new LiveScene(tree, core.treeOf(whole), text, core.words);
    const frames = core.frames(kProof), rate = read.rate[0] / read.rate[1], clock = {isPlaying: false, rate}, simulation = {ghostFrames: ghosts[0]?.length ?? 0};
    const state = {frames, clock, scene, read, orbit, book, simulation, hand: kNoHand, scales: scalesAtStart(core, kProof, read.motions)};
    return {size, ghosts, ...this.#partOf(frames, shown, rate), state, text: whole, title: scene.explicit.title ?? "", rate: read.rate, motion: core.checksum(kProof), version: core.words.version};
  }
}

/** Returns the samples of a ghost's motions, by motion and frame; null once they aren't wanted. */
async function ghostSamples(core, text, progress, isWanted) {
  const {motions} = core.read(kProof, text);
  if (!await simulateToEnd(core, kProof, progress, isWanted)) return null;
  return motions.map((_, motion) => Array.from({length: core.frames(kProof)}, (unused, frame) => core.sample(kProof, motion, frame)));
}

/** Returns the file that this browser can make of a clip. */
async function fileFor(canvas, clip, packedMuxer) {
  const {rate, title, first} = clip, record = (kind) => recordOfClip(clip, kind);
  const choice = await codecFor(canvas, rate[0] / rate[1]);
  if (!choice) return new PictureFile(canvas, record("PNG"), first);
  const comment = record(choice.codec.name);
  return new VideoFile(canvas, choice, rate, title ? {title, comment} : {comment}, await muxerOf(packedMuxer));
}
