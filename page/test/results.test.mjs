// Handles of results: each can be grasped, by pointer and by keyboard; values with units; messages that end with their text; zoomed figures.

import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { Server, changed, launch, open, panel, parameter, picture, pull, text, write } from "./studio.mjs";

let b, server, page;
before(async () => { b = await launch(); server = await Server.start(); });
after(async () => { await b.close(); await server.close(); });
beforeEach(async () => { page = await open(b, server); });
afterEach(async () => { assert.deepEqual(page.complaints, []); await page.context().close(); });

const release = path => parameter(page, path).locator(".release input").check();
const undo = () => page.click("[data-act=undo]");
const handles = want => page.locator(`#panel-${want} svg:visible .target`);
const shown = want => page.evaluate(want => [...document.querySelectorAll(`#panel-${want} .target`)].filter(e => e.getClientRects().length).map(e => e.getAttribute("aria-valuetext")), want);
const inFocus = () => page.evaluate(() => document.activeElement?.getAttribute("data-target") ?? null);

/** Targets whose middle is not their own: another lies on them. */
const covered = (page, want) => page.evaluate(want => {
  const seen = [...document.querySelectorAll(`#panel-${want} .target`)].filter(e => e.getClientRects().length);
  return seen.filter(g => {
    const r = g.querySelector(".hit").getBoundingClientRect(), scroll = document.querySelector("#results").getBoundingClientRect();
    const x = r.x + r.width / 2, y = r.y + r.height / 2;
    if (y < scroll.top || y > scroll.bottom) return false;
    const knobs = seen.filter(o => o !== g).map(o => o.querySelector(".hit").getBoundingClientRect());
    const near = knobs.some(o => Math.hypot(o.x + o.width / 2 - x, o.y + o.height / 2 - y) < 22);
    return near || document.elementFromPoint(x, y)?.closest(".target") !== g;
  }).map(g => g.dataset.target);
}, want);

test("no handle of a result lies on another, at any width", async () => {
  for (const example of ["01-oil-separator", "02-rigid-rotor", "05-oil-desludging", "09-cream-separator"]) {
    const other = await Server.start(example);
    for (const [width, height] of [[1440, 900], [390, 844]]) {
      const p = await open(b, other, { width, height });
      if (width < 900) await p.click("#panes-tabs [data-tab=figures]");
      for (const want of ["campbell", "stability", "forced", "nonlinear"]) {
        await p.locator(`#panel-${want}`).evaluate(e => e.scrollIntoView());
        await p.waitForSelector(`#panel-${want} .body > *`, { state: "attached" });
        await p.waitForTimeout(100);
        assert.deepEqual(await covered(p, want), [], `${example} ${want} ${width}`);
        await picture(p, `handles-${example.slice(0, 2)}-${want}-${width}`);
      }
      assert.deepEqual(p.complaints, []);
      await p.context().close();
    }
    await other.close();
  }
});

test("the speed of a peak is pulled, not its size; where nothing is free the figure is not zoomed", async () => {
  const p = await panel(page, "forced"), speed = p.locator("svg:visible .target.x .hit").last();
  // its name is seen, and no readout of a curve lies on it
  await speed.hover();
  assert.match(await p.locator("svg:visible .target:hover .value").textContent(), /housing.*rpm/);
  assert.equal(await p.locator(".tip").first().isVisible(), false);
  await pull(page, speed, -30, 0);
  assert.match(await page.locator("#status").textContent(), /free/);
  assert.equal(await p.locator("figure.fig button").first().isVisible(), false);
  await release("drum.mass");
  assert.equal(await page.locator("#status").textContent(), "", "the hint is followed");
  await panel(page, "forced");
  const asked = page.waitForRequest(r => r.url().includes("/api/reach"));
  await pull(page, speed, -6, 0);
  assert.equal((await asked).postDataJSON().target.which.size, undefined);
  await page.waitForSelector("#reach .ok, #reach .bad, #status.notice");
});

test("keys: the handle keeps the focus, steps are those of the range shown, quick presses add up", async () => {
  await release("oil.free_surface_radius");
  await panel(page, "stability");
  const wanted = [];
  page.on("request", r => { if (r.url().includes("/api/reach")) wanted.push(r.postDataJSON().target.to * 30 / Math.PI); });
  const handle = handles("stability").nth(2), name = await handle.getAttribute("data-target"), from = +await handle.getAttribute("aria-valuenow");
  await handle.focus();
  const was = await text(page);
  for (let i = 0; i < 3; i++) await page.keyboard.press("ArrowRight");
  await changed(page, was);
  await page.waitForFunction(from => [...document.querySelectorAll("#panel-stability .target")].some(e => Math.abs(+e.getAttribute("aria-valuenow") - from) > 900 && Math.abs(+e.getAttribute("aria-valuenow") - from) < 3000), from);
  const step = (wanted.at(-1) - from) / 3;
  assert.ok(step > 300 && step < 700, `${wanted} from ${from}`);
  await page.waitForTimeout(300);
  assert.equal(await inFocus(), name);
  // once more after the figure has followed, with shift
  const before = wanted.length;
  await page.keyboard.press("Shift+ArrowLeft");
  await page.waitForTimeout(600);
  assert.equal(await inFocus(), name);
  assert.ok(wanted.length > before);
  assert.ok(Math.abs(wanted.at(-1) - (from + 3 * step - 10 * step)) < 0.05 * step, `${wanted}`);
  // a zoomed figure has smaller steps
  await page.locator("#panel-stability figure.fig").focus();
  for (let i = 0; i < 2; i++) await page.keyboard.press("+");
  await page.waitForTimeout(200);
  const inside = page.locator("#panel-stability svg:visible .target");
  if (await inside.count()) {
    const now = +await inside.first().getAttribute("aria-valuenow");
    await inside.first().focus();
    const asked = page.waitForRequest(r => r.url().includes("/api/reach"));
    await page.keyboard.press("ArrowRight");
    const to = (await asked).postDataJSON().target.to * 30 / Math.PI;
    assert.ok(Math.abs(to - now - step / 4) < 0.05 * step, `${now} to ${to}, ${step}`);
  }
});

test("a result is written with a unit; what is no number is refused at the field", async () => {
  await release("oil.free_surface_radius");
  await panel(page, "stability");
  await page.locator("#panel-stability svg:visible .target .hit").nth(2).click();
  const field = page.locator("#reach .pick input"), asked = [];
  page.on("request", r => { if (r.url().includes("/api/reach")) asked.push(r.postDataJSON().target.to); });
  for (const wrong of ["abc", "", "nan", "30 mm", "1.2.3", "5 kg"]) {
    await field.fill(wrong);
    await field.press("Enter");
    assert.equal(await field.getAttribute("aria-invalid"), "true", wrong);
    assert.match(await page.locator("#reach .wrong").textContent(), /number.*rpm/i);
  }
  await picture(page, "wrong-number");
  assert.deepEqual(asked, []);
  await field.fill("420 Hz");
  assert.equal(await field.getAttribute("aria-invalid"), null);
  await field.press("Enter");
  await page.waitForSelector("#reach .ok");
  assert.match(await inFocus(), /stability_limit/, "the keyboard goes on at the handle");
  assert.ok(Math.abs(asked[0] - 420 * 2 * Math.PI) < 1e-6 * asked[0], `${asked}`);
  assert.match(await page.locator("#reach .ok").textContent(), /25.?200 rpm/);
});

test("what is said of a text ends with it: notice, and the message of a result", async () => {
  await release("oil.free_surface_radius");
  await panel(page, "stability");
  await pull(page, page.locator("#panel-stability svg:visible .target .hit").nth(2), 20, 0);
  await page.waitForSelector("#reach .ok");
  await page.waitForTimeout(300);
  assert.equal(await page.locator("#reach .ok").count(), 1, "its own change does not end it");
  await undo();
  await page.waitForSelector("#reach .hint");
  const [low, high] = await parameter(page, "oil.free_surface_radius").locator(".bound").all();
  await low.fill("46.5");
  await high.fill("46.8");
  await pull(page, page.locator("#panel-stability svg:visible .target .hit").nth(2), 60, 0);
  await page.waitForSelector("#reach .bad");
  // the search for where the handle was let go has ended, too: one that goes on would answer for the next text
  await page.waitForSelector("#reach .nearest");
  const was = await text(page);
  await write(page, "drum.mass", "3 kg");
  await changed(page, was);
  await page.waitForSelector("#reach .hint");
  // a refused value, then a change of the text by hand
  await write(page, "drum.mass", "-3 kg");
  await page.waitForSelector("#status.notice");
  await undo();
  await page.waitForSelector("#status.notice", { state: "detached" });
});

test("a zoomed figure that new curves have left shows its whole range again", async () => {
  const p = await panel(page, "forced"), svg = p.locator("svg:visible").first(), box = await svg.boundingBox();
  const plot = await svg.evaluate(e => { const r = e.getBoundingClientRect(), k = r.width / e.viewBox.baseVal.width, q = e.querySelector(".p"); return { x: +e.dataset.x * k, w: +e.dataset.w * k, y: +q.dataset.y * k, h: +q.dataset.h * k }; });
  const at = (x, y) => [box.x + plot.x + x * plot.w, box.y + plot.y + y * plot.h];
  // above the curves of a heavier drum, around those of now
  await page.mouse.move(...at(0.55, 0.36));
  await page.mouse.down();
  await page.mouse.move(...at(0.95, 0.46), { steps: 5 });
  await page.mouse.up();
  const reset = p.locator("figure.fig button").first();
  await reset.waitFor({ state: "visible" });
  await picture(page, "zoomed");
  const lines = () => p.locator("svg:visible").first().evaluate(e => [...e.querySelector(".p").querySelectorAll(".se > .s")].some(s => /L|l|h|H/.test(s.getAttribute("d") ?? "")));
  assert.ok(await lines());
  await write(page, "drum.eccentricity", "0.01 um");
  await page.waitForFunction(() => /eccentricity\s*= "0.01 um"/.test(editorView().state.doc.toString()));
  await reset.waitFor({ state: "hidden" });
  await picture(page, "whole-again");
});
