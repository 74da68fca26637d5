// A ZIP of files that are stored as they are, for pictures, which are packed already.

const kCrcTable = Array.from({length: 256}, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; ++bit) rest = rest & 1 ? (rest >>> 1) ^ 0xedb88320 : rest >>> 1;
  return rest >>> 0;
});
const kZipDay = 0x21;         // 1980-01-01: the same files make the same ZIP.
const kMostZipFiles = 65535;  // What fits in without the format's later extension,
const kMostZipBytes = 2 ** 32 - 1;

function crc32Of(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = (crc >>> 8) ^ kCrcTable[(crc ^ byte) & 255];
  return (crc ^ 0xffffffff) >>> 0;
}

/** Returns the bytes of numbers, each [value, its bytes], the lowest byte first. */
function packed(...numbers) {
  return Uint8Array.from(numbers.flatMap(([value, size]) => Array.from({length: size}, (_, i) => Math.floor(value / 256 ** i) % 256)));
}

class StoredZip {
  constructor() {
    this.parts = [];  // Blobs, which browsers keep out of the page's memory.
    this.entries = [];
    this.size = 0;
  }

  #put(...parts) {
    for (const part of parts) {
      this.parts.push(part);
      this.size += part.size ?? part.length;
    }
  }

  /** Adds a file. Names are ASCII. */
  add(name, bytes) {
    const where = this.size, nameBytes = new TextEncoder().encode(name);
    // Version 1.0, no flags, stored.
    const common = packed([10, 2], [0, 2], [0, 2], [0, 2], [kZipDay, 2], [crc32Of(bytes), 4], [bytes.length, 4], [bytes.length, 4], [nameBytes.length, 2], [0, 2]);
    this.#put(packed([0x04034b50, 4]), common, nameBytes, new Blob([bytes]));
    this.entries.push({where, common, nameBytes});
    if (this.entries.length > kMostZipFiles || this.size > kMostZipBytes) throw new ClipError(say("The pictures are too many for a ZIP; make the motion shorter."));
  }

  /** Returns the ZIP as a blob; nothing can be added after it. */
  finish() {
    const start = this.size;
    for (const {where, common, nameBytes} of this.entries) {
      this.#put(packed([0x02014b50, 4], [10, 2]), common, packed([0, 2], [0, 2], [0, 2], [0, 4], [where, 4]), nameBytes);
    }
    const count = this.entries.length;
    this.#put(packed([0x06054b50, 4], [0, 4], [count, 2], [count, 2], [this.size - start, 4], [start, 4], [0, 2]));
    return new Blob(this.parts, {type: "application/zip"});
  }
}
