// Texts in the character sets that browsers know.

/** Windows-1252 from 0x80 to 0x9f, which some versions of Node take for control characters. */
const HIGH = "€\u0081‚ƒ„…†‡ˆ‰Š‹Œ\u008dŽ\u008f\u0090‘’“”•–—˜™š›œ\u009džŸ";

const decoders = new Map();

/** The decoder of a label; null if there is none. */
function decoderOf(label) {
  if (!decoders.has(label)) {
    try {
      decoders.set(label, new TextDecoder(label, { fatal: true, ignoreBOM: true }));
    } catch {
      return null;
    }
  }
  return decoders.get(label);
}

/** The text of bytes; null if there is no such character set, or they are none of its. */
export function textOf(label, bytes) {
  const decoder = decoderOf(label);
  if (decoder?.encoding === "windows-1252") {
    return Array.from(bytes, (byte) => (byte >= 0x80 && byte < 0xa0 ? HIGH[byte - 0x80] : String.fromCharCode(byte))).join("");
  }
  try {
    return decoder?.decode(bytes) ?? null;
  } catch {
    return null;
  }
}
