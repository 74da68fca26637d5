// Writes a scene's tree as TOML.

const kBareKey = /^[A-Za-z0-9_-]+$/;

const tomlKey = (key) => (kBareKey.test(key) ? key : tomlString(key));

function tomlString(text) {
  const escapes = {"\\": "\\\\", "\"": "\\\"", "\n": "\\n", "\t": "\\t", "\r": "\\r"};
  return "\"" + text.replace(/[\\"\u0000-\u001f\u007f]/g, (letter) =>
    escapes[letter] ?? "\\u" + letter.charCodeAt(0).toString(16).padStart(4, "0")) + "\"";
}

/** Numbers in as few digits as give back the same double; TOML wants a digit on both sides of the point. */
function tomlNumber(number) {
  if (Number.isNaN(number)) return "nan";
  if (!Number.isFinite(number)) return number > 0 ? "inf" : "-inf";
  if (Object.is(number, -0)) return "-0.0";
  const text = String(number);
  // Beyond 2^53 an integer would have to be exact.
  return Number.isInteger(number) && !Number.isSafeInteger(number) && !text.includes("e") ? text + ".0" : text;
}

const isTable = (value) => value !== null && typeof value === "object" && !Array.isArray(value);
const isTableList = (value) => Array.isArray(value) && value.length > 0 && value.every(isTable);

function tomlValue(value) {
  if (typeof value === "string") return tomlString(value);
  if (typeof value === "number") return tomlNumber(value);
  if (typeof value === "boolean") return String(value);
  if (Array.isArray(value)) return "[" + value.map(tomlValue).join(", ") + "]";
  return "{ " + Object.entries(value).map(([key, inner]) => tomlKey(key) + " = " + tomlValue(inner)).join(", ") + " }";
}

/** Tables stand under a head of their own at the top, on dotted lines in a panel, and inline elsewhere. */
function tomlTable(tree, place, lines) {
  const hasHead = ([, value]) => place === "" && (isTable(value) || isTableList(value));
  for (const [key, value] of Object.entries(tree).filter((entry) => !hasHead(entry))) {
    if (isTable(value) && place === "panel") {
      for (const [inner, innerValue] of Object.entries(value)) lines.push(`${tomlKey(key)}.${tomlKey(inner)} = ${tomlValue(innerValue)}`);
    } else {
      lines.push(`${tomlKey(key)} = ${tomlValue(value)}`);
    }
  }
  for (const [key, value] of Object.entries(tree).filter(hasHead)) {
    for (const table of [value].flat()) {
      lines.push("", Array.isArray(value) ? `[[${tomlKey(key)}]]` : `[${tomlKey(key)}]`);
      tomlTable(table, key, lines);
    }
  }
}

/** Returns the text of a scene: reading it gives the same tree. */
function tomlText(tree) {
  const lines = [];
  tomlTable(tree, "", lines);
  return lines.join("\n").trimStart() + "\n";
}
