// The whole page: its players and plots, keys, light and dark.
"use strict";

(() => {
  const root = document.documentElement;
  const darkSystem = matchMedia("(prefers-color-scheme: dark)");
  const players = new Map();  // by section
  const plots = new Map();  // by section
  const visible = new Map();  // share of each clip's <video> that is in the window
  let lastUsed = null;

  /** The clip's video; null of a GIF or an APNG. */
  const videoOf = (section) => section.querySelector("video");

  /** Only one clip moves at a time. */
  function pauseOthers(player) {
    for (const other of players.values()) {
      if (other !== player) other.video.pause();
    }
    lastUsed = player;
  }

  /** The line of HTML that shows a clip in another page; from a file, the two are to lie side by side. */
  function showLine(section) {
    const video = videoOf(section), details = section.querySelector(".elsewhere");
    const address = (name) => (location.protocol === "file:" ? video.getAttribute(name) : new URL(video.getAttribute(name), location.href).href);
    details.querySelector("pre").textContent = `<video controls loop muted playsinline preload="none" width="${video.width}" height="${video.height}" poster="${address("data-poster")}" src="${address("src")}"></video>`;
    details.hidden = false;
  }

  function build(section) {
    const clip = JSON.parse(section.querySelector("script.data").textContent);
    if (!videoOf(section)) {
      plots.set(section, makePlots(section, clip, new MovingPicture(section, clip)));
      return;
    }
    showLine(section);
    const player = new Player(section, clip);
    players.set(section, player);
    player.addEventListener("play", () => pauseOthers(player));
    plots.set(section, makePlots(section, clip, player));
  }

  /** The small picture without words is there from the start; the whole poster is loaded where it is seen. */
  function showPoster(section) {
    const video = videoOf(section), picture = section.querySelector(".screen img");
    if (video) video.poster = video.dataset.poster;
    else if (!section.querySelector(".playing")) picture.src = picture.dataset.poster;
  }

  // All that takes room is there at once, so that links and the browser find what they look for; only curves far below the
  // window cost nothing until they come near.
  const sections = [...document.querySelectorAll(".clip")];
  sections.forEach(build);
  const near = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      near.unobserve(entry.target);
      plots.get(entry.target).forEach((plot) => plot.draw());
      showPoster(entry.target);
      if (videoOf(entry.target)) seen.observe(videoOf(entry.target));
    }
  }, {rootMargin: "600px"});

  // No clip starts to load, or to move, before somebody wants it.
  const seen = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      const player = players.get(entry.target.closest(".clip"));
      visible.set(player, entry.intersectionRatio);
      if (entry.intersectionRatio < 0.1) player.video.pause();
    }
  }, {threshold: [0, 0.1, 0.6]});
  sections.forEach((section) => near.observe(section));

  /** The player that keys are for: the one in full screen, else the one with the focus, else the one last used if it can be seen, else the most visible. */
  function activePlayer() {
    const full = players.get(document.fullscreenElement?.closest(".clip"));
    if (full) return full;
    const focused = players.get(document.activeElement?.closest(".clip"));
    if (focused) return focused;
    if (visible.get(lastUsed) > 0.1) return lastUsed;
    const [best] = [...visible].sort((a, b) => b[1] - a[1]);
    return best && best[1] > 0.1 ? best[0] : null;
  }

  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || event.target.closest(".live")) return;
    const takesArrows = event.target.closest("input, select, textarea, pre, .scroll, [contenteditable]");
    if (contents && !takesArrows && !document.fullscreenElement && ["ArrowLeft", "ArrowRight"].includes(event.key)) {
      contents[event.key === "ArrowLeft" ? "previous" : "next"]();
      event.preventDefault();
      return;
    }
    const player = activePlayer();
    if (!player) return;
    const takesSpace = event.target.closest("button, a, summary, input:not([type=range])");
    if (event.key === " " && !takesSpace) player.toggle();
    else if (event.key === ",") player.step(-1);
    else if (event.key === ".") player.step(1);
    else if (event.key === "c") player.toggleCaptions();
    else if (event.key === "f" && player.canFillScreen) player.toggleFullScreen();
    else return;
    event.preventDefault();
  });

  /** Opens what a linked figure is folded away in, before the browser goes there. */
  function unfold(hash) {
    const folded = document.getElementById(decodeURIComponent(hash.slice(1)))?.closest(".folded:not([open])");
    if (folded) folded.open = true;
    return folded;
  }
  document.addEventListener("click", (event) => {
    const link = event.target.closest("a[href^='#']");
    if (link) unfold(link.hash);
  });
  /** Of an address that somebody opens, or goes back to, the browser has looked for the place already. */
  function land() {
    if (unfold(location.hash)) document.getElementById(decodeURIComponent(location.hash.slice(1))).scrollIntoView();
  }
  addEventListener("hashchange", land);
  land();

  const nav = document.querySelector(".contents");
  const contents = nav ? makeContents(nav, [...document.querySelectorAll(".figure")]) : null;

  // The live book, where the page has one, takes the scenes of all figures once it is ready, or says that it never will be. The
  // buttons' room is there from the start.
  const toys = document.querySelector(".live") ? [...document.querySelectorAll(".toy")] : [];
  function connectToys() {
    const {rotatebook} = window, isReady = Boolean(rotatebook?.play), isLacking = document.querySelector(".rb-live")?.dataset.ready === "false";
    for (const toy of toys) {
      toy.hidden = isLacking;
      toy.querySelector("button").disabled = !isReady;
    }
  }
  for (const toy of toys) {
    toy.addEventListener("click", () => {
      const figure = toy.closest(".figure"), data = figure.querySelector("script.data"), address = "#" + encodeURIComponent(figure.id);
      // The way back leads to the figure.
      history.replaceState(null, "", address);
      location.hash = "#play";
      window.rotatebook?.play(figure.querySelector("pre.scene").textContent, (data && JSON.parse(data.textContent).checksum) ?? null,
        {title: figure.querySelector("h2").textContent, address});
    });
  }
  connectToys();
  document.addEventListener("rotatebook-live", connectToys);

  // On paper, all figures, curves and whole posters.
  const unfolded = [];  // for printing alone
  addEventListener("afterprint", () => unfolded.splice(0).forEach((folded) => { folded.open = false; }));
  addEventListener("beforeprint", () => {
    for (const folded of document.querySelectorAll(".folded:not([open])")) {
      folded.open = true;
      unfolded.push(folded);
    }
    for (const section of sections) {
      showPoster(section);
      plots.get(section).forEach((plot) => plot.draw());
    }
  });

  const theme = document.querySelector(".theme");
  const isDark = () => (root.style.colorScheme || (darkSystem.matches ? "dark" : "light")) === "dark";

  function showTheme() {
    theme.textContent = isDark() ? say("Switch to light") : say("Switch to dark");
    [...plots.values()].flat().forEach((plot) => plot.plot?.redraw(false, true));
  }
  theme.hidden = false;
  theme.addEventListener("click", () => {
    root.style.colorScheme = isDark() ? "light" : "dark";
    showTheme();
    try { localStorage.setItem("theme", root.style.colorScheme); } catch { /* Not every browser keeps anything for files. */ }
  });
  darkSystem.addEventListener("change", showTheme);
  try {
    const kept = localStorage.getItem("theme");
    if (kept === "light" || kept === "dark") root.style.colorScheme = kept;
  } catch { /* As above. */ }
  showTheme();
  document.querySelector(".keys").hidden = sections.length === 0;
})();
