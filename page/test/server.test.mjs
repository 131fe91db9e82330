// Saving, two tabs, a server that goes and comes back, files and examples that are opened.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
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

test("values typed or set without a server are sent when it is back", async () => {
  const page = await open(b, server);
  await panel(page, "modes");
  await page.waitForTimeout(300);
  const was = await text(page);
  await server.end();
  await write(page, "drum.mass", "2.9 kg");
  await page.waitForSelector("#status.lost");
  assert.equal(await parameter(page, "drum.mass").locator(".written").inputValue(), "2.9 kg");
  const slider = parameter(page, "bearing.stiffness").locator("input[type=range]");
  await slider.focus();
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowRight");
  const place = await slider.inputValue();
  await slider.blur();
  await write(page, "housing.mass", "-7 kg");
  await page.waitForFunction(() => /drum mass.*bearing stiffness.*housing mass/.test(document.querySelector("#status.lost")?.textContent ?? ""));
  await picture(page, "lost-values");
  assert.equal(await text(page), was);
  await page.waitForTimeout(1300);
  assert.equal(await parameter(page, "drum.mass").locator(".written").inputValue(), "2.9 kg");
  await write(page, "housing.mass", "12 kg");
  await server.again();
  await page.waitForFunction(() => { const t = editorView().state.doc.toString(); return /mass = "2.9 kg"/.test(t) && /mass = "12 kg"/.test(t); }, null, { timeout: 10_000 });
  await page.waitForTimeout(500);
  assert.equal(await slider.inputValue(), place);
  assert.equal(await parameter(page, "drum.mass").locator(".written").inputValue(), "2.9 kg");
  assert.equal(await page.locator("#status").textContent(), "");
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("a value that meets a change of the text is in the text after it", async () => {
  const page = await open(b, server);
  let hold = null;
  const held = new Promise(done => { hold = done; });
  // answers come by requests, which can be held
  await page.routeWebSocket(/\/api\/live/, ws => ws.close());
  await page.reload();
  await page.waitForSelector("#parameters .row", { state: "attached" });
  await page.route(/\/api\/answer/, async r => {
    if (r.request().postDataJSON().set && hold) { hold(); hold = null; await new Promise(d => setTimeout(d, 400)); }
    await r.continue();
  });
  await write(page, "drum.mass", "2.7 kg");
  await held;
  await page.evaluate(() => editorView().dispatch({ changes: { from: 0, insert: "# first\n" } }));
  await page.waitForFunction(() => { const t = editorView().state.doc.toString(); return t.startsWith("# first\n") && /mass = "2.7 kg"/.test(t); }, null, { timeout: 5000 });
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("a name that no file can have is refused at the field; .toml is added", async t => {
  const own = await Server.start();
  t.after(() => own.close());
  const page = await open(b, own), sent = [];
  page.on("request", r => { if (r.url().includes("/api/save")) sent.push(r.postDataJSON().file); });
  await page.click("[data-act=save-as]");
  const field = page.locator("dialog .file-name");
  for (const wrong of ["", "   ", "..", "folder/", "a\\b", "rotor.txt", ".toml"]) {
    await field.fill(wrong);
    await field.press("Enter");
    assert.equal(await field.getAttribute("aria-invalid"), "true", wrong);
    assert.match(await page.locator("dialog .wrong").textContent(), /\.toml/);
  }
  await picture(page, "save-as-wrong");
  assert.deepEqual(sent, []);
  await field.fill("rotor 2");
  await field.press("Enter");
  await page.waitForSelector("#status.notice");
  assert.deepEqual(sent, ["rotor 2.toml"]);
  assert.equal(await page.locator("#file").textContent(), "rotor 2.toml");
  // a folder that is not there: the name of before stays
  await page.click("[data-act=save-as]");
  await field.fill("nowhere/x");
  await field.press("Enter");
  await page.waitForFunction(() => /nowhere/.test(document.querySelector("#status.notice")?.textContent ?? ""));
  assert.equal(await page.locator("#file").textContent(), "rotor 2.toml");
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("a language that was chosen holds for programs that were started in the language of then", async t => {
  const russian = await Server.start("02-rigid-rotor");
  t.after(() => russian.close());
  const page = await open(b, russian), lang = () => page.evaluate(() => document.documentElement.lang);
  const ready = async () => { await page.waitForSelector("html[data-ready]"); await page.waitForSelector("#parameters .row", { state: "attached" }); };
  const leave = page.waitForEvent("load");
  await page.selectOption("#language", "kk");
  await leave;
  await ready();
  assert.equal(await lang(), "kk");
  await page.goto(russian.address);
  await ready();
  assert.equal(await lang(), "kk", "it holds for this program");
  await russian.end();
  await russian.again("--lang", "ru");
  await page.goto(russian.address);
  await ready();
  assert.equal(await lang(), "ru", "the newer wish holds");
  await page.reload();
  await ready();
  assert.equal(await lang(), "ru");
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

test("undo after another file was opened brings its name back too: no file is overwritten by another", async () => {
  const page = await open(b, server);
  await page.click("[data-act=open]");
  await page.locator('dialog [data-open="02-rigid-rotor"], dialog [data-open="rigid-rotor"]').first().click();
  await page.waitForFunction(() => document.querySelector("#file").textContent.includes("rigid"));
  const other = await text(page);
  await page.click("[data-act=undo]");
  await page.waitForFunction(other => editorView().state.doc.toString() !== other, other);
  assert.match(await page.locator("#file").textContent(), /^machine\.toml/);
  await page.click("[data-act=redo]");
  await page.waitForFunction(() => document.querySelector("#file").textContent.includes("rigid"));
  assert.equal(await text(page), other);
  await page.context().close();
});

test("a page that is loaded anew shows the file that was open", async () => {
  writeFileSync(join(server.folder, "other.toml"), disk().replace(/^name\s*=.*$/m, 'name = "the other"'));
  const page = await open(b, server);
  await page.click("[data-act=open]");
  await page.locator('dialog [data-open="other.toml"]').click();
  await page.waitForFunction(() => document.querySelector("#file").textContent.includes("other.toml"));
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  await page.waitForFunction(() => document.querySelector("#file").textContent.includes("other.toml"));
  assert.match(await text(page), /the other/);
  await page.context().close();
});
