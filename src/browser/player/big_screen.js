// The big screen: the picture and its controls alone, in full screen or in a frame of another page; and the light look.

class BigScreen {
  /** `player`: with drawing and redraw(). */
  constructor(root, player) {
    this.root = root;
    this.player = player;
    this.button = root.querySelector("[data-do=full]");
    this.isEmbedded = false;
    this.button.hidden = !document.fullscreenEnabled;
    root.addEventListener("fullscreenchange", () => this.#show());
  }

  get isFull() { return document.fullscreenElement === this.root; }

  #show() {
    this.root.classList.toggle("rb-bare", this.isFull || this.isEmbedded);
    this.button.setAttribute("aria-label", this.isFull ? say("Leave full screen") : say("Full screen"));
    this.player.redraw();
  }

  /** Nothing else of this page is there, and a link leads to the whole. */
  embed() {
    const link = this.root.querySelector(".rb-whole");
    link.href = location.href.split("#")[0] + hashInFrame(location.hash);
    link.hidden = false;
    this.root.querySelector("#rb-title").setAttribute("aria-level", "1");  // The only heading there.
    this.isEmbedded = true;
    this.#show();
  }

  toggle() {
    if (this.isFull) document.exitFullscreen();
    else this.root.requestFullscreen?.().catch(() => {});  // Refused without a user's gesture, which is no error.
  }

  leave() {
    if (this.isFull) document.exitFullscreen();
  }

  toggleLight() {
    const isLight = this.root.classList.toggle("rb-light");
    this.root.querySelector("[data-do=light]").setAttribute("aria-pressed", String(isLight));
    const {drawing, ball, ladder, timeline} = this.player;
    for (const part of [drawing.view, ball, ladder, timeline]) part.isLight = isLight;
    this.player.redraw();
  }
}
