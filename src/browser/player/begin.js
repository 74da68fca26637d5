// Begins when the page is there; says what the browser lacks.

const loadPicture = async (address) => {
  const picture = new Image();
  picture.src = address;
  await picture.decode();
  return picture;
};

async function loadPictures(addresses) {
  const pairs = await Promise.all(Object.entries(addresses).map(async ([name, address]) => [name, await loadPicture(address)]));
  return Object.fromEntries(pairs);
}

/** Returns the words for what is missing here, empty if nothing is. */
function lackOf() {
  if (typeof WebAssembly !== "object") return "This browser has no WebAssembly, which the live book is computed with.";
  if (typeof DecompressionStream === "undefined") return "This browser is too old for the live book: it has no DecompressionStream.";
  if (!document.createElement("canvas").getContext("webgl2")) return "This browser has no WebGL 2, which the live book is drawn with.";
  return "";
}

/** Returns the scene to begin with: the address's, if it has one. */
async function playHash(player) {
  try {
    const text = await textOfHash(location.hash);
    if (text !== null) player.load(text, {isPlaying: player.mayMove});
    return text !== null;
  } catch (error) {
    player.announcer.show(error.message, "bad");
    return false;
  }
}

function keepContext(player) {
  const {picture, view} = player.drawing;
  picture.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    player.announcer.show("The graphics were interrupted; the picture comes back as soon as the browser lets it.");
  });
  picture.addEventListener("webglcontextrestored", () => {
    view.make();
    player.restoreCloth();
    player.announcer.show("");
    player.redraw();
  });
}

async function beginLiveBook(root, data) {
  const lack = lackOf();
  if (lack) throw new Error(lack);
  const [core, pictures] = await Promise.all([Core.load(data.core), loadPictures(data.pictures)]);
  root.querySelector(".rb-player").hidden = false;
  const player = new Player(root, core, pictures, data.shaders);
  player.mayMove = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  player.begin(kOpening, player.mayMove);
  keepContext(player);
  await playHash(player);
  window.addEventListener("hashchange", async () => {
    if (await playHash(player)) root.scrollIntoView();
  });
  document.addEventListener("visibilitychange", () => player.clock.go(player.clock.position));
  new ResizeObserver(() => player.redraw()).observe(player.stage);
  window.rotatebook = {
    /** Plays a scene's text, or a clip's record; returns whether the core takes it. */
    play(text) {
      const record = text.startsWith(kFirstBytes) ? parseRecord(text) : null;
      const isPlayed = player.load(text, {record, isPlaying: player.mayMove});
      root.scrollIntoView();
      return isPlayed;
    },
    hashOf,
    player,
  };
  root.dataset.ready = "true";
}

(() => {
  const root = document.querySelector(".rb-live");
  beginLiveBook(root, kData).catch((error) => {
    const lack = root.querySelector(".rb-lack");
    root.querySelector(".rb-player").hidden = true;
    lack.hidden = false;
    lack.textContent = `The live book can’t be shown. ${error.message} Everything else on this page works.`;
    root.dataset.ready = "false";
  });
})();
