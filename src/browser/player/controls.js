// The controls that are made from rows: choices, knobs and what is shown.

const short = (number) => say.number(Number(number.toPrecision(6)));

/** Builds an element: make("label", {className: "x"}, child, "text"). */
function make(name, properties = {}, ...children) {
  const element = Object.assign(document.createElement(name), properties);
  element.append(...children);
  return element;
}

class Controls {
  /** `player`: with scene, core, book (the one that is edited) and apply(tree, options). */
  constructor(root, player) {
    this.root = root;
    this.player = player;
    this.refreshers = [];
    this.#makeChoice("frame", Object.entries(kFrames), (scene, book) => scene.frameOf(book), (frame) => player.setFrame(frame), (frame) => frame !== "momentum");
    const why = root.querySelector("[data-do=why]");
    this.refreshers.push(() => why.setAttribute("aria-pressed", String(player.showsWhy)));
    const throwing = root.querySelectorAll("[data-do=throw], [data-do=jiggle], [data-choice=model]");
    this.refreshers.push(() => { for (const control of throwing) control.disabled = !player.canThrow(); });
    this.#makeChoice("model", player.core.words.models.map(({name}) => [name, say(name)]), (scene, book) => scene.value(book, "simulation", "model"),
      (model) => player.apply(player.scene.withModel(player.book, model)));
    this.#makeChoice("books", [["one", say("one")], ["same", say("two")], ["exact", say("two, one exact")]], (scene) => player.booksChoice(scene),
      (choice) => player.setBooks(choice), (choice, model) => choice === "one" || model !== "recorded" && (choice !== "exact" || model !== "exact"));
    this.#makeEdited();
    this.#makeIntegrator();
    for (const knob of kKnobs) this.#makeKnob(knob);
    this.#makeNormalize();
    for (const [overlay, words] of Object.entries(kShownOverlays)) this.#makeShown(overlay, words);
  }

  refresh() {
    const {scene, book} = this.player;
    for (const refresh of this.refreshers) refresh(scene, book, scene.value(book, "simulation", "model"));
  }

  /** Returns whether a key changes motions of a model. */
  #has(model, key) { return this.player.core.words.keys[key].models.includes(model); }

  #group(name) { return this.root.querySelector(`[data-group="${name}"]`); }

  #makeChoice(name, options, get, put, isOffered = () => true) {
    const box = this.root.querySelector(`[data-choice="${name}"]`), row = make("div", {className: "rb-segments"});
    const inputs = options.map(([value, words]) => {
      const input = make("input", {type: "radio", name: "rb-" + name, value});
      input.addEventListener("change", () => put(value));
      row.append(make("label", {}, input, make("span", {}, words)));
      return input;
    });
    box.append(row);
    this.refreshers.push((scene, book, model) => {
      const value = get(scene, book);
      for (const input of inputs) {
        input.checked = input.value === value;
        input.parentElement.hidden = !input.checked && !isOffered(input.value, model);
      }
    });
  }

  /** The choice of the book that knobs are of, as many as there are. */
  #makeEdited() {
    const box = this.root.querySelector("[data-choice=edited]");
    this.refreshers.push((scene, book) => {
      box.hidden = scene.bookCount < 2;
      const labels = this.player.labels;
      if (box.dataset.labels !== labels.join("\n")) {
        box.dataset.labels = labels.join("\n");
        box.replaceChildren(make("span", {className: "rb-name"}, say("Settings of")), make("div", {className: "rb-segments"}, ...labels.map((label, i) => {
          const input = make("input", {type: "radio", name: "rb-edited", value: String(i)});
          input.addEventListener("change", () => this.player.edit(i));
          return make("label", {}, input, make("span", {}, label));
        })));
      }
      for (const input of box.querySelectorAll("input")) input.checked = Number(input.value) === book;
    });
  }

  #makeIntegrator() {
    const select = make("select"), row = make("label", {className: "rb-row"}, make("span", {className: "rb-name"}, say("Integrator")), select);
    select.addEventListener("change", () => this.player.apply(this.player.scene.withKeys(this.player.book, "simulation", {integrator: select.value})));
    this.#group("motion").append(row);
    this.refreshers.push((scene, book, model) => {
      const names = this.player.core.words.models.find(({name}) => name === model)?.integrators ?? [];
      row.hidden = names.length === 0;
      if (select.dataset.model !== model) select.replaceChildren(...names.map((name) => make("option", {value: name}, say(name))));
      select.dataset.model = model;
      select.value = scene.value(book, "simulation", "integrator") ?? "";
    });
  }

  #makeNormalize() {
    const input = make("input", {type: "checkbox"}), row = make("label", {className: "rb-check"}, input, say("Normalise after each step"));
    input.addEventListener("change", () => this.player.apply(this.player.scene.withKeys(this.player.book, "simulation",
      {normalize: input.checked, normalize_energy: undefined, remove_drift: undefined})));
    this.#group("motion").append(row);
    this.refreshers.push((scene, book, model) => {
      row.hidden = !this.#has(model, "simulation.normalize");
      const value = scene.value(book, "simulation", "normalize");
      input.checked = value === true;
      input.indeterminate = typeof value === "object";
    });
  }

  #makeShown(overlay, words) {
    const input = make("input", {type: "checkbox"}), row = make("label", {className: "rb-check"}, input, words);
    input.addEventListener("change", () => this.player.see(this.player.scene.withShown(overlay, input.checked)));
    this.#group("shown").append(row);
    this.refreshers.push((scene, book, model) => {
      row.hidden = !this.player.core.words.overlays[overlay].includes(model);
      input.checked = scene.shows(overlay);
    });
  }

  #makeKnob(knob) {
    const scale = knob.logarithmic ? Math.log10 : (value) => value;
    const back = knob.logarithmic ? (value) => 10 ** value : (value) => value;
    const range = make("input", {type: "range", min: scale(knob.least), max: scale(knob.most), step: knob.step ?? "any"});
    const key = `${knob.section}.${knob.key}`, {type, ...known} = this.player.core.words.keys[key];
    const unit = knob.unit ?? known.unit, isWhole = type === "integer";
    const name = unit ? `${knob.label} [${unit}]` : knob.label;
    range.setAttribute("aria-label", knob.label);
    const field = make("input", {type: "text", inputMode: "decimal", spellcheck: false, autocomplete: "off"});
    const row = make("div", {className: "rb-row"}, make("span", {className: "rb-name"}, name), range, field);
    field.setAttribute("aria-label", name);
    const get = knob.get ?? ((scene, book) => scene.value(book, knob.section, knob.key));
    const put = knob.put ?? ((scene, book, value) => scene.withKeys(book, knob.section, {[knob.key]: value}));
    const set = (value) => {
      if (!Number.isFinite(value)) this.player.announcer.show(say("{name}: this is no number.", {name: knob.label}), "bad");
      else this.player.apply(put(this.player.scene, this.player.book, value));
    };
    range.addEventListener("input", () => {
      const value = back(Number(range.value));
      set(isWhole ? Math.round(value) : Number(value.toPrecision(3)));
    });
    const isSame = (a, b) => isWhole && Math.round(back(a)) === Math.round(back(b));
    const next = (value, sign) => scale(Math.round(back(value)) + sign);
    range.addEventListener("keydown", (event) => this.#stepKnob(event, range, isSame, next));
    field.addEventListener("change", () => set(Number(field.value.replace(",", ".") || NaN)));
    this.#group(knob.group).append(row);
    this.refreshers.push((scene, book, model) => {
      const value = Number(get(scene, book));
      row.hidden = !this.#has(model, key) || Number.isNaN(value);
      if (row.hidden) return;
      range.value = scale(Math.max(value, knob.logarithmic ? knob.least : -Infinity));
      range.setAttribute("aria-valuetext", `${short(value)}${unit ? " " + unit : ""}`);
      if (document.activeElement !== field) field.value = short(value);
    });
  }

  /** Browsers differ in the step of "any": a fiftieth of the way here, or to the `next` whole number if that would be the same. */
  #stepKnob(event, range, isSame, next) {
    const sign = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key];
    if (!sign) return;
    event.preventDefault();
    const before = Number(range.value), after = before + sign * (range.max - range.min) / 50;
    range.value = isSame(before, after) ? next(before, sign) : after;
    range.dispatchEvent(new Event("input"));
  }
}
