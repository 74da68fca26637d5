// Begins when the page is there; says what the browser lacks.

const kHashPause = 400;  // [ms]
const kMisspelt = /^#(tour=|embed[#&])/;  // Where neither a step nor a scene follows.
const kLongestPart = 30;

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
  if (typeof WebAssembly !== "object") return say("This browser has no WebAssembly, which the live book is computed with.");
  if (typeof DecompressionStream === "undefined") return say("This browser is too old for the live book: it has no DecompressionStream.");
  return "";
}

const notAStep = (hash) => say("“{part}” in this link is no step of the tour, from #tour=1 to #tour={last}; in a frame, #embed&tour=1.",
  {part: hash.length > kLongestPart ? `${hash.slice(0, kLongestPart)}…` : hash, last: kTour.length});

/** Opens the tour's step, or plays the scene, in the address, if it has one; says what it has instead. Returns whether there is anything to see. */
async function playHash(player) {
  const {hash} = location, wanted = hashInFrame(hash), step = tourStepOf(wanted);
  if (step !== null) {
    player.tour.open(step);
    return true;
  }
  let text = null, problem = kMisspelt.test(hash) ? notAStep(hash) : "";
  try {
    text = await textOfHash(wanted, player.core.words.longestScene);
    if (text !== null) problem = "";
  } catch (error) {
    problem = error.message;
  }
  if (location.hash !== hash) return false;
  if (text !== null) player.load(text, {isPlaying: player.mayMove, refused: (words) => { problem = `${words}.`; }});
  else if (player.tour.isOn) player.tour.leave();
  const {title = ""} = player.scene.tree;
  if (problem) player.outcome.say(title ? `${problem} ${say("Shown instead: {title}.", {title})}` : problem);
  return text !== null || problem !== "";
}

/** An address that holds a scene follows the changes, once they pause. */
function keepHash(player) {
  let waiting = null;
  player.onEdit = () => {
    clearTimeout(waiting);
    if (!location.hash.startsWith(kHash)) return;
    waiting = setTimeout(async () => {
      const {edits} = player, hash = await hashOf(player.sharedText());
      if (player.edits === edits && location.hash.startsWith(kHash)) history.replaceState(null, "", hash);
    }, kHashPause);
  };
}

function keepContext(player) {
  const {picture, view} = player.drawing;
  picture.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    player.outcome.warn(view.lack);
    player.redraw();
  });
  picture.addEventListener("webglcontextrestored", () => {
    view.make();
    player.restoreCloth();
    player.outcome.warn("");
    player.redraw();
  });
}

async function beginLiveBook(root, data) {
  const lack = lackOf();
  if (lack) throw new Error(lack);
  const [core, pictures, shaders] = await Promise.all([Core.load(data.core), loadPictures(data.pictures), unpackedText(data.shaders)]);
  root.querySelector(".rb-player").hidden = false;
  const player = new Player(root, core, {pictures, shaders: JSON.parse(shaders), muxer: data.muxer});
  player.mayMove = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  player.begin(kOpening, player.mayMove);
  if (kEmbed.test(location.hash)) player.bigScreen.embed();
  keepContext(player);
  keepHash(player);
  await playHash(player);
  window.addEventListener("hashchange", async () => {
    if (await playHash(player)) root.scrollIntoView();
  });
  document.addEventListener("visibilitychange", () => player.clock.go(player.clock.position));
  new ResizeObserver(() => player.redraw()).observe(player.stage);
  new IntersectionObserver((changes) => { player.isSeen = changes.at(-1).isIntersecting; }).observe(player.stage);
  // A clip that begins beside it has the processor to itself: both together drop pictures where no graphics card draws.
  document.addEventListener("play", () => { if (player.isSeen) player.pause(); }, true);
  window.rotatebook = {
    /**
     * Plays a scene's text, beside which its clip's record states the checksum `motion`, if any; `origin`: as of Loaded.take(). Returns whether
     * the core takes it.
     */
    play(text, motion = null, origin = null) {
      const record = motion && {motion};
      const isPlayed = player.load(text, {record, origin, isPlaying: player.mayMove});
      root.scrollIntoView();
      return isPlayed;
    },
    hashOf,
    player,
  };
  root.dataset.ready = "true";
}

(async () => {
  const root = document.querySelector(".rb-live");
  say.within(root);
  try {
    await beginLiveBook(root, kData);
  } catch (error) {
    const lack = root.querySelector(".rb-lack");
    root.querySelector(".rb-player").hidden = true;
    lack.hidden = false;
    lack.append(make("img", {src: kData.pictures.front, alt: ""}), say("The live book can’t be shown. {problem}", {problem: error.message}));
    // In the page of figures, which come later.
    if (root.closest(".live")) lack.append(" ", make("a", {href: "#page/figures"}, say("Everything else on this page works.")));
    root.dataset.ready = "false";
  }
  document.dispatchEvent(new Event("rotatebook-live"));  // For the page around it.
})();
