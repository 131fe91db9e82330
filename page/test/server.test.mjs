// Saving, two tabs, a server that goes and comes back, files and examples that are opened.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Server, changed, launch, open, panel, parameter, picture, pull, text, write } from "./studio.mjs";

let b, server;
before(async () => { b = await launch(); server = await Server.start(); });
after(async () => { await b.close(); await server.close(); });
const disk = () => readFileSync(join(server.folder, "machine.toml"), "utf8");

test("two tabs: the second does not overwrite silently what the first saved", async () => {
  const one = await open(b, server), two = await open(b, server), was = await text(one);
  await write(one, "drum.mass", "3 kg");
  await changed(one, was);
  await one.click("[data-act=save]");
  await one.waitForSelector("#status.notice");
  assert.equal(disk(), await text(one));
  await write(two, "drum.mass", "5 kg");
  await changed(two, was);
  await two.click("[data-act=save]");
  await two.waitForSelector("dialog[open]");
  await picture(two, "conflict");
  assert.match(disk(), /mass = "3 kg"/);
  await two.locator("dialog button", { hasText: "Load from disk" }).click();
  await two.waitForFunction(() => document.querySelector('.row[data-path="drum.mass"] .written')?.value === "3 kg");
  await write(two, "drum.mass", "6 kg");
  await two.waitForFunction(() => document.querySelector("#file").textContent.includes("•"));
  await two.keyboard.press("Control+s");
  await two.waitForFunction(() => !document.querySelector("#file").textContent.includes("•"));
  assert.match(disk(), /mass = "6 kg"/);
  assert.deepEqual([...one.complaints, ...two.complaints], []);
  await one.context().close();
  await two.context().close();
});

test("a server that goes is reported; the text stays; when it is back the figures follow again", async () => {
  const page = await open(b, server);
  await panel(page, "modes");
  await server.end();
  await page.locator("#editor .cm-content").click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("# written without a server\n");
  await page.waitForSelector("#status.lost");
  await picture(page, "lost");
  await server.again();
  await page.waitForFunction(() => !document.querySelector("#status.lost"), null, { timeout: 10_000 });
  assert.match(await text(page), /^# written without a server/);
  await write(page, "drum.mass", "2 kg");
  await page.waitForFunction(() => document.querySelector('.row[data-path="drum.mass"] .written')?.value === "2 kg" && /mass = "2 kg"/.test(editorView().state.doc.toString()));
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("examples are opened, each is shown without a complaint", async () => {
  const page = await open(b, server);
  await page.click("[data-act=open]");
  const names = await page.locator("dialog [data-open]").evaluateAll(all => all.map(e => e.dataset.open));
  assert.ok(names.length >= 9, `${names}`);
  await picture(page, "open");
  await page.keyboard.press("Escape");
  for (const name of names) {
    const was = await text(page);
    await page.click("[data-act=open]");
    await page.locator(`dialog [data-open="${name}"]`).last().click();
    if (name !== "machine.toml") await changed(page, was);
    await page.waitForFunction(() => document.querySelectorAll("#parameters .row").length > 0 && !document.querySelector("#status.wrong"));
    await page.waitForFunction(() => document.querySelector("#section svg"));
    await picture(page, `example-${name.replace(/\W+/g, "-")}`);
  }
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("a bearing and a disc are dragged along their shaft", async () => {
  const rotor = await Server.start("08-three-disc-rotor");
  const page = await open(b, rotor), was = await text(page), handles = page.locator('.handle[data-axis="x"]');
  await handles.first().waitFor();
  const paths = await handles.evaluateAll(all => all.map(e => e.dataset.path));
  assert.ok(paths.length >= 5, `${paths}`);
  for (const path of [paths.find(p => /disc/.test(p)), paths.find(p => /bearing/.test(p))]) {
    const before = await text(page);
    await pull(page, page.locator(`.handle[data-path="${path}"] .hit`), 12, 0);
    await changed(page, before);
    await page.waitForFunction(() => !document.querySelector(".handle.active"));
    assert.match(await text(page), /at = "[\d.]+ m"/);
  }
  await page.waitForTimeout(300);
  await picture(page, "moved");
  await page.click("[data-act=undo]");
  await page.click("[data-act=undo]");
  assert.equal(await text(page), was);
  assert.ok(await page.locator("[data-act=undo]").isDisabled());
  assert.deepEqual(page.complaints, []);
  await page.context().close();
  await rotor.close();
});

test("the page asks nothing of any other server", async () => {
  const page = await b.newPage(), seen = [];
  page.on("request", r => { if (!r.url().startsWith(server.address) && !/^(data|blob):/.test(r.url())) seen.push(r.url()); });
  await page.goto(server.address);
  await page.waitForSelector("#parameters .row");
  await page.click("#tab-space");
  await page.waitForTimeout(500);
  assert.deepEqual(seen, []);
  await page.close();
});
