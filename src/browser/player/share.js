// A scene as text that travels: in an address, in the clipboard, in a file.

const kHash = "#play=";
const kEmbed = /^#embed(&|$)/;

/** Returns what the hash of an address in a frame, such as #embed&tour=3, is in the whole page: #tour=3. */
const hashInFrame = (hash) => hash.replace(kEmbed, (word, more) => (more ? "#" : ""));

async function throughStream(bytes, stream, limit = Infinity) {
  const writer = stream.writable.getWriter();
  // Errors reach the reader, too.
  writer.write(bytes).catch(() => {});
  writer.close().catch(() => {});
  const reader = stream.readable.getReader(), parts = [];
  let length = 0;
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    length += next.value.length;
    if (length > limit) throw new Error(say("it is longer than a scene may be"));
    parts.push(next.value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

function base64UrlOf(bytes) {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function bytesOfBase64(text) {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
}

/** Returns what the page holds packed. */
const unpacked = (text) => throughStream(bytesOfBase64(text), new DecompressionStream("gzip"));
const unpackedText = async (text) => new TextDecoder().decode(await unpacked(text));

/** Returns the address's hash that holds a scene's text. */
async function hashOf(text) {
  const packed = await throughStream(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  return kHash + base64UrlOf(packed);
}

/** Returns the scene's text, of up to `longest` bytes, in a hash; null if the hash has none. Throws if it is damaged. */
async function textOfHash(hash, longest) {
  if (!hash.startsWith(kHash)) return null;
  try {
    const bytes = await throughStream(bytesOfBase64(hash.slice(kHash.length)), new DecompressionStream("deflate-raw"), longest);
    return new TextDecoder("utf-8", {fatal: true}).decode(bytes);
  } catch (error) {
    throw new Error(say("The scene in this link can’t be read: it is damaged or cut off."), {cause: error});
  }
}

/** Returns whether the text is in the clipboard. Pages from files may have no other way than a selection. */
async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch { /* No permission, or no clipboard here. */ }
  const area = document.createElement("textarea");
  area.value = text;
  area.style.position = "fixed";
  area.style.opacity = "0";
  const focused = document.activeElement;
  document.body.append(area);
  area.select();
  const isCopied = document.execCommand("copy");
  area.remove();
  focused?.focus();
  return isCopied;
}

/** Returns what `read` promises of a file's content; throws RecordError if it can't be read. */
async function readable(name, read) {
  try {
    return await read();
  } catch {
    throw new RecordError(say("{file} can’t be read: it is a folder, or gone.", {file: name}));
  }
}

const saveText = (text, name) => saveBlob(new Blob([text], {type: "application/toml"}), name);

function saveBlob(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
