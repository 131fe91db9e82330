// Builds the scripts of the report and the page of the studio into the folders that the program embeds.
//   node build.mjs [FOLDER]     into FOLDER instead, for a comparison

import { build } from "esbuild";
import { copyFile, mkdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const other = process.argv[2];
const report = other ? join(other, "report") : join(here, "../crates/laval/src/report/assets");
const studio = other ? join(other, "studio") : join(here, "../crates/laval-studio/assets");

const common = {
  bundle: true, minify: true, target: "es2022", charset: "utf8", legalComments: "none", logLevel: "warning", absWorkingDir: here,
};
const note = from => ({ js: `// Built from ${from}; see CONTRIBUTING.md.`, css: `/* Built from ${from}; see CONTRIBUTING.md. */` });

for (const folder of [report, studio]) await mkdir(folder, { recursive: true });
await build({
  ...common, format: "iife", banner: note("page/src/report"),
  entryPoints: ["src/report/report.ts", "src/report/animation.ts"], outdir: report,
});
await build({
  ...common, format: "esm", banner: note("page/src/studio"), external: ["./scene.js"],
  entryPoints: [
    { in: "src/studio/main.ts", out: "studio" },
    { in: "src/studio/scene.ts", out: "scene" },
    { in: "src/studio/style/studio.css", out: "studio" },
  ],
  outdir: studio,
});
await copyFile(join(here, "src/studio/index.html"), join(studio, "index.html"));
