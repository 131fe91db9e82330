// Drag the answer, pins, share, long runs.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { Server, changed, launch, open, panel, parameter, picture, pull, route, text, write } from "./studio.mjs";

let b, server, page;
before(async () => { b = await launch(); server = await Server.start(); });
after(async () => { await b.close(); await server.close(); });
beforeEach(async () => { page = await open(b, server); });
afterEach(async () => { assert.deepEqual(page.complaints, []); await page.context().close(); });

test("a limit of stability is pulled: the released parameter moves, as one step", async () => {
  const was = await text(page), p = await panel(page, "stability");
  await p.locator("svg:visible .target").first().waitFor();
  await pull(page, p.locator("svg:visible .target .hit").nth(2), -20, 0);
  assert.match(await page.locator("#status").textContent(), /free/);
  assert.equal(await text(page), was);
  await parameter(page, "oil.free_surface_radius").locator(".release input").check();
  await panel(page, "stability");
  await pull(page, p.locator("svg:visible .target .hit").nth(2), 20, 0);
  await page.waitForSelector("#reach .ok, #reach .bad");
  await picture(page, "reach");
  assert.equal(await page.locator("#reach .ok").count(), 1, await page.locator("#reach").textContent());
  await changed(page, was);
  assert.match(await page.locator("#reach .moved").textContent(), /\d/);
  await page.click("[data-act=undo]");
  assert.equal(await text(page), was);
});

test("a result is written as a number", async () => {
  const was = await text(page);
  await parameter(page, "oil.free_surface_radius").locator(".release input").check();
  const p = await panel(page, "stability");
  await p.locator("svg:visible .target .hit").nth(2).click();
  await page.locator("#reach .pick input").fill("25000");
  await page.keyboard.press("Enter");
  await page.waitForSelector("#reach .ok");
  await changed(page, was);
  await page.waitForFunction(() => /25.?000/.test(document.querySelector("#panel-stability .target:nth-of-type(n)")?.parentElement.textContent ?? ""), null, { timeout: 5000 });
  await page.click("[data-act=undo]");
  assert.equal(await text(page), was);
});

test("what cannot be reached has a sentence, and changes nothing", async () => {
  const was = await text(page);
  await parameter(page, "oil.free_surface_radius").locator(".release input").check();
  const [low, high] = await parameter(page, "oil.free_surface_radius").locator(".bound").all();
  await low.fill("46.5");
  await high.fill("46.8");
  const p = await panel(page, "stability");
  await pull(page, p.locator("svg:visible .target .hit").nth(2), 60, 0);
  await page.waitForSelector("#reach .bad");
  assert.ok((await page.locator("#reach .bad").textContent()).length > 20);
  await picture(page, "impossible");
  assert.equal(await text(page), was);
});

test("a pinned design stays beside the text: checks that differ, curves over the figures", async () => {
  await panel(page, "nonlinear");
  await panel(page, "page");
  await page.click("[data-act=pin]");
  await write(page, "drum.mass", "4 kg");
  await page.waitForSelector("#compare .differs");
  await panel(page, "nonlinear");
  await page.waitForSelector("#panel-nonlinear .pinned path");
  await picture(page, "pinned");
  await page.locator("#compare").scrollIntoViewIfNeeded();
  await picture(page, "compare");
  await page.locator("#compare .acts button").first().click();
  await page.waitForFunction(() => document.querySelector('.row[data-path="drum.mass"] .written')?.value === "2.4 kg");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("[data-act=share]")]);
  const html = readFileSync(await download.path(), "utf8");
  assert.match(html, /^<!doctype html>/i);
  assert.match(html, /oil separator/);
});

test("a long study runs beside the page: progress, pause, resume, cancel; a short one ends with its report", async () => {
  const job = page.locator("#runs .job").first(), state = s => page.waitForSelector(`#runs .job[data-state=${s}]`);
  await page.evaluate(() => editorView().dispatch({
    changes: { from: editorView().state.doc.length, insert: `
[[study]]
kind = "stability_map"
name = "fine map"
speed = { from = "25 rad/s", to = "5000 rad/s", points = 400 }
parameter = { parameter = "oil.free_surface_radius", from = "30 mm", to = "68 mm", points = 400 }
` } }));
  const run = name => page.locator("#runs .studies li", { hasText: name }).locator("button");
  await run("fine map").waitFor();
  await run("fine map").click();
  await state("running");
  await page.waitForFunction(() => document.querySelector("#runs progress").value > 0);
  await job.locator("button", { hasText: "Pause" }).click();
  await state("paused");
  await write(page, "drum.mass", "3 kg");
  await page.waitForFunction(() => document.querySelector('.row[data-path="drum.mass"] .written')?.value === "3 kg");
  await job.locator("button", { hasText: "Resume" }).click();
  await state("running");
  await page.locator("#runs").scrollIntoViewIfNeeded();
  await picture(page, "running");
  await job.locator("button", { hasText: "Cancel" }).click();
  await state("cancelled");
  assert.match(await job.locator(".state").textContent(), /^cancelled · \d+ \/ \d+$/);
  const [done, total] = (await job.locator(".state").textContent()).match(/\d+/g).map(Number);
  assert.ok(done > 0 && done < total && Math.abs(await job.locator("progress").evaluate(e => e.value) - done / total) < 1e-6, `${done} of ${total}`);
  await run("modes").first().click();
  await state("done");
  const [report] = await Promise.all([page.context().waitForEvent("page"), page.locator("#runs .job[data-state=done] a").click()]);
  await report.waitForLoadState();
  assert.match(await report.title(), /oil separator/);
  assert.ok(existsSync(join(server.folder, "out")));
  // an older program lists no runs
  if (!await page.evaluate(() => fetch("./api/runs").then(r => r.ok))) return;
  const known = await page.locator("#runs .job").evaluateAll(all => all.map(e => [e.dataset.run, e.dataset.state]));
  page.once("dialog", d => d.accept());
  await page.reload();
  await page.waitForFunction(n => document.querySelectorAll("#runs .job").length === n && [...document.querySelectorAll("#runs .job")].every(e => /done|cancelled/.test(e.dataset.state)), known.length);
  assert.deepEqual(await page.locator("#runs .job").evaluateAll(all => all.map(e => [e.dataset.run, e.dataset.state])), known);
  assert.match(await page.locator("#runs .job[data-state=cancelled] .state").textContent(), /cancelled · \d+ \/ \d+/);
});

test("runs of the program are listed again, and can be steered; a cancelled one stands where it was", async () => {
  await page.evaluate(() => editorView().dispatch({
    changes: { from: editorView().state.doc.length, insert: `
[[study]]
kind = "stability_map"
name = "fine map"
speed = { from = "25 rad/s", to = "5000 rad/s", points = 300 }
parameter = { parameter = "oil.free_surface_radius", from = "30 mm", to = "68 mm", points = 300 }
` } }));
  await page.locator("#runs .studies li", { hasText: "fine map" }).locator("button").click();
  await page.waitForSelector("#runs .job[data-state=running]");
  const id = await page.locator("#runs .job").first().getAttribute("data-run");
  const list = [
    { id: "902", study: "half a map", state: "cancelled", done: 3, total: 8, report: true },
    { id: "901", study: "old map", state: "done", done: 8, total: 8 },
    { id: "900", study: "bad map", state: "failed", done: 0, total: 0, error: "no such part" },
  ];
  const two = await page.context().newPage();
  if (process.env.LAVAL_ASSETS) await route(two);
  // the first one goes on, as the tab that started it knows
  const first = () => page.locator(`#runs .job[data-run="${id}"]`).evaluate(e => ({ state: e.dataset.state, counts: e.querySelector(".state").textContent.match(/\d+/g) ?? [0, 0] }));
  await two.route(/\/api\/runs(\?.*)?$/, async r => {
    if (r.request().method() !== "GET") return r.continue();
    const { state, counts: [done, total] } = await first();
    return r.fulfill({ json: { runs: [{ id, study: "fine map", state, done: +done, total: +total, report: state === "cancelled" }, ...list] } });
  });
  await two.goto(server.address);
  await two.waitForFunction(() => document.querySelectorAll("#runs .job").length === 4);
  const job = n => two.locator("#runs .job").nth(n);
  assert.deepEqual(await two.locator("#runs .job b").allTextContents(), ["fine map", "half a map", "old map", "bad map"]);
  assert.equal(await job(1).locator(".state").textContent(), "cancelled · 3 / 8");
  assert.equal(await job(1).locator("progress").evaluate(e => e.value), 3 / 8);
  assert.equal(await job(1).locator("a").count(), 1, "what it has is reported");
  assert.equal(await job(2).locator("a").count(), 1);
  assert.equal(await job(3).locator(".state").textContent(), "no such part");
  await two.locator("#runs").scrollIntoViewIfNeeded();
  await picture(two, "runs-again");
  // the other tab steers it
  await job(0).locator("button", { hasText: "Pause" }).click();
  await page.waitForSelector(`#runs .job[data-run="${id}"][data-state=paused]`);
  await two.waitForSelector(`#runs .job[data-run="${id}"][data-state=paused]`);
  await job(0).locator("button", { hasText: "Resume" }).click();
  await two.waitForSelector(`#runs .job[data-run="${id}"][data-state=running]`);
  await job(0).locator("button", { hasText: "Cancel" }).click();
  await two.waitForSelector(`#runs .job[data-run="${id}"][data-state=cancelled]`);
  assert.equal(await job(0).locator("a").count(), 1);
  // looked at again: nothing twice
  await two.evaluate(() => dispatchEvent(new Event("focus")));
  await two.waitForTimeout(300);
  assert.equal(await two.locator("#runs .job").count(), 4);
  await two.close();
});
