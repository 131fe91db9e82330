// Builds the scripts of the report and the page of the studio into the folders that the program embeds.
//   node build.mjs [FOLDER]     into FOLDER instead, for a comparison

import { build } from "esbuild";
import { appendFile, copyFile, mkdir, readFile, readdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const other = process.argv[2];
const report = other ? join(other, "report") : join(here, "../crates/laval/src/report/assets");
const studio = other ? join(other, "studio") : join(here, "../crates/laval-studio/assets");

const common = {
  bundle: true, minify: true, target: "es2022", charset: "utf8", legalComments: "none", logLevel: "warning", absWorkingDir: here, metafile: true,
};
const note = from => ({ js: `// Built from ${from}; see page/README.md.`, css: `/* Built from ${from}; see page/README.md. */` });

/** Libraries in an output, with their licences. */
async function licences(inputs) {
  const names = new Set(inputs.map(i => /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(i)?.[1]).filter(Boolean));
  const texts = new Map();
  for (const name of [...names].sort()) {
    const folder = join(here, "node_modules", name), { version, license } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
    const file = (await readdir(folder)).find(f => /^licen[cs]e/i.test(f));
    if (!file) throw new Error(`${name} has no licence file`);
    const text = (await readFile(join(folder, file), "utf8")).replaceAll("*/", "* /").trim();
    texts.set(text, [...(texts.get(text) ?? []), `${name} ${version} (${license})`]);
  }
  return [...texts].map(([text, names]) => `${names.join(", ")}\n\n${text}`).join("\n\n----\n\n");
}

for (const folder of [report, studio]) await mkdir(folder, { recursive: true });
await build({
  ...common, format: "iife", banner: note("page/src/report"),
  entryPoints: ["src/report/report.ts", "src/report/animation.ts"], outdir: report,
});
const page = await build({
  ...common, format: "esm", banner: note("page/src/studio"), external: ["./scene.js"],
  entryPoints: [
    { in: "src/studio/main.ts", out: "studio" },
    { in: "src/studio/scene.ts", out: "scene" },
    { in: "src/studio/style/studio.css", out: "studio" },
  ],
  outdir: studio,
});
for (const [file, output] of Object.entries(page.metafile.outputs)) {
  const text = await licences(Object.keys(output.inputs));
  if (text) await appendFile(join(here, file), `/*!\nLibraries in this file:\n\n${text}\n*/\n`);
}
await copyFile(join(here, "src/studio/index.html"), join(studio, "index.html"));
