// Files that the page does not take, and what to run instead.

/** The largest file that is taken, in bytes. */
export const LIMIT = 300 * 2 ** 20;

const MIB = 2 ** 20;

const begins = (bytes, text) => bytes && [...text].every((letter, i) => bytes[i] === letter.charCodeAt(0));

const run = (name) => ({ code: `twinedge audit ${name} -o report.html\ntwinedge clean ${name} -o clean.gpkg` });

const quoted = (name) => (name.includes(" ") ? `"${name}"` : name);

/** The command for what only the program reads, if an error is about that: a database in an archive, a map without end. */
export const commandFor = ({ code }, file) => (["too-large", "needs-program"].includes(code) ? run(quoted(file.name)).code : null);

/** The parts of a message, if these files are refused. */
export function refusal(files) {
  const main = files[0];
  const size = files.reduce((sum, file) => sum + (file.size ?? file.bytes.length), 0);
  const name = quoted(main.name);
  if (size > LIMIT || files.some(({ bytes }) => bytes === null)) {
    return [{ text: `${main.name} has ${Math.round(size / MIB)} MB. A browser holds maps of up to ${LIMIT / MIB} MB; the program takes any. Run this instead:` }, run(name)];
  }
  if (begins(main.bytes, "SQLite format 3")) {
    return [{ text: `${main.name} is a GeoPackage: a database of SQLite, which would be larger than all of this page. Run this instead:` }, run(name)];
  }
  if (begins(main.bytes, "PAR1")) {
    return [{ text: `${main.name} is GeoParquet, whose methods of compression would be larger than all of this page. Run this instead:` }, run(name)];
  }
  return null;
}
