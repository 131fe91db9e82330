// The page in a real browser, against the real program.
//   node test/run.mjs [PATTERN]     LAVAL=program, LAVAL_PICTURES=folder keeps the pictures

import { spawnSync } from "node:child_process";
import { readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { browser, program } from "./studio.mjs";

const here = dirname(fileURLToPath(import.meta.url));
if (!browser()) { console.log("No Chromium found: the page of the studio is not tested.\n0 passed, 0 failed, 1 skipped"); process.exit(0); }
if (!program()) { console.log("The program is not built (cargo build --release): the page of the studio is not tested.\n0 passed, 0 failed, 1 skipped"); process.exit(0); }
const files = readdirSync(here).filter(f => f.endsWith(".test.mjs") && f.includes(process.argv[2] ?? "")).map(f => join(here, f));
process.exit(spawnSync(process.execPath, ["--test", "--test-concurrency=1", "--test-timeout=120000", "--test-force-exit", ...files], { stdio: "inherit" }).status ?? 1);
