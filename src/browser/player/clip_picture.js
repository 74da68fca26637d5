// The pictures of a clip to save, on a canvas of its own: the books, the lines, the ball of spins and the words.

// Shares of the picture's shorter side, as in the program's clips, and of its whole.
const kClipTitle = 0.046, kClipLetters = 0.035, kClipMargin = 0.045, kClipBall = 0.28, kClipUnit = 1 / 600;
const kClipShade = 0.64, kClipLineHeight = 1.3, kLongestClipLine = 56;

/** The stage, of a size in pixels instead of the page's. */
class ClipStage extends Stage {
  constructor(core, {pictures, shaders}, size) {
    super({querySelector: () => document.createElement("canvas")}, core, pictures, shaders);
    this.size = size;
  }

  get sharpness() { return Math.min(...this.size) * kClipUnit; }
  get unit() { return this.sharpness; }
  room() { return {left: 0, top: 0, right: this.box.width, named: 0}; }
  get box() { return {width: this.size[0] / this.sharpness, height: this.size[1] / this.sharpness}; }
}

/** Returns a text's lines, none wider than `width` but of a single word. */
function wrapped(context, text, width) {
  const lines = [];
  for (const paragraph of text.split("\n")) {
    let line = "";
    for (const word of paragraph.split(" ")) {
      const longer = line ? `${line} ${word}` : word;
      if (line && context.measureText(longer).width > width) {
        lines.push(line);
        line = word;
      } else line = longer;
    }
    lines.push(line);
  }
  return lines;
}

/** Returns the caption at a frame: the scene's, or the last of those in time, `captions`, as the core has them. */
function captionAt(captions, caption, frame) {
  return captions.reduce((shown, [from, text]) => (from <= frame ? text : shown), caption);
}

class ClipPicture {
  /** `state`: as Stage.draw() takes it, with the clip's `frames`, and `book`, whose ball is shown; `materials`: {pictures, shaders}. */
  constructor(core, materials, size, state) {
    this.core = core;
    this.state = state;
    this.stage = new ClipStage(core, materials, size);
    this.stage.view.setCloth(clothOf(state.scene));
    this.ball = new PolhodeBall(document.createElement("canvas"));
    this.ladder = new Ladder(document.createElement("canvas"));
    this.canvas = Object.assign(document.createElement("canvas"), {width: size[0], height: size[1]});
    this.context = this.canvas.getContext("2d", {alpha: false});
    this.side = Math.min(...size);
    this.margin = kClipMargin * this.side;
  }

  /** Draws a frame; in the same task its pixels are there. */
  draw(frame) {
    const {context, state, stage} = this, {scene, read} = state;
    stage.draw(frame, state);
    if (stage.view.lack) throw new ClipError(stage.view.gl ? say("The graphics were interrupted; save the clip again.") : stage.view.lack);
    context.drawImage(stage.picture, 0, 0);
    context.drawImage(stage.lines, 0, 0);
    const {title = "", caption = ""} = scene.explicit;
    const bottom = scene.shows("caption") ? this.#drawCaption(title, captionAt(read.captions, caption, frame)) : this.canvas.height;
    if (scene.shows("polhode")) this.#drawBall(frame, bottom);
    if (scene.shows("energy_ladder")) this.#drawLadder(frame, bottom, scene.shows("polhode"));
    if (scene.shows("forces")) this.#drawLegend(frame);
    if (read.motions.length > 1) this.#drawLabels(read.motions);
    if (scene.shows("clock")) this.#drawClock(this.#timeText(frame), read.motions.length > 1, bottom);
  }

  #write(text, x, y, size, {colour = "#f7f5ed", weight = 400, align = "left"} = {}) {
    const {context} = this;
    context.font = `${weight} ${size}px system-ui, sans-serif`;
    context.textAlign = align;
    context.textBaseline = "top";
    context.lineJoin = "round";
    context.lineWidth = 0.16 * size;
    context.strokeStyle = kColours.halo;
    context.strokeText(text, x, y);
    context.fillStyle = colour;
    context.fillText(text, x, y);
  }

  /** Draws title and caption at the bottom, over a shade unless the scene has none; returns the first row that they take. */
  #drawCaption(title, caption) {
    const {context, canvas, margin, side} = this, lines = [];
    const add = (text, size, weight) => {
      if (!text) return;
      context.font = `${weight} ${size}px system-ui, sans-serif`;
      const room = Math.min(canvas.width - 2 * margin, kLongestClipLine * kClipLetters * side);
      for (const line of wrapped(context, text, room)) lines.push({line, size, weight});
    };
    add(title, kClipTitle * side, 600);
    add(caption, kClipLetters * side, 400);
    if (lines.length === 0) return canvas.height;
    const height = lines.reduce((sum, {size}) => sum + kClipLineHeight * size, 0), top = canvas.height - margin - height;
    const shade = context.createLinearGradient(0, top - 1.5 * margin, 0, top);
    shade.addColorStop(0, "rgba(0, 0, 0, 0)");
    shade.addColorStop(1, `rgba(0, 0, 0, ${kClipShade})`);
    context.fillStyle = shade;
    if (this.state.scene.hasBand) context.fillRect(0, top - 1.5 * margin, canvas.width, canvas.height);
    let y = top;
    for (const {line, size, weight} of lines) {
      this.#write(line, margin, y, size, {weight});
      y += kClipLineHeight * size;
    }
    return top;
  }

  #drawBall(frame, bottom) {
    const {core, state: {read, book}, canvas, margin} = this, size = Math.round(kClipBall * this.side);
    this.ball.draw(read.motions[book].moments, trailOf(core, book, frame), size, size / 170);
    this.context.drawImage(this.ball.canvas, canvas.width - size - margin / 2, Math.min(bottom, canvas.height - margin / 2) - size);
  }

  #drawLadder(frame, bottom, isBesideBall) {
    const {core, state: {book}, canvas, margin} = this, size = Math.round(kClipBall * this.side), {canvas: ladder} = this.ladder;
    this.ladder.draw(core.ladder(kPlayed, book, frame), size, size / 170);
    const right = canvas.width - margin / 2 - (isBesideBall ? size + margin / 2 : 0);
    this.context.drawImage(ladder, right - ladder.width, Math.min(bottom, canvas.height - margin / 2) - size);
  }

  /** The kinds of forces, below the clock, and a bar for their scale. */
  #drawLegend(frame) {
    const {core, state: {read, book, scene}, context, margin} = this, {longest} = core.forces(kPlayed, book, frame);
    if (!(longest > 0)) return;
    const size = 0.8 * kClipLetters * this.side, bar = roundedDown(0.35 * longest), {kinds, length} = legendOf(longest, bar, read.motions[book], scene.frameOf(book));
    const rows = [...kinds.map(({words, colour}) => [1.6 * size, words, colour]),
      [length * this.stage.pixelsOfMetre(book) * this.stage.sharpness, `${say.number(String(bar))} N/kg`, "#ffffff"]];
    rows.forEach(([width, words, colour], i) => {
      const y = margin + (2.2 + 1.4 * i) * size;
      context.fillStyle = colour;
      context.fillRect(margin, y + 0.5 * size, width, 0.15 * size);
      this.#write(words, margin + width + 0.6 * size, y, size);
    });
  }

  #drawLabels(motions) {
    const size = kClipLetters * this.side;
    motions.forEach(({label}, i) => {
      const {x, y, width} = this.stage.books[i].area;
      this.context.save();
      this.context.beginPath();
      this.context.rect(x, y, width, 3 * size);
      this.context.clip();
      this.#write(label, x + 0.6 * size, y + 0.4 * size, size, {weight: 600, colour: kBookColours[i]});
      this.context.restore();
    });
  }

  /** Returns the time, and the speed of the clip where it isn't 1. */
  #timeText(frame) {
    const timeOf = (at) => this.core.numbers(kPlayed, 0, at, [kSample.time])[0], {rate} = this.state.clock;
    const from = Math.min(frame, this.state.frames - 2), speed = from < 0 ? 1 : Number((rate * (timeOf(from + 1) - timeOf(from))).toPrecision(3));
    return `t = ${seconds(timeOf(frame))}${speed === 1 ? "" : `  ${say.number(speed)}×`}`;
  }

  #drawClock(text, isShared, bottom) {
    const {canvas, margin} = this, size = kClipLetters * this.side;
    if (isShared) this.#write(text, canvas.width - margin, Math.min(bottom, canvas.height - margin) - 1.4 * size, size, {align: "right"});
    else this.#write(text, margin, margin, size);
  }

  close() { this.stage.view.gl?.getExtension("WEBGL_lose_context")?.loseContext(); }
}
