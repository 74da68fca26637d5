// Reads the record of a clip: the text that rotatebook stores in the comment of an MP4 or a WebM.

/** A clip that says nothing, or not all, of how it was made; the message is for people. */
class RecordError extends Error {}

const kCutOff = "The clip is cut off: the file ends within it.";
const kNoRecord = "This clip has no record of rotatebook, so there is nothing to compare with.";
const kOtherProgram = "This clip was made by another program: its comment isn’t a record of rotatebook.";
const kFirstBytes = "# Made by rotatebook ";
const kLargestRecord = 32 * 1024;  // [bytes]
const kMaxParts = 10000;  // Clips have a few hundred.
const kPiece = 65536;     // [bytes]
const kWebm = {header: 0x1a45dfa3, segment: 0x18538067, tags: 0x1254c367, tag: 0x7373, simpleTag: 0x67c8, name: 0x45a3,
  text: 0x4487};

const kTwoRecords = "it is there twice.";

const damaged = (problem) => new RecordError("The clip’s record is damaged: " + problem);

/** Reads the file as far as it is needed: in pieces, so that a large clip needn't be in memory. */
class FileBytes {
  constructor(blob) {
    this.blob = blob;
    this.parts = 0;
    this.begin = 0;  // Of the piece read last.
    this.piece = new ArrayBuffer(0);
  }

  get size() { return this.blob.size; }

  /** Throws where the file ends before, and if it can't be read. */
  async read(offset, length) {
    if (offset + length > this.size) throw new RecordError(kCutOff);
    if (offset < this.begin || offset + length > this.begin + this.piece.byteLength) {
      const piece = this.blob.slice(offset, offset + Math.max(length, kPiece));
      this.piece = await readable(this.blob.name ?? "The file", () => piece.arrayBuffer());
      this.begin = offset;
    }
    return new DataView(this.piece, offset - this.begin, length);
  }

  /** Counts a part; throws after so many that looking on would take too long. */
  notePart() {
    if (++this.parts <= kMaxParts) return;
    throw new RecordError(`The clip’s record can’t be reached: the file has more than ${kMaxParts} parts.`);
  }
}

const latin1 = (view) => new TextDecoder("latin1").decode(view);
const fourLetters = (view, offset) => String.fromCharCode(...new Uint8Array(view.buffer, view.byteOffset + offset, 4));

/** Returns the text of a record between two offsets of the file. */
async function recordText(file, begin, end) {
  const length = end - begin, first = await file.read(begin, Math.max(Math.min(length, kFirstBytes.length), 0));
  if (latin1(first) !== kFirstBytes) throw new RecordError(kOtherProgram);
  if (length > kLargestRecord) throw damaged("it is longer than 32 KiB, the limit for a scene.");
  const bytes = await file.read(begin, length);
  try {
    return new TextDecoder("utf-8", {fatal: true}).decode(bytes);
  } catch {
    throw damaged("it isn’t UTF-8.");
  }
}

/** Returns the boxes of an MP4 between two offsets: {type, begin, end} of what is in each. */
async function mp4Boxes(file, begin, end) {
  const boxes = [];
  let at = begin;
  while (at + 8 <= end) {
    file.notePart();
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

/** Returns the only box of that type; throws if there are two, as players differ in which they take. */
function onlyBox(boxes, type) {
  const found = boxes.filter((box) => box.type === type);
  if (found.length > 1) throw damaged(kTwoRecords);
  return found[0];
}

async function mp4Child(file, parent, type, skipped = 0) {
  return parent && onlyBox(await mp4Boxes(file, parent.begin + skipped, parent.end), type);
}

async function mp4Comment(file) {
  const boxes = await mp4Boxes(file, 0, file.size), movie = onlyBox(boxes, "moov");
  if (!movie || !boxes.some((box) => box.type === "mdat")) throw new RecordError(kCutOff);
  const meta = await mp4Child(file, await mp4Child(file, movie, "udta"), "meta");
  const list = await mp4Child(file, meta, "ilst", 4);  // After a version.
  const data = await mp4Child(file, await mp4Child(file, list, "\u00a9cmt"), "data");
  return data && recordText(file, data.begin + 8, data.end);  // After type and locale.
}

/** Reads an EBML number of up to eight bytes; of a name, with its length's bits. Returns [value, length]. */
function ebmlNumber(view, offset, keepMarker) {
  if (offset >= view.byteLength) throw new RecordError(kCutOff);
  const first = view.getUint8(offset), length = Math.clz32(first) - 23;
  if (length > 8) throw new RecordError("The clip is damaged: a number in it is too long.");
  if (offset + length > view.byteLength) throw new RecordError(kCutOff);
  const ones = 0xff >> length;
  let value = keepMarker ? first : first & ones, isUnknown = (first & ones) === ones;
  for (let i = 1; i < length; ++i) {
    const next = view.getUint8(offset + i);
    value = value * 256 + next;
    isUnknown = isUnknown && next === 0xff;
  }
  return [isUnknown && !keepMarker ? Infinity : value, length];
}

/**
 * Yields the elements between two offsets. What is in one of unknown size, as the clusters of a live clip are, comes after it as
 * if beside it: it ends where an element comes that can't be in it.
 */
async function* ebmlElements(file, begin, end) {
  let at = begin;
  while (at < end) {
    file.notePart();
    const head = await file.read(at, Math.min(12, end - at));
    const [id, idLength] = ebmlNumber(head, 0, true);
    const [size, sizeLength] = ebmlNumber(head, idLength, false);
    const start = at + idLength + sizeLength;
    const stop = size === Infinity ? end : start + size;
    if (stop > end) throw new RecordError(kCutOff);
    yield {id, begin: start, end: stop};
    at = size === Infinity ? start : stop;
  }
}

/** Returns the text's element in a comment's tag, undefined of another tag. */
async function commentOf(file, tag) {
  const kName = "COMMENT";
  let name = "", text;
  for await (const part of ebmlElements(file, tag.begin, tag.end)) {
    const length = part.end - part.begin;
    if (part.id === kWebm.name && length === kName.length) name = latin1(await file.read(part.begin, length));
    if (part.id === kWebm.text && text) throw damaged(kTwoRecords);
    if (part.id === kWebm.text) text = part;
  }
  return name.toUpperCase() === kName ? text : undefined;
}

/** Returns the record of the only comment; throws if there are two, as players differ in which they take. */
async function webmComment(file) {
  const within = async (parent, id, action) => {
    for await (const part of ebmlElements(file, parent.begin, parent.end)) {
      if (part.id === id) await action(part);
    }
  };
  const found = [];
  await within({begin: 0, end: file.size}, kWebm.segment, (segment) =>
    within(segment, kWebm.tags, (tags) => within(tags, kWebm.tag, (tag) =>
      within(tag, kWebm.simpleTag, async (simple) => found.push(await commentOf(file, simple))))));
  const texts = found.filter((text) => text);
  if (texts.length > 1) throw damaged(kTwoRecords);
  return texts.length === 1 ? recordText(file, texts[0].begin, texts[0].end) : undefined;
}

/** Returns {program, scene, motion, frames, text} of a clip's record; throws RecordError if it has none, or can't be read. */
async function readRecord(blob) {
  const file = new FileBytes(blob);
  const head = await file.read(0, Math.min(12, file.size));
  if (head.byteLength < 12) throw new RecordError("The file is too short to be a clip.");
  const isMp4 = fourLetters(head, 4) === "ftyp";
  if (!isMp4 && head.getUint32(0) !== kWebm.header) throw new RecordError("This file is neither an MP4 nor a WebM.");
  const comment = await (isMp4 ? mp4Comment(file) : webmComment(file));
  if (comment === undefined) throw new RecordError(kNoRecord);
  return parseRecord(comment);
}

function parseRecord(text) {
  const value = (name) => new RegExp("^# " + name + ": (.*)$", "m").exec(text)?.[1] ?? "";
  const origin = /^# Made by rotatebook (.*?) from the scene (.*)$/m.exec(text);
  if (!origin) throw damaged("it doesn’t name its scene.");
  const motion = value("Motion");
  if (!motion) throw new RecordError("The clip’s record has no checksum of its motion.");
  return {program: origin[1], scene: origin[2], motion, frames: value("Frames"), text};
}
