// A clip's player: a <video> that knows its frames. It tells of each frame by the event "frame".
"use strict";

/** The simulated time of each frame. [s] */
const timesOf = (clip) => clip.times ?? Array.from({length: clip.frames}, (unused, index) => index * clip.interval);

/** A clip that is a GIF or an APNG. No browser tells its frame: its plots stay at the poster's. */
class MovingPicture extends EventTarget {
  constructor(section, clip) {
    super();
    this.section = section;
    this.times = timesOf(clip);
    this.frame = clip.poster;
    const picture = section.querySelector(".screen img"), start = section.querySelector(".start");
    start.hidden = false;
    start.addEventListener("click", () => {
      const isMoving = start.classList.toggle("playing");
      picture.src = isMoving ? picture.dataset.moving : picture.dataset.poster;
      start.setAttribute("aria-label", isMoving ? say("Stop {title}", {title: picture.alt}) : say("Play {title}", {title: picture.alt}));
    });
    for (const event of section.querySelectorAll(".events button")) event.replaceWith(event.textContent);
  }

  frameNearest() { return this.frame; }
  seek() {}
  pause() {}
}

const kIdleAfter = 2500;  // [ms]

class Player extends EventTarget {
  static all = [];

  /** section: a .clip of the page; clip: its data, {rate: [60, 1], frames: 720, ...}. */
  constructor(section, clip) {
    super();
    this.section = section;
    this.video = section.querySelector("video");
    this.element = section.querySelector(".player");
    this.frames = clip.frames;
    this.rate = clip.rate[0] / clip.rate[1];
    this.times = timesOf(clip);
    this.frame = 0;
    this.next = null;  // the frame to go to when the video is done with going to another
    this.looping = true;
    this.find = (name) => section.querySelector(".controls " + name);
    this.video.controls = false;
    this.find("").hidden = false;
    this.connectVideo();
    this.connectControls();
    this.connectFullScreen();
    this.show(clip.poster);  // The picture that is there until the clip plays, from its start.
  }

  connectVideo() {
    const video = this.video;
    // Only while it plays: else a browser that is sent to the last frame takes it for the end, and goes back to the first.
    video.loop = false;
    for (const name of ["play", "pause"]) {
      video.addEventListener(name, () => {
        video.loop = this.looping && !video.paused;
        this.showPlaying();
      });
    }
    // The picture and the plots stop at one and the same frame.
    video.addEventListener("pause", () => { if (!video.ended) this.seek(this.frame); });
    video.addEventListener("ended", () => this.show(this.frames - 1));
    video.addEventListener("seeked", () => this.arrive());
    video.addEventListener("click", () => this.toggle());
    if (video.requestVideoFrameCallback) {
      const onFrame = (now, data) => {
        if (!video.seeking && !video.paused) this.show(Math.round(data.mediaTime * this.rate));
        video.requestVideoFrameCallback(onFrame);
      };
      video.requestVideoFrameCallback(onFrame);
    } else {
      const onPaint = () => {
        if (!video.paused && !video.seeking) this.show(this.frameAt(video.currentTime));
        requestAnimationFrame(onPaint);
      };
      requestAnimationFrame(onPaint);
    }
  }

  connectControls() {
    const video = this.video;
    this.find(".play").addEventListener("click", () => this.toggle());
    this.find(".back").addEventListener("click", () => this.step(-1));
    this.find(".on").addEventListener("click", () => this.step(1));
    this.find(".seek").addEventListener("input", (event) => this.seek(Number(event.target.value)));
    this.find(".loop").addEventListener("click", (event) => {
      this.looping = !this.looping;
      video.loop = this.looping && !video.paused;
      event.currentTarget.setAttribute("aria-pressed", String(this.looping));
    });
    for (const button of this.section.querySelectorAll(".speed button")) {
      button.addEventListener("click", () => Player.setSpeed(Number(button.dataset.speed)));
    }
    this.find(".words").addEventListener("click", () => this.toggleCaptions());
    for (const event of this.section.querySelectorAll(".events button")) {
      event.addEventListener("click", () => this.goTo(Number(event.dataset.frame)));
    }
    const start = this.section.querySelector(".start");
    start.hidden = false;
    start.addEventListener("click", () => this.toggle());
    video.addEventListener("play", () => {
      // The focus doesn't get lost with the button.
      if (document.activeElement === start) this.find(".play").focus({preventScroll: true});
      start.hidden = true;
    });
    Player.all.push(this);
  }

  /** One speed for all clips. */
  static setSpeed(speed) {
    for (const {video, section} of Player.all) {
      // A video that is loaded later begins with the default.
      video.defaultPlaybackRate = video.playbackRate = speed;
      for (const button of section.querySelectorAll(".speed button")) {
        button.setAttribute("aria-pressed", String(Number(button.dataset.speed) === speed));
      }
    }
  }

  toggleCaptions() {
    const [track] = this.video.textTracks;
    const shown = track.mode !== "showing";
    track.mode = shown ? "showing" : "disabled";
    this.find(".words").setAttribute("aria-pressed", String(shown));
  }

  /** Pauses at a frame. */
  goTo(frame) {
    this.video.pause();
    this.seek(frame);
  }

  connectFullScreen() {
    const {element, video} = this;
    // A phone may know full screen for videos alone, with controls of its own.
    this.canFillScreen = document.fullscreenEnabled === true || Boolean(video.webkitEnterFullscreen);
    const button = this.find(".full");
    button.hidden = !this.canFillScreen;
    button.addEventListener("click", () => this.toggleFullScreen());
    element.addEventListener("fullscreenchange", () => {
      const words = this.fillsScreen() ? say("Leave full screen") : say("Full screen");
      button.setAttribute("aria-label", words);
      button.title = words + " (f)";
      // So that the space bar plays the clip, and doesn't press this button again.
      if (this.fillsScreen()) this.find(".play").focus({preventScroll: true});
      this.stayAwake();
    });
    for (const name of ["pointermove", "pointerdown", "keydown"]) element.addEventListener(name, () => this.stayAwake());
    for (const name of ["play", "pause"]) video.addEventListener(name, () => this.stayAwake());
  }

  fillsScreen() {
    return document.fullscreenElement === this.element;
  }

  toggleFullScreen() {
    if (this.fillsScreen()) document.exitFullscreen();
    // Refused without a user's gesture, which is no error.
    else if (document.fullscreenEnabled) this.element.requestFullscreen().catch(() => {});
    else this.video.webkitEnterFullscreen();
  }

  /** In full screen, shows the controls while the clip is paused, and for a while after the user has done something. */
  stayAwake() {
    clearTimeout(this.falling);
    this.element.classList.remove("idle");
    if (!this.fillsScreen() || this.video.paused) return;
    this.falling = setTimeout(() => this.element.classList.add("idle"), kIdleAfter);
  }

  /** The frame shown at `time` [s]; the millisecond is for times that were rounded. */
  frameAt(time) {
    return Math.floor((time + 0.001) * this.rate);
  }

  /** The frame nearest to `time`, a simulated one. */
  frameNearest(time) {
    const after = this.times.findIndex((each) => each > time);
    if (after < 1) return after < 0 ? this.frames - 1 : 0;
    return time - this.times[after - 1] < this.times[after] - time ? after - 1 : after;
  }

  toggle() {
    if (this.video.paused) this.play();
    else this.video.pause();
  }

  play() {
    const started = this.video.play();
    // A pause before the clip has loaded is no error.
    if (started) started.catch((error) => { if (error.name !== "AbortError") throw error; });
  }

  step(frames) {
    this.goTo(this.frame + frames);
  }

  seek(frame) {
    const wanted = Math.min(Math.max(Math.round(frame), 0), this.frames - 1);
    if (this.video.preload === "none") this.video.preload = "auto";
    // One at a time: a browser that is sent elsewhere again and again may never arrive. What waited before is wanted no more.
    this.next = this.video.seeking ? wanted : null;
    if (this.next === null) this.video.currentTime = (wanted + 0.5) / this.rate;
    this.show(wanted);
  }

  arrive() {
    const next = this.next;
    this.next = null;
    if (next === null) this.show(this.frameAt(this.video.currentTime));
    else this.seek(next);
  }

  show(frame) {
    this.frame = Math.min(Math.max(frame, 0), this.frames - 1);
    const seconds = say.number(this.times[this.frame].toFixed(2)) + " s", values = {seconds, frame: this.frame};
    const seek = this.find(".seek");
    seek.value = this.frame;
    seek.setAttribute("aria-valuetext", say("frame {frame}, {seconds}", values));
    this.find(".time").textContent = say("{seconds} · frame {frame}", values);
    this.dispatchEvent(new Event("frame"));
  }

  showPlaying() {
    const playing = !this.video.paused;
    const button = this.find(".play");
    button.classList.toggle("playing", playing);
    button.setAttribute("aria-label", playing ? say("Pause") : say("Play"));
    if (playing) this.dispatchEvent(new Event("play"));
  }
}
