// Files that are dropped or chosen: clips are proved, scenes, meshes and recordings are played.

class Files {
  /** `player`: with core, announcer, drawing, edits, mayMove and load(text, options). */
  constructor(player) {
    this.player = player;
    this.things = [];
  }

  /** Takes files that scenes may name, {name, bytes}, in place of all others. */
  take(things) {
    this.things = things;
    this.player.core.takeFiles(things);
    this.player.drawing.forgetBodies();
  }

  /** Proves a clip and plays its scene, or plays a dropped scene. A later file takes this one's place. */
  async open(file) {
    const job = this.job = {}, edits = this.player.edits, isWanted = () => this.job === job;
    this.player.announcer.show(say("Reading {file} …", {file: file.name}));
    try {
      if (/\.toml$/i.test(file.name)) await this.#openScene(file, isWanted);
      else if (isThing(file.name)) await this.#openThing(file, isWanted);
      else await this.#openClip(file, isWanted, edits);
    } catch (error) {
      if (!isWanted()) return;
      const isExpected = error instanceof RecordError || error instanceof SceneError;
      this.player.announcer.show(error instanceof RecordError ? error.message : `${file.name}: ${refusalOf(error.message)}`, "bad");
      if (!isExpected) throw error;
    }
  }

  async #openScene(file, isWanted) {
    if (file.size > this.player.core.words.longestScene) throw new SceneError(say("it is longer than 32 KiB, the limit for a scene"));
    const text = await readable(file.name, () => file.text());
    if (isWanted()) this.player.load(text, {isPlaying: this.player.mayMove, file: file.name});
  }

  async #openThing(file, isWanted) {
    if (file.size > kLargestThing) throw new SceneError(say("it is longer than 1 MB, the limit here; rotatebook render takes it"));
    const bytes = new Uint8Array(await readable(file.name, () => file.arrayBuffer()));
    if (!isWanted()) return;
    const before = this.things;
    try {
      this.take([{name: file.name, bytes}]);
      this.#playFirst(scenesOfThing(file.name, this.player.core));
    } catch (error) {
      this.take(before);  // The scene that goes on names them.
      throw error;
    }
  }

  /** Plays the first scene that the core accepts; throws its problem with the first if there is none. */
  #playFirst(trees) {
    let problem = null;
    for (const tree of trees) {
      const text = this.player.core.textOf(tree);
      try {
        this.player.core.read(kProof, text);
      } catch (error) {
        problem ??= error;
        continue;
      }
      this.player.load(text, {isPlaying: this.player.mayMove});
      return;
    }
    throw problem;
  }

  async #openClip(file, isWanted, edits) {
    // Both take the same slot.
    if (this.player.saver.isSaving) throw new RecordError(say("{file} has to wait: a clip is being saved. Drop it again once that is done or cancelled.", {file: file.name}));
    const tell = (share) => this.player.announcer.show(say("Simulating {file} again … {share} %", {file: file.name, share: Math.floor(100 * share)}));
    const proof = await proveClip(this.player.core, file, tell, isWanted);
    if (!proof || !isWanted()) return;
    // Nothing that was done meanwhile is lost.
    const isPlayed = this.player.edits === edits && this.player.load(proof.record.text, {record: proof.record, frame: parseInt(proof.record.frames) || 0, isPlaying: this.player.mayMove});
    const aside = isPlayed ? "" : " " + say("You went on meanwhile, so it isn’t played; drop it again to play it.");
    this.player.announcer.show(proof.words + aside, proof.isProved ? "good" : "bad");
  }
}
