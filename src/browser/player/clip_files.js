// What the pictures of a saved clip become: an MP4 or a WebM by the browser's encoder, or else a ZIP of PNGs.

/** What keeps a clip from being saved; the message is for people. */
class ClipError extends Error {}

// As the first that encodes a picture is taken; a level that has room for 1920x1080 at 60 pictures a second.
const kCodecs = [
  {name: "H.264", short: "avc", ending: "mp4", format: "Mp4OutputFormat", codecs: ["avc1.64002a", "avc1.4d002a", "avc1.42e02a"], more: {avc: {format: "avc"}}},
  {name: "VP9", short: "vp9", ending: "webm", format: "WebMOutputFormat", codecs: ["vp09.00.41.08"], more: {}},
];
const kBitsPerPixel = 0.12;
const kKeyInterval = 2;        // [s]
const kMostInEncoder = 3;      // [frames]
const kFirstFrameTime = 8000;  // What says that it encodes, and then doesn't, is given up. [ms]

const pause = (time) => new Promise((resolve) => { setTimeout(resolve, time); });

function encodeFrame(encoder, canvas, frame, rate) {
  const at = (count) => Math.round(1e6 * count / rate);
  const picture = new VideoFrame(canvas, {timestamp: at(frame), duration: at(frame + 1) - at(frame)});
  try {
    encoder.encode(picture, {keyFrame: frame % Math.max(Math.round(kKeyInterval * rate), 1) === 0});
  } finally {
    picture.close();
  }
}

/** Returns whether the browser does encode a frame: some only say so. */
async function encodesAFrame(config, canvas) {
  let isMade = false, encoder;
  try {
    if (!(await VideoEncoder.isConfigSupported(config)).supported) return false;
    encoder = new VideoEncoder({output: (chunk, meta) => { isMade ||= chunk.byteLength > 0 && Boolean(meta?.decoderConfig); }, error: () => {}});
    encoder.configure(config);
    encodeFrame(encoder, canvas, 0, config.framerate);
    await Promise.race([encoder.flush(), pause(kFirstFrameTime)]);
    return isMade;
  } catch {
    return false;
  } finally {
    if (encoder && encoder.state !== "closed") encoder.close();
  }
}

/** Returns {codec, config} of the first codec that encodes what is on the canvas; null if none does. */
async function codecFor(canvas, rate) {
  if (typeof VideoEncoder === "undefined") return null;
  const {width, height} = canvas, bitrate = Math.round(kBitsPerPixel * width * height * rate);
  for (const codec of kCodecs) {
    for (const name of codec.codecs) {
      const config = {codec: name, width, height, bitrate, framerate: rate, latencyMode: "quality", ...codec.more};
      if (await encodesAFrame(config, canvas)) return {codec, config};
    }
  }
  return null;
}

/**
 * Puts a void in place of the target's name, "MOVIE", in front of a WebM's tags: to FFmpeg a tag below a name isn't "comment", as
 * those that rotatebook writes are, but "MOVIE/comment".
 */
function withoutTargetName(bytes) {
  const name = [0x63, 0xca, 0x85, ...new TextEncoder().encode("MOVIE")];
  for (let at = bytes.indexOf(name[0]); at >= 0; at = bytes.indexOf(name[0], at + 1)) {
    if (!name.every((byte, i) => bytes[at + i] === byte)) continue;
    bytes.set([0xec, 0x80 + name.length - 2, 0, 0, 0, 0, 0, 0], at);
    return bytes;
  }
  return bytes;
}

let muxer = null;

/** The muxer is code that is packed with the page, and made when it is first asked for. */
async function muxerOf(packedText) {
  muxer ??= new Function(`${await unpackedText(packedText)}\nreturn Mediabunny;`)();
  return muxer;
}

class VideoFile {
  /** `rate`: [n, d], pictures a second; `tags`: {title, comment}. */
  constructor(canvas, {codec, config}, rate, tags, muxer) {
    this.canvas = canvas;
    this.ending = codec.ending;
    this.kind = codec.name;
    this.rate = rate;
    this.muxer = muxer;
    this.output = new muxer.Output({format: new muxer[codec.format](), target: new muxer.BufferTarget()});
    this.source = new muxer.EncodedVideoPacketSource(codec.short);
    this.output.addVideoTrack(this.source, {frameRate: rate[0] / rate[1]});
    this.output.setMetadataTags(tags);
    this.written = Promise.resolve();
    this.encoder = new VideoEncoder({output: (chunk, meta) => this.#write(chunk, meta), error: (error) => { this.problem = error; }});
    this.encoder.configure(config);
  }

  start() { return this.output.start(); }

  #write(chunk, meta) {
    const [n, d] = this.rate, frame = Math.round(chunk.timestamp * n / d / 1e6);
    const bytes = new Uint8Array(chunk.byteLength);
    chunk.copyTo(bytes);
    const packet = new this.muxer.EncodedPacket(bytes, chunk.type, frame * d / n, d / n);
    this.written = this.written.then(() => this.source.add(packet, meta));
    this.written.catch((error) => { this.problem ??= error; });
  }

  #check() {
    if (this.problem) throw new ClipError(say("The browser’s encoder has broken off: {problem}", {problem: this.problem.message}));
  }

  /** Adds what is on the canvas as the clip's frame of that number. */
  async add(frame) {
    this.#check();
    try {
      encodeFrame(this.encoder, this.canvas, frame, this.rate[0] / this.rate[1]);
    } catch (error) {
      this.problem ??= error;
      this.#check();
    }
    while (this.encoder.encodeQueueSize > kMostInEncoder && !this.problem) {
      await Promise.race([new Promise((resolve) => { this.encoder.addEventListener("dequeue", resolve, {once: true}); }), pause(100)]);
    }
  }

  async finish() {
    try {
      await this.encoder.flush();
    } catch (error) {
      this.problem ??= error;
    }
    await this.written.catch(() => {});
    this.#check();
    await this.output.finalize();
    const bytes = new Uint8Array(this.output.target.buffer);
    return new Blob([this.ending === "webm" ? withoutTargetName(bytes) : bytes], {type: `video/${this.ending}`});
  }

  close() {
    if (this.encoder.state !== "closed") this.encoder.close();
    if (!["finalized", "canceled"].includes(this.output.state)) this.output.cancel().catch(() => {});
  }
}

class PictureFile {
  /** `first`: the number of the first picture, as in the whole clip. */
  constructor(canvas, record, first) {
    this.canvas = canvas;
    this.first = first;
    this.ending = "zip";
    this.kind = "PNG";
    this.zip = new StoredZip();
    this.record = record;
  }

  async start() { this.zip.add("scene.toml", new TextEncoder().encode(this.record)); }

  async add(frame) {
    const blob = await new Promise((resolve) => { this.canvas.toBlob(resolve, "image/png"); });
    if (!blob) throw new ClipError(say("The browser can’t write a picture of this size."));
    this.zip.add(`frame_${String(this.first + frame).padStart(5, "0")}.png`, new Uint8Array(await blob.arrayBuffer()));
  }

  async finish() { return this.zip.finish(); }
  close() {}
}
