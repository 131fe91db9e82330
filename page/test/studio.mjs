// Starts the program and a browser; what the tests do on the page.

import { spawn } from "node:child_process";
import { accessSync, constants, cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { delimiter, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

export const root = join(dirname(fileURLToPath(import.meta.url)), "../..");

const runs = file => { try { accessSync(file, constants.X_OK); return true; } catch { return false; } };

export function browser() {
  const names = ["chromium", "chromium-browser", "google-chrome"];
  return (process.env.PATH ?? "").split(delimiter).flatMap(p => names.map(n => join(p, n))).find(runs) ?? null;
}

export function program() {
  const file = process.env.LAVAL ?? join(root, "target/release/laval");
  return runs(file) ? file : null;
}

const freePort = () => new Promise((done, fail) => {
  const s = createServer();
  s.on("error", fail);
  s.listen(0, "127.0.0.1", () => { const { port } = s.address(); s.close(() => done(port)); });
});

/** A server in a folder of its own that holds an example as `machine.toml`. */
export class Server {
  static async start(example = "01-oil-separator", port = 0) {
    const s = new Server();
    s.folder = mkdtempSync(join(tmpdir(), "laval-studio-"));
    cpSync(join(root, "examples", example, "machine.toml"), join(s.folder, "machine.toml"));
    s.port = port || await freePort();
    s.token = "0123456789abcdef0123456789abcdef";
    await s.again();
    return s;
  }

  /** Starts it at the same place as before. */
  async again(...more) {
    const child = spawn(program(), ["studio", "--port", String(this.port), "--token", this.token, "--no-open", ...more, "machine.toml"], { cwd: this.folder, stdio: ["ignore", "pipe", "pipe"] });
    this.child = child;
    let heard = "", errors = "";
    child.stderr.on("data", d => { errors += d; });
    this.address = await new Promise((done, fail) => {
      child.stdout.on("data", d => { heard += d; const m = /http:\/\/\S+/.exec(heard); if (m) done(m[0]); });
      child.on("exit", code => fail(new Error(`the program ended with ${code}: ${errors}`)));
    });
  }

  end() {
    return new Promise(done => { this.child.once("exit", done); this.child.kill("SIGTERM"); });
  }

  async close() {
    await this.end();
    rmSync(this.folder, { recursive: true, force: true });
  }
}

const ARGS = ["--no-sandbox", "--enable-unsafe-swiftshader", "--disable-background-networking", "--disable-component-update"];

export const launch = (...more) => chromium.launch({ executablePath: browser(), args: [...ARGS, ...more] });

/** Words of the page as the catalogue of a language has them. */
function words(language) {
  const lines = readFileSync(join(root, "crates/laval/text", language, "studio.ftl"), "utf8").split("\n");
  return Object.fromEntries(lines.filter(l => l.startsWith("studio-")).map(l => [l.slice(0, l.indexOf(" =")), l.slice(l.indexOf("=") + 2).replace(/\{ \$(\w+) \}/g, "{$1}")]));
}

/** The page of a new build in place of the one that the program has. */
export async function route(page) {
  await page.route(/\/assets\/[\w.]+$|\/[0-9a-f]{32}\/(\?.*)?$/, (r, request) => {
    const name = /assets\/([\w.]+)$/.exec(request.url())?.[1] ?? "index.html";
    return r.fulfill({ path: join(process.env.LAVAL_ASSETS, name), contentType: { html: "text/html", css: "text/css", js: "text/javascript" }[name.split(".").pop()] });
  });
  // words of the sources go with the page of the sources
  await page.route(/\/api\/start(\?.*)?$/, async r => {
    const response = await r.fetch().catch(() => null);
    if (!response) return r.abort();
    const start = await response.json();
    return r.fulfill({ response, json: { ...start, words: { ...words(start.language), ...start.words } } });
  });
}

/** A page with the machine shown; what it complains about is collected. */
export async function open(b, server, { width = 1440, height = 900, query = "", ...rest } = {}) {
  const context = await b.newContext({ viewport: { width, height }, acceptDownloads: true, ...rest });
  const page = await context.newPage();
  page.complaints = [];
  page.on("pageerror", e => page.complaints.push(e.stack ?? String(e)));
  page.on("console", m => {
    // a request that is abandoned, a server that is away and software rendering are no defects of the page
    if (m.type() === "error" && !/Failed to load resource|ERR_/.test(m.text())) page.complaints.push(m.text());
  });
  if (process.env.LAVAL_ASSETS) await route(page);
  // the editor hangs on its element
  await page.addInitScript(() => { window.editorView = () => document.querySelector("#editor").shadowRoot.querySelector(".cm-content").cmTile.view; });
  await page.goto(server.address + query);
  await page.waitForSelector("html[data-ready]");
  await page.waitForSelector("#parameters .row", { state: "attached" });
  return page;
}

/** The whole text of the editor. */
export const text = page => page.evaluate(() => editorView().state.doc.toString());

/** Waits until the text is another one. */
export const changed = (page, was) => page.waitForFunction(was => editorView().state.doc.toString() !== was, was);

export const settled = (page, want) => page.waitForSelector(`#panel-${want}:not(.stale) .body > *`, { state: "attached" });

/** Scrolls to the panel of a figure and waits until it is drawn. */
export async function panel(page, want) {
  const p = page.locator(`#panel-${want}`);
  await p.scrollIntoViewIfNeeded();
  await settled(page, want);
  return p;
}

export const parameter = (page, path) => page.locator(`.row[data-path="${path}"]`);

/** Writes a value into the field of a parameter. */
export async function write(page, path, value) {
  const field = parameter(page, path).locator(".written");
  await field.fill(value);
  await field.press("Enter");
  await field.blur();
}

/** Pulls what is drawn by some pixels. */
export async function pull(page, handle, dx, dy, steps = 12) {
  // it may be drawn anew meanwhile
  await handle.scrollIntoViewIfNeeded().catch(() => handle.scrollIntoViewIfNeeded());
  const box = await handle.boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, { steps });
  await page.mouse.up();
}

export async function picture(page, name) {
  const folder = process.env.LAVAL_PICTURES;
  if (!folder) return;
  if (!existsSync(folder)) mkdirSync(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`) });
}
