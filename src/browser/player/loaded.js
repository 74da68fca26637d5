// The scene as it was loaded: its title, the way back to where it came from, and reset.

class Loaded {
  /** `line`: .rb-title; `player`: with scene, isPlaying, core, isViewMoved, load(text, options) and apply(tree, options). */
  constructor(line, player) {
    this.line = line;
    this.player = player;
  }

  /** `record`: as of Player.load(); `origin`: {title, address} of the figure whose scene it is. */
  take(text, record, origin) { Object.assign(this, {text, record, origin}); }

  get isOpening() { return this.text === kOpening && this.isAsItWas; }
  get isAsItWas() { return this.player.scene.text === this.text && !this.player.isViewMoved; }

  /** Shows the title, but of the opening scene, which the page tells of, and the way back. */
  show() {
    const {line, origin} = this, {title = ""} = this.player.scene.tree, [words, link] = line.children;
    line.hidden = this.text === kOpening || this.player.predict.isOpen || this.player.tour.isOn;
    words.textContent = origin ? origin.title + (title.endsWith(kChanged) ? kChanged : "") : title;
    link.hidden = !origin;
    if (origin) link.href = origin.address;
  }

  /** Loads the scene as it was; the opening one, if nothing was changed. */
  reset() {
    const {player} = this, {isPlaying} = player;
    if (this.isAsItWas) player.load(kOpening, {isPlaying});
    else this.#load(isPlaying);
  }

  #load(isPlaying) { this.player.load(this.text, {record: this.record, origin: this.origin, isPlaying}); }

  /** Goes back to a text that was played since. */
  restore(text, {frame, isPlaying}) {
    const {player} = this;
    if (text === this.text) this.#load(isPlaying);
    else player.apply(player.core.treeOf(text), {frame, isPlaying});
  }
}
