// Your own toss: a phone's sensors measure it, and it is played beside the exact motion. They are read from the button's press until the
// recording ends, and nothing leaves the page.

const kAnswer = 1, kCountDown = 3, kRecorded = 6;  // [s]
const kFewest = 30;                   // Readings a second: ten in a third of a second.
const kTossSpeed = 0.1;
const kTossFile = "toss.csv";
const kTossColumns = ["Time (s)", ...["Gyroscope ? (deg/s)", "Acceleration ? (m/s^2)"].flatMap((name) => kAxes.map((axis) => name.replace("?", axis)))];
const kNoSensors = say("No motion sensors answer here.");
const kByPhyphox = say("Or record “Gyroscope” with the app phyphox, and drop its CSV here.");

/** Why there is no toss, for people. */
class TossError extends Error {}

/**
 * Returns an event's row of kTossColumns; null if it has none. By the W3C's Device Orientation and Motion, as in browsers, alpha, beta and
 * gamma of a rate are about x, y and z of the device, x to the right and y to the top of its screen
 * (w3c.github.io/deviceorientation/#device-motion-event-rotation-rate-api); before its issue 44, it said z, x and y.
 */
function readingOf({timeStamp, rotationRate: rate, accelerationIncludingGravity: force}) {
  const row = [Math.round(1000 * timeStamp) / 1e6, rate?.alpha, rate?.beta, rate?.gamma, force?.x, force?.y, force?.z];
  return row.every(Number.isFinite) ? row : null;
}

/** Returns the scene of a flight: a phone as measured, and exactly as it began. */
function sceneOfToss({from, to, start}) {
  return {
    title: say("Your own toss"), body: {shape: "phone"}, overlay: {show: ["omega", "momentum"]},
    clip: {speed: kTossSpeed, duration: Number(((to - from) / kTossSpeed - 1 / 60).toFixed(6))},  // The last frame is within the flight.
    panel: [{label: say("measured"), simulation: {model: "recorded", file: kTossFile, from, to}},
      {label: say("exact"), simulation: {model: "exact"}, initial: {angular_velocity: start}}],
  };
}

const waitFor = (time) => new Promise((resolve) => setTimeout(resolve, 1000 * time));

class Toss {
  /** `player`: with core, files, announcer, find(selector) and load(text, options). */
  constructor(player) {
    this.player = player;
    [this.line, this.button, this.saving] = [".rb-toss [role=status]", "[data-do=toss]", "[data-do=keep]"].map(player.find);
    this.button.hidden = !isSecureContext || !window.DeviceMotionEvent;
    if (this.button.hidden) this.#show(`${isSecureContext ? kNoSensors : say("Motion sensors need a page from https.")} ${kByPhyphox}`);
  }

  #show(words) { this.line.textContent = words; }
  save() { saveBlob(new Blob([this.table], {type: "text/csv"}), kTossFile); }

  /** Asks for the sensors, within the press of the button, waits for an answer, counts down, records, and plays. */
  async record() {
    if (this.isRecording) return;
    this.isRecording = true;
    this.button.setAttribute("aria-disabled", "true");
    const readings = [];
    let listen;
    const answer = new Promise((resolve) => {
      listen = (event) => {
        const reading = readingOf(event);
        if (reading && !(reading[0] <= readings.at(-1)?.[0])) resolve(readings.push(reading));
      };
    });
    try {
      await this.#ask();
      window.addEventListener("devicemotion", listen);
      await Promise.race([answer, waitFor(kAnswer)]);
      if (readings.length === 0) throw new TossError(`${kNoSensors} ${kByPhyphox}`);
      await this.#countDown();
      this.#play(readings);
    } catch (error) {
      if (!(error instanceof TossError)) throw error;
      this.#show(error.message);
    } finally {
      window.removeEventListener("devicemotion", listen);
      this.button.removeAttribute("aria-disabled");
      this.isRecording = false;
    }
  }

  /** Safari on iOS, and the W3C's text, have a question; other browsers don't ask. */
  async #ask() {
    const answer = await DeviceMotionEvent.requestPermission?.().catch(() => "denied");
    if (answer && answer !== "granted") throw new TossError(`${say("The sensors may not be read: permission refused.")} ${kByPhyphox}`);
  }

  async #countDown() {
    for (let left = kCountDown; left > 0; --left) {
      this.#show(`${left} …`);
      await waitFor(1);
    }
    this.#show(say("Toss it now!"));
    await waitFor(kRecorded);
  }

  #play(readings) {
    const {core, files, announcer, find} = this.player;
    const rate = Math.round((readings.length - 1) / (readings.at(-1)[0] - readings[0][0])) || 0;
    this.table = [kTossColumns, ...readings, ""].join("\n");
    this.saving.hidden = false;
    if (rate < kFewest) throw new TossError(say("Only {rate} readings a second; a toss needs {least}.", {rate, least: kFewest}));
    const flight = core.flight(readings.map((row) => row.map((value, i) => (i > 0 && i < 4 ? value * Math.PI / 180 : value))));
    if (!flight) throw new TossError(say("Nothing flew: no spinning free fall was found."));
    this.#show("");
    files.take([{name: kTossFile, bytes: new TextEncoder().encode(this.table)}]);
    this.player.load(core.textOf(sceneOfToss(flight)), {isPlaying: true});
    const frames = core.frames(kPlayed);
    while (core.advance(kPlayed, frames - 1, 1e6) < frames) { /* Both are simulated. */ }
    const [angle] = core.numbers(kPlayed, 0, frames - 1, [kSample.error]);
    announcer.show(say("It flew for {time}, and ends {angle}° from the exact motion of an even plate.",
      {time: seconds(flight.to - flight.from), angle: say.number(angle.toFixed(1))}), "good");
    find(".rb-player").scrollIntoView();
  }
}
