// Load, edit, drag, undo, an error in the file.

import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { Server, changed, launch, open, panel, parameter, picture, pull, text, write } from "./studio.mjs";

let b, server, page;
before(async () => { b = await launch(); server = await Server.start(); });
after(async () => { await b.close(); await server.close(); });
beforeEach(async () => { page = await open(b, server); });
afterEach(async () => { assert.deepEqual(page.complaints, []); await page.context().close(); });

const undo = () => page.click("[data-act=undo]");
const shows = (path, value) => page.waitForFunction(([path, value]) => document.querySelector(`.row[data-path="${path}"] .written`)?.value === value, [path, value]);

test("the machine is shown: text, section, parameters, first page, all figures", async () => {
  assert.match(await text(page), /name\s+= "oil separator"/);
  assert.ok(await page.locator("#section svg .solid").count() > 0);
  assert.equal(await parameter(page, "drum.mass").locator(".written").inputValue(), "2.4 kg");
  for (const want of ["page", "modes", "campbell", "stability", "forced", "nonlinear"]) await panel(page, want);
  assert.match(await page.locator("#panel-page .verdict .v").textContent(), /3000/);
  assert.equal(await page.locator("#panel-modes .mode").count(), 6);
  assert.ok(await page.locator("#panel-nonlinear figure.fig").count() >= 1);
  await picture(page, "first");
});

test("a number with unit changes the text at its place, with its comment, as one step", async () => {
  const was = await text(page);
  await write(page, "drum.mass", "3 kg");
  await page.waitForFunction(() => /^mass = "3 kg"/m.test(editorView().state.doc.toString()));
  const now = await text(page);
  assert.equal(now, was.replace('mass = "2.4 kg"', 'mass = "3 kg"'));
  await undo();
  assert.equal(await text(page), was);
});

test("typing in the editor changes machine and figures", async () => {
  await panel(page, "modes");
  const first = () => page.locator("#panel-modes .modes").innerHTML();
  const was = await first();
  await page.locator("#editor .cm-content").click();
  await page.keyboard.press("Control+f");
  await page.keyboard.type('mass = "2.4 kg"');
  await page.keyboard.press("Enter");
  await page.keyboard.press("Escape");
  await page.keyboard.type('mass = "4.8 kg"');
  await shows("drum.mass", "4.8 kg");
  await page.waitForFunction(was => document.querySelector("#panel-modes .modes").innerHTML !== was, was);
});

test("a drag of the free surface is one step of undo, and figures follow it", async () => {
  await panel(page, "modes");
  const was = await text(page), handle = page.locator('.handle[data-path="oil.free_surface_radius"] .hit');
  let drawn = 0;
  await page.exposeFunction("drawn", () => { drawn++; });
  await page.evaluate(() => new MutationObserver(() => window.drawn()).observe(document.querySelector("#panel-modes .body"), { childList: true, subtree: true, characterData: true, attributes: true, attributeFilter: ["d", "cx", "cy"] }));
  await pull(page, handle, 25, 0, 30);
  await page.waitForFunction(() => !document.querySelector("[data-act=undo]").disabled);
  await changed(page, was);
  const now = await text(page);
  assert.match(now, /free_surface_radius = "[\d.]+ mm"/);
  assert.equal(now.replace(/(free_surface_radius = )"[\d.]+ mm"/, '$1"46.7 mm"'), was);
  assert.ok(drawn >= 3, `the modes were drawn ${drawn} times during the drag`);
  await picture(page, "dragged");
  await undo();
  assert.equal(await text(page), was);
  assert.ok(await page.locator("[data-act=undo]").isDisabled());
});

test("a slider is one step of undo; Escape gives a drag up", async () => {
  const was = await text(page), slider = parameter(page, "bearing.stiffness").locator("input[type=range]");
  await slider.focus();
  for (let i = 0; i < 8; i++) await page.keyboard.press("ArrowRight");
  await slider.blur();
  await changed(page, was);
  await page.waitForTimeout(300);
  await undo();
  await page.waitForTimeout(100);
  const handle = page.locator('.handle[data-path="oil.free_surface_radius"] .hit');
  const box = await handle.boundingBox();
  await page.mouse.move(box.x + 4, box.y + 4);
  await page.mouse.down();
  await page.mouse.move(box.x + 30, box.y + 4, { steps: 6 });
  await page.waitForTimeout(200);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await page.waitForTimeout(200);
  while (await page.locator("[data-act=undo]").isEnabled()) await undo();
  assert.equal(await text(page), was);
});

test("keys move a handle", async () => {
  const was = await text(page);
  await page.locator('.handle[data-path="oil.free_surface_radius"]').focus();
  const radius = async () => +/free_surface_radius = "([\d.]+) mm"/.exec(await text(page))[1];
  const from = await radius();
  await page.keyboard.press("ArrowRight");
  await changed(page, was);
  await page.waitForTimeout(400);
  const step = await radius() - from;
  // quick presses add up
  for (let i = 0; i < 4; i++) await page.keyboard.press("ArrowRight");
  await page.waitForTimeout(700);
  assert.ok(Math.abs(await radius() - from - 5 * step) < 0.1 * step, `${from} ${step} ${await radius()}`);
});

test("an error stands at its place; figures of the last machine stay; the mend clears it", async () => {
  await panel(page, "modes");
  await page.locator("#editor .cm-content").click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("[[part]]\nkind = \"disk\"\n\n");
  await page.waitForSelector("#status.wrong");
  await page.waitForSelector("#editor .cm-lintRange-error");
  await page.waitForSelector("#panel-modes.stale");
  assert.equal(await page.locator("#panel-modes .mode").count(), 6);
  await picture(page, "error");
  await page.click("#status .link");
  const at = await page.evaluate(() => editorView().state.selection.main.head);
  assert.ok(at < 40, `the cursor went to ${at}`);
  await page.keyboard.press("Control+z");
  while (await page.locator("#status.wrong").count() && await page.locator("[data-act=undo]").isEnabled()) { await undo(); await page.waitForTimeout(150); }
  assert.equal(await page.locator("#status.wrong").count(), 0);
  await page.waitForSelector("#panel-modes:not(.stale)");
});

test("a refused value stays at its field with the reason until it is mended", async () => {
  const field = parameter(page, "drum.mass").locator(".written"), invalid = () => field.getAttribute("aria-invalid");
  await write(page, "drum.mass", "3 mm");
  await page.waitForSelector("#status.notice");
  await page.waitForFunction(() => document.querySelector('.row[data-path="drum.mass"] .written').getAttribute("aria-invalid") === "true");
  assert.match(await field.getAttribute("title"), /mass/);
  await picture(page, "refused");
  // a change of another number does not hide it
  await write(page, "housing.mass", "12 kg");
  await shows("housing.mass", "12 kg");
  await page.waitForTimeout(200);
  assert.deepEqual([await field.inputValue(), await invalid()], ["3 mm", "true"]);
  assert.equal(await page.locator("#status.notice").count(), 0);
  await write(page, "drum.mass", "3 kg");
  await page.waitForFunction(() => /mass = "3 kg"/.test(editorView().state.doc.toString()));
  assert.deepEqual([await field.inputValue(), await invalid(), await field.getAttribute("title")], ["3 kg", null, null]);
  // the file mends it too
  await write(page, "drum.mass", "4 mm");
  await page.waitForFunction(() => document.querySelector('.row[data-path="drum.mass"] .written').getAttribute("aria-invalid") === "true");
  await undo();
  await shows("drum.mass", "2.4 kg");
  assert.equal(await invalid(), null);
});

test("completion offers kinds and keys with their documentation", async () => {
  await page.locator("#editor .cm-content").click();
  await page.keyboard.press("Control+End");
  await page.keyboard.type('\n\n[[part]]\nkind = "dam');
  await page.waitForSelector(".cm-tooltip-autocomplete");
  assert.match(await page.locator(".cm-tooltip-autocomplete").textContent(), /damper/);
  // a list that has just opened takes no key
  await page.waitForTimeout(150);
  await page.keyboard.press("Enter");
  await page.keyboard.press("End");
  await page.keyboard.type("\ndampi");
  await page.waitForSelector(".cm-tooltip-autocomplete");
  assert.match(await page.locator(".cm-tooltip-autocomplete").textContent(), /damping/);
  await picture(page, "completion");
  await page.keyboard.press("Escape");
  for (let i = 0; i < 5; i++) await page.keyboard.press("Backspace");
  await page.keyboard.type("[[cu");
  await page.waitForSelector(".cm-tooltip-autocomplete");
  assert.match(await page.locator(".cm-tooltip-autocomplete").textContent(), /\[\[cup\]\]/);
  await page.waitForTimeout(150);
  await page.keyboard.press("Enter");
  assert.match(await text(page), /\n\[\[cup\]\]$/);
});

test("a number alone has the unit that its field shows", async () => {
  const was = await text(page);
  await write(page, "drum.eccentricity", "90");
  await changed(page, was);
  assert.match(await text(page), /^eccentricity = "90 [µu]m"/m);
  await write(page, "machine.speed", "2900").catch(() => write(page, "speed", "2900"));
  await page.waitForFunction(() => /^speed = "2900 rpm"/m.test(editorView().state.doc.toString()));
});

test("undo in the middle of a drag takes back that drag alone", async () => {
  const was = await text(page);
  await write(page, "drum.mass", "3 kg");
  await changed(page, was);
  const before = await text(page), handle = page.locator('.handle[data-path="oil.free_surface_radius"] .hit');
  await handle.scrollIntoViewIfNeeded();
  const box = await handle.boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y, { steps: 8 });
  await changed(page, before);
  await page.keyboard.press("Control+z");
  await page.waitForFunction(before => editorView().state.doc.toString() === before, before);
  await page.mouse.move(x + 30, y, { steps: 6 });
  await changed(page, before);
  await page.mouse.up();
  await page.waitForTimeout(300);
  await undo();
  assert.equal(await text(page), before);
  await undo();
  assert.equal(await text(page), was);
});

test("what belongs to another text is dimmed until its figure is there", async () => {
  await panel(page, "campbell");
  await page.waitForTimeout(500);
  // nothing is asked for any more
  await page.evaluate(() => { WebSocket.prototype.send = () => {}; });
  await page.evaluate(() => editorView().dispatch({ changes: { from: 0, insert: "# another text\n" } }));
  await page.waitForSelector("#panel-campbell.late", { state: "attached" });
  await page.waitForFunction(() => getComputedStyle(document.querySelector("#panel-campbell .body")).opacity < 0.6);
});
