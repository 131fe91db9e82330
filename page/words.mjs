// Words of the page: each that the script or the page names is in the catalogues of all languages, and the catalogues have no other.

import { readFile, readdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url)), sources = join(here, "src/studio"), texts = join(here, "../crates/laval/text");

const read = file => readFile(file, "utf8");
const files = (await readdir(sources)).filter(f => /\.(ts|html)$/.test(f));
const all = (await Promise.all(files.map(f => read(join(sources, f))))).join("\n");

const used = new Set();
for (const pattern of [/\b(?:say|button|th|end|list)\("([a-z0-9-]+)"/g, /\bsay\((?:[^()"]*\? )"([a-z0-9-]+)" : "([a-z0-9-]+)"/g, /data-(?:say|label)="([a-z0-9-]+)"/g])
  for (const m of all.matchAll(pattern)) for (const key of m.slice(1)) if (key) used.add(key);
// names that are put together: their beginnings
const composed = [...all.matchAll(/\bsay\(`([a-z]+-)\$\{/g)].map(m => m[1]);

let wrong = 0;
const complain = text => { console.error(text); wrong++; };
for (const language of ["en", "ru", "kk", "uz"]) {
  const lines = (await read(join(texts, language, "studio.ftl"))).split("\n").filter(l => l.startsWith("studio-"));
  const known = new Map(lines.map(l => [l.slice("studio-".length, l.indexOf(" =")), l]));
  for (const key of used) if (!known.has(key)) complain(`${language}: studio-${key} is missing`);
  for (const key of known.keys()) if (!used.has(key) && !composed.some(c => key.startsWith(c))) complain(`${language}: nothing names studio-${key}`);
  for (const [key, line] of known) for (const [, name] of line.matchAll(/\{ \$(\w+) \}/g))
    if (!["name", "value", "from", "to", "count"].includes(name)) complain(`${language}: studio-${key} has a place for ${name}, which the server does not know`);
}
process.exitCode = wrong ? 1 : 0;
