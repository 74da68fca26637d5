// Reads the record of a clip: the text that rotatebook stores in the comment of an MP4 or a WebM.

/** A clip that says nothing, or not all, of how it was made; the message is for people. */
class RecordError extends Error {}

const kCutOff = "The clip is cut off: the file ends within it.";
const kNoRecord = "This clip has no record of rotatebook, so there is nothing to compare with.";
const kFirstBytes = "# Made by rotatebook ";
const kWebm = {header: 0x1a45dfa3, segment: 0x18538067, tags: 0x1254c367, tag: 0x7373, simpleTag: 0x67c8, name: 0x45a3, text: 0x4487};

/** Reads the file as far as it is needed: in pieces, so that a large clip needn't be in memory. */
class FileBytes {
  constructor(blob) {
    this.blob = blob;
  }

  get size() { return this.blob.size; }

  /** Throws where the file ends before. */
  async read(offset, length) {
    if (offset + length > this.size) throw new RecordError(kCutOff);
    return new DataView(await this.blob.slice(offset, offset + length).arrayBuffer());
  }
}

const fourLetters = (view, offset) => String.fromCharCode(...new Uint8Array(view.buffer, view.byteOffset + offset, 4));
const utf8 = (view) => new TextDecoder("utf-8", {fatal: true}).decode(view);

/** Returns the boxes of an MP4 between two offsets: {type, begin, end} of what is in each. */
async function mp4Boxes(file, begin, end) {
  const boxes = [];
  let at = begin;
  while (at + 8 <= end) {
    const head = await file.read(at, Math.min(16, end - at));
    let size = head.getUint32(0), start = at + 8;
    if (size === 1) {
      if (head.byteLength < 16) throw new RecordError(kCutOff);
      size = head.getUint32(8) * 2 ** 32 + head.getUint32(12);
      start = at + 16;
    } else if (size === 0) {
      size = end - at;
    }
    if (size < start - at) throw new RecordError("The clip is damaged: a part of it has no size.");
    if (at + size > end) throw new RecordError(kCutOff);
    boxes.push({type: fourLetters(head, 4), begin: start, end: at + size});
    at += size;
  }
  if (at !== end) throw new RecordError(kCutOff);
  return boxes;
}

async function mp4Child(file, parent, type, skipped = 0) {
  return parent && (await mp4Boxes(file, parent.begin + skipped, parent.end)).find((box) => box.type === type);
}

async function mp4Comment(file) {
  const boxes = await mp4Boxes(file, 0, file.size);
  const movie = boxes.find((box) => box.type === "moov");
  if (!movie || !boxes.some((box) => box.type === "mdat")) throw new RecordError(kCutOff);
  const meta = await mp4Child(file, await mp4Child(file, movie, "udta"), "meta");
  const list = await mp4Child(file, meta, "ilst", 4);  // After a version.
  const data = await mp4Child(file, await mp4Child(file, list, "\u00a9cmt"), "data");
  return data && utf8(await file.read(data.begin + 8, data.end - data.begin - 8));  // After type and locale.
}

/** Reads an EBML number of up to eight bytes; of a name, with its length's bits. Returns [value, length]. */
function ebmlNumber(view, offset, keepMarker) {
  const first = view.getUint8(offset), length = Math.clz32(first) - 23;
  if (length > 8 || offset + length > view.byteLength) throw new RecordError("The clip is damaged: a number in it is too long.");
  const ones = 0xff >> length;
  let value = keepMarker ? first : first & ones, isUnknown = (first & ones) === ones;
  for (let i = 1; i < length; ++i) {
    const next = view.getUint8(offset + i);
    value = value * 256 + next;
    isUnknown = isUnknown && next === 0xff;
  }
  return [isUnknown && !keepMarker ? Infinity : value, length];
}

async function* ebmlElements(file, begin, end) {
  let at = begin;
  while (at + 2 <= end) {
    const head = await file.read(at, Math.min(12, end - at));
    const [id, idLength] = ebmlNumber(head, 0, true);
    const [size, sizeLength] = ebmlNumber(head, idLength, false);
    const start = at + idLength + sizeLength;
    const stop = size === Infinity ? end : start + size;
    if (stop > end) throw new RecordError(kCutOff);
    yield {id, begin: start, end: stop};
    at = stop;
  }
}

async function ebmlText(file, element) {
  return utf8(await file.read(element.begin, element.end - element.begin));
}

/** Returns the text of a comment's tag, undefined of another. */
async function commentOf(file, tag) {
  let name = "", text;
  for await (const part of ebmlElements(file, tag.begin, tag.end)) {
    if (part.id === kWebm.name) name = await ebmlText(file, part);
    if (part.id === kWebm.text) text = await ebmlText(file, part);
  }
  return name.toUpperCase() === "COMMENT" ? text : undefined;
}

async function webmComment(file) {
  const within = async (parent, id, action) => {
    for await (const part of ebmlElements(file, parent.begin, parent.end)) {
      const found = part.id === id ? await action(part) : undefined;
      if (found !== undefined) return found;
    }
    return undefined;
  };
  return within({begin: 0, end: file.size}, kWebm.segment, (segment) =>
    within(segment, kWebm.tags, (tags) => within(tags, kWebm.tag, (tag) =>
      within(tag, kWebm.simpleTag, (simple) => commentOf(file, simple)))));
}

/** Returns {program, scene, motion, frames, text} of a clip's record; throws RecordError if it has none. */
async function readRecord(blob) {
  const file = new FileBytes(blob);
  if (file.size < 12) throw new RecordError("The file is too short to be a clip.");
  const head = await file.read(0, 12);
  const isMp4 = fourLetters(head, 4) === "ftyp";
  if (!isMp4 && head.getUint32(0) !== kWebm.header) throw new RecordError("This file is neither an MP4 nor a WebM.");
  const comment = await (isMp4 ? mp4Comment(file) : webmComment(file));
  if (comment === undefined) throw new RecordError(kNoRecord);
  return parseRecord(comment);
}

function parseRecord(text) {
  if (!text.startsWith(kFirstBytes)) throw new RecordError("This clip was made by another program: its comment isn't a record of rotatebook.");
  const value = (name) => new RegExp("^# " + name + ": (.*)$", "m").exec(text)?.[1] ?? "";
  const origin = /^# Made by rotatebook (.*?) from the scene (.*)$/m.exec(text);
  if (!origin) throw new RecordError("The clip's record is damaged: it doesn't name its scene.");
  const motion = value("Motion");
  if (!motion) throw new RecordError("The clip's record has no checksum of its motion.");
  return {program: origin[1], scene: origin[2], motion, frames: value("Frames"), text};
}
