// Reads the record of a clip: the text that rotatebook stores in the comment of an MP4 or a WebM.

const kBrowserRenderer = "a browser, ";  // So the renderer begins where the pictures are a browser's.

/** A clip that says nothing, or not all, of how it was made; the message is for people. */
class RecordError extends Error {}

/**
 * Returns {program, scene, motion, frames, isOfBrowser, text} of a clip's record; null once `isWanted` says no: the core reads one clip at a
 * time. Throws RecordError if it has none, or can't be read.
 */
async function readRecord(core, blob, isWanted = () => true) {
  let text = "";
  for (core.beginClip(blob.size); text === "";) {
    const offset = core.clipOffset, piece = blob.slice(offset, offset + kRecordPiece);
    const bytes = await readable(blob.name ?? say("The file"), () => piece.arrayBuffer());
    if (!isWanted()) return null;
    text = core.recordText(new Uint8Array(bytes));
  }
  return parseRecord(text);
}

function parseRecord(text) {
  const value = (name) => new RegExp("^# " + name + ": (.*)$", "m").exec(text)?.[1] ?? "";
  const origin = /^# Made by rotatebook (.*?) from the scene (.*)$/m.exec(text);
  if (!origin) throw new RecordError(say("The clip’s record is damaged: it doesn’t name its scene."));
  const motion = value("Motion");
  if (!motion) throw new RecordError(say("The clip’s record has no checksum of its motion."));
  return {program: origin[1], scene: origin[2], motion, frames: value("Frames"), isOfBrowser: value("Renderer").startsWith(kBrowserRenderer), text};
}
