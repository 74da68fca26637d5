// Predict, then see: a question over books at rest, and its answer by letting them go.

const kCommonStart = "clip.duration = 14\noverlay.show = [\"omega\"]\n";
const kTasks = [
  {
    question: say("Three books, each spun about another axis, with the same tiny push. Which of these will tumble?"),
    answers: [say("about y, its height"), say("about x, its width"), say("about z, its thickness")], right: 1, arePanels: true, until: 4,
    see: say("The one about x, its middle axis. About the other two the push stays small."),
    scene: `title = "${say("Which of these will tumble?")}"
${kCommonStart}simulation.model = "exact"
[[panel]]
label = "${say("y, its height")}"
initial = { angular_velocity = [0, 4, 0], tilt = [0.014, "x"] }
[[panel]]
label = "${say("x, its width")}"
initial = { angular_velocity = [4, 0, 0], tilt = [0.014, "z"] }
[[panel]]
label = "${say("z, its thickness")}"
initial = { angular_velocity = [0, 0, 4], tilt = [0.014, "x"] }
`,
  },
  {
    question: say("The first book turns over after two seconds. The second, with a tilt ten times smaller, will …"),
    answers: [say("never turn over"), say("turn over a second later"), say("turn over ten times later")], right: 1, until: 5,
    see: say("A second later: the tilt grows by the same factor each second, however small it was."),
    scene: `title = "${say("A tilt ten times smaller")}"
${kCommonStart}simulation.model = "exact"
initial.angular_velocity = [4, 0, 0]
[[panel]]
label = "${say("tilt 0.014")}"
initial.tilt = [0.014, "z"]
[[panel]]
label = "${say("tilt 0.0014")}"
initial.tilt = [0.0014, "z"]
`,
  },
  {
    question: say("The computer takes steps. In long ones, the second of these books will …"),
    answers: [say("move the same"), say("turn over at other times"), say("stop")], right: 1, until: 12,
    see: say("At other times: each step makes a small error, and this motion makes small errors grow."),
    scene: `title = "${say("In long steps")}"
${kCommonStart}initial = { angular_velocity = [4, 0, 0], tilt = [0.014, "z"] }
[[panel]]
label = "${say("exact")}"
simulation.model = "exact"
[[panel]]
label = "${say("6 steps a picture")}"
simulation = { model = "quaternion", integrator = "euler", substeps = 6 }
`,
  },
];

/** The box beneath the picture, with a text and buttons, of a question or of a step of the tour. */
class Box {
  constructor(element, player) {
    this.element = element;
    this.player = player;
    this.text = element.querySelector(".rb-question-text");
    this.buttons = element.querySelector(".rb-answers");
    new ResizeObserver(() => this.#makeRoom()).observe(element);
  }

  /** The picture gets lower, so that all is in the window; where that is too low, what is above scrolls away. */
  #makeRoom() {
    const {element, player} = this;
    player.root.style.setProperty("--rb-asked", `${element.offsetHeight}px`);
    if (!element.hidden) player.find(".rb-transport").scrollIntoView({block: "nearest"});
  }

  /** Shows a text and buttons, each [words, action, properties], and takes the focus there. */
  show(text, buttons) {
    this.text.textContent = text;
    this.buttons.replaceChildren(...buttons.map(([words, action, properties]) => {
      const button = make("button", {type: "button", ...properties}, words);
      button.addEventListener("click", action);
      return button;
    }));
    this.element.hidden = false;
    this.element.dataset.shared = this.player.read.motions.length > 1;
    this.#makeRoom();  // Before the next picture, so that nobody clicks where a book just was.
    this.text.focus({preventScroll: true});
    // On a small screen, the books are above the question.
    if (this.player.stage.getBoundingClientRect().top < 0) this.player.find(".rb-player").scrollIntoView();
  }

  hide() { this.element.hidden = true; }
}

class Predict {
  /** `player`: with load(text), tour, start(), announcer. */
  constructor(box, player) {
    this.box = box;
    this.player = player;
    this.task = -1;
    this.isOpen = false;
    this.before = null;
  }

  get isAsking() { return this.isOpen && this.chosen === null; }
  get current() { return kTasks[this.task]; }

  next() { this.ask((this.task + 1) % kTasks.length); }

  /** `isStep`: in a tour, which goes on. */
  ask(task, isStep = false) {
    const {scene, frame, isPlaying} = this.player;
    if (!isStep) this.before ??= {text: scene.text, frame, isPlaying};
    this.player.load(kTasks[task].scene, {isPlaying: false, isQuestion: true, isStep});
    Object.assign(this, {task, isStep, chosen: null, isAnswered: false, isOpen: true});
    this.player.loaded.show();
    this.#show(this.current.question, this.current.answers.map((answer, i) => [answer, () => this.choose(i)]));
  }

  #show(text, buttons, next = []) {
    const ways = this.isStep ? this.player.tour.ways : [...next, [say("Close"), () => this.close(), {className: "rb-close"}]];
    this.box.show(text, [...buttons, ...ways]);
  }

  /** Somebody wants to see before the answer. */
  insist() {
    this.box.text.focus({preventScroll: true});
    this.player.announcer.announce(say("First choose an answer."));
  }

  /** A cover was clicked: an answer, where the answers are the books. */
  choosePanel(panel) {
    if (panel >= 0 && this.isAsking && this.current.arePanels) this.choose(panel);
  }

  choose(answer) {
    this.chosen = answer;
    this.#show(say("You said: {answer}. Now see …", {answer: this.current.answers[answer]}), []);
    this.player.start();
  }

  /** Called as time passes; `isEnd` if there is no more to see. */
  tick(time, isEnd) {
    if (!this.isOpen || this.chosen === null || this.isAnswered || (time < this.current.until && !isEnd)) return;
    this.isAnswered = true;
    const words = `${this.chosen === this.current.right ? say("Right.") : say("Not quite.")} ${this.current.see}`;
    this.#show(words, [], [[this.task + 1 < kTasks.length ? say("Next question") : say("From the first"), () => this.next()]]);
    this.player.announcer.announce(words);
  }

  /** Another scene is played: the question was of the former. */
  leave() {
    if (this.isOpen) this.box.hide();
    this.isOpen = false;
    this.before = null;
  }

  /** What was played before the questions comes back. */
  close() {
    const {before} = this;
    this.leave();
    if (before) this.player.loaded.restore(before.text, before);
    this.player.stage.focus({preventScroll: true});
  }
}
