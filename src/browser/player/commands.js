// Buttons, keys, dropped files and clicks on the ball.

const kActionsOfKeys = {x: (player) => player.throwAbout("x"), y: (player) => player.throwAbout("y"), z: (player) => player.throwAbout("z"),
  j: (player) => player.jiggle(), r: (player) => player.reset(), ",": (player) => player.step(-1), ".": (player) => player.step(1),
  f: (player) => player.bigScreen.toggle(), Escape: (player) => (player.hand.held ? player.hand.putBack() : player.bigScreen.leave()),
  Home: (player) => player.seek(0), End: (player) => player.seek(player.lastFrame)};
const kBallStep = 0.06;  // Of a key. [rad]

class Commands {
  constructor(root, player) {
    this.root = root;
    this.player = player;
    root.addEventListener("click", (event) => this.#click(event));
    root.addEventListener("keydown", (event) => this.#key(event));
    const seek = root.querySelector(".rb-seek");
    seek.addEventListener("input", () => {
      player.pause();
      player.seek(Number(seek.value));
    });
    root.querySelector("[data-speed]").addEventListener("change", ({target}) => {
      player.slowsAtFlips = target.value === "flips";
      player.speed = Number(target.value) || 1;
    });
    root.querySelector(".rb-more").addEventListener("toggle", () => player.redraw());
    this.#takeFiles();
    this.#listenToBall();
  }

  #click(event) {
    const {do: name, axis} = event.target.closest("[data-do]")?.dataset ?? {}, {player} = this;
    const actions = {toggle: () => player.toggle(), back: () => player.step(-1), forward: () => player.step(1), jiggle: () => player.jiggle(),
      throw: () => player.throwAbout(axis), why: () => player.toggleWhy(), tour: () => player.tour.open(0),
      full: () => player.bigScreen.toggle(), light: () => player.bigScreen.toggleLight(),
      reset: () => player.reset(), predict: () => player.predict.next(), copy: () => this.#copy(player.sharedText(), say("The scene is in the clipboard."), say("The scene is below, ready to copy.")),
      toss: () => player.toss.record(), keep: () => player.toss.save(),
      save: () => saveText(player.sharedText(), "live-book.toml"), clip: () => player.saver.save(), cancel: () => player.saver.cancel(), link: () => this.#copyLink(), frame: () => this.#copyFrame()};
    actions[name]?.();
  }

  async #copyLink() {
    const hash = await hashOf(this.player.sharedText());
    history.replaceState(null, "", hash);
    await this.#copy(location.href, say("The link is in the clipboard."), say("The link is below, ready to copy."));
  }

  /** A line of HTML for another page, with the sensors of a toss. A file's folder means nothing elsewhere: from a file, the two are to lie side by side. */
  async #copyFrame() {
    const [page] = location.href.split("#"), hash = await hashOf(this.player.sharedText());
    const src = `${location.protocol === "file:" ? page.replace(/.*\//, "") : page}#embed&${hash.slice(1)}`;
    const frame = make("iframe", {src, title: say("The live book"), width: "960", height: "600", allow: "accelerometer; gyroscope", allowFullscreen: true, loading: "lazy"});
    await this.#copy(frame.outerHTML, say("A line of HTML for the course page is in the clipboard."), say("A line of HTML for the course page is below, ready to copy."));
  }

  async #copy(text, done, ready) {
    const {isViewMoved, canShareView} = this.player;
    const view = isViewMoved && !canShareView ? " " + say("It can’t hold the turned view, as its camera turns with the book.") : "";
    const isCopied = await copyText(text), area = this.root.querySelector(".rb-text");
    area.value = text;
    area.hidden = isCopied;
    if (isCopied) {
      this.player.announcer.show(done + view, "good");
      return;
    }
    this.player.announcer.show(ready + view);
    area.focus();
    area.select();
  }

  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const {target} = event, isRange = target.matches("input[type=range], input[type=radio]");
    if (target.matches("input[type=text], textarea, select")) return;
    if (target === this.player.stage && this.player.pointer.key(event)) {
      event.preventDefault();
      return;
    }
    if (target.matches(".rb-ball") && this.#ballKey(event)) {
      event.preventDefault();
      return;
    }
    const takesSpace = target.closest("button, a, summary, label, input:not([type=range])");
    const isTheirs = isRange && /^(Home|End|Arrow)/.test(event.key);
    if (event.key === " " && !takesSpace) this.player.toggle();
    else if (!isTheirs && kActionsOfKeys[event.key]) kActionsOfKeys[event.key](this.player);
    else return;
    event.preventDefault();
  }

  #takeFiles() {
    const {root, player} = this, input = root.querySelector("input[type=file]");
    input.addEventListener("change", async () => {
      if (input.files[0]) await player.open(input.files[0]);
      input.value = "";
    });
    const hasFiles = (event) => [...event.dataTransfer?.types ?? []].includes("Files");
    // Anywhere on the page: a clip that is dropped beside the player shouldn't replace the page.
    document.addEventListener("dragover", (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      root.classList.add("rb-taking");
    });
    document.addEventListener("dragleave", (event) => { if (!event.relatedTarget) root.classList.remove("rb-taking"); });
    document.addEventListener("drop", (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      root.classList.remove("rb-taking");
      const file = event.dataTransfer.files[0];
      if (file) player.open(file);
    });
  }

  #listenToBall() {
    const {ball} = this.player;
    ball.canvas.addEventListener("click", (event) => {
      const box = ball.canvas.getBoundingClientRect(), scale = ball.canvas.width / box.width;
      const direction = ball.directionAt((event.clientX - box.left) * scale, (event.clientY - box.top) * scale);
      if (direction) this.#startAlong(direction);
    });
  }

  /** Starts with an angular momentum along a direction in the book's axes, as large as it is. */
  #startAlong(direction) {
    if (!this.player.canThrow()) return;
    const {player} = this, {moments} = player.read.motions[player.book];
    const size = player.scales[player.book].momentum;
    if (!player.apply(player.scene.withVelocity(player.book, direction.map((part, axis) => size * part / moments[axis])), {frame: 0})) return;
    player.outcome.expect(player.core.spin(kPlayed, player.book));
    player.announcer.announce(player.outcome.words);
  }

  #ballKey(event) {
    const [x, y] = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key] ?? [0, 0];
    if (!x && !y) return false;
    const {player} = this, {rows} = player.ball;
    const from = momentumInBook(player.core.sample(kPlayed, player.book, 0));
    const moved = from.map((part, axis) => part + kBallStep * (x * rows[0][axis] + y * rows[1][axis])), size = Math.hypot(...moved);
    this.#startAlong(moved.map((part) => part / size));
    return true;
  }
}
