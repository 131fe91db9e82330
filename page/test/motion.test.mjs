// Responses and transients in space; ranges of sliders.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Server, launch, open, panel, parameter, picture, write } from "./studio.mjs";

let b, server;
before(async () => { b = await launch(); server = await Server.start(); });
after(async () => { await b.close(); await server.close(); });

const space = async page => {
  await panel(page, "modes");
  await page.click("#tab-space");
  await page.waitForSelector("#space[data-ready] canvas");
};
const fact = page => page.locator("#motion .fact").textContent();
const factIs = (page, pattern) => page.waitForFunction(p => new RegExp(p).test(document.querySelector("#motion .fact").textContent), pattern);
const shot = async page => (await page.locator("#space").screenshot()).toString("base64");

for (const [kind, pattern] of [["forced", "larger, .* slower"], ["nonlinear", "larger, .* slower"], ["transient", "larger, .* slower"]]) test(`${kind} is played`, async () => {
  const page = await open(b, server);
  await space(page);
  const of = await page.locator(`#motion option[value="${kind}"]`).textContent();
  assert.match(of, /3000 rpm/);
  await page.selectOption("#motion select", kind);
  await factIs(page, pattern);
  assert.match(await fact(page), /µm/);
  await page.waitForTimeout(500);
  await picture(page, `motion-${kind}`);
  const one = await shot(page);
  await page.waitForTimeout(300);
  assert.notEqual(await shot(page), one, "it moves");
  const clock = await page.locator("#motion .clock").textContent();
  assert.equal(clock !== "", kind === "transient");
  // the size shown follows the slider
  const was = await fact(page);
  await page.locator("#motion input").first().fill("200");
  assert.notEqual(await fact(page), was);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("the response follows the file and the speed", async () => {
  const page = await open(b, server);
  await space(page);
  await page.selectOption("#motion select", "forced");
  await factIs(page, "larger");
  const was = await fact(page);
  await write(page, "drum.mass", "5 kg");
  await page.waitForFunction(was => { const now = document.querySelector("#motion .fact").textContent; return now !== was && /larger/.test(now); }, was);
  const then = await fact(page);
  await page.locator("#motion input").nth(1).fill("600");
  await page.waitForFunction(was => { const now = document.querySelector("#motion .fact").textContent; return now !== was && /larger/.test(now); }, then);
  assert.match(await page.locator("#motion option:checked").textContent(), /3600 rpm/);
  // a mode is chosen again by its card
  await page.locator("#panel-modes .mode").first().click();
  assert.equal(await page.locator("#motion select").inputValue(), "mode:0");
  assert.match(await fact(page), /1\/s/);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("the modes say at which speed they are; the choice shows what is shown", async t => {
  const slow = await Server.start();
  t.after(() => slow.close());
  const page = await open(b, slow), chosen = () => page.locator("#motion select").inputValue();
  await panel(page, "modes");
  assert.equal(await chosen(), "mode:0");
  assert.match(await page.locator("#title-modes").textContent(), /3000 rpm/);
  assert.ok((await page.locator("#motion option").count()) > 6);
  await page.locator("#motion input").nth(1).fill("600");
  await page.waitForFunction(() => /3600 rpm/.test(document.querySelector("#title-modes").textContent));
  assert.equal(await chosen(), "mode:0");
  assert.deepEqual(page.complaints, []);
  // modes that come late are no reason for another choice
  await page.routeWebSocket(/\/api\/live/, ws => ws.close());
  await page.route(/\/api\/answer/, async route => { if (route.request().postDataJSON().want[0] === "modes") await new Promise(r => setTimeout(r, 1500)); await route.continue(); });
  await page.reload();
  await page.waitForSelector("#motion option", { state: "attached" });
  await page.waitForFunction(() => document.querySelectorAll("#motion option").length > 6);
  assert.equal(await chosen(), "mode:0");
  await page.context().close();
});

test("transients of the file, and of machines with balls", async t => {
  const balls = await Server.start("04-ball-balancer");
  t.after(() => balls.close());
  const page = await open(b, balls);
  // it has no modes to wait for
  await page.click("#tab-space");
  await page.waitForSelector("#space[data-ready] canvas");
  await page.selectOption("#motion select", "transient:balancing");
  await factIs(page, "larger");
  await page.waitForTimeout(500);
  await picture(page, "motion-balancing");
  // what cannot be computed is answered by a sentence
  await page.selectOption("#motion select", "forced");
  await factIs(page, "no rest");
  await page.selectOption("#motion select", "nonlinear");
  await factIs(page, "larger");
  assert.equal(await page.locator("#motion option[value^=nonlinear]").count(), 2);
  await page.selectOption("#motion select", "nonlinear:1");
  await factIs(page, "171");
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("a slider ends where the file describes no machine", async () => {
  const page = await open(b, server);
  const answered = page.waitForResponse(r => r.url().includes("/api/ranges"));
  await (await answered).finished();
  await page.waitForTimeout(100);
  const slider = parameter(page, "oil.free_surface_radius").locator("input[type=range]");
  await slider.focus();
  await page.keyboard.press("End");
  await page.waitForFunction(() => /free_surface_radius = "69\.\d+ mm"/.test(editorView().state.doc.toString()));
  await page.waitForTimeout(600);
  assert.equal(await page.locator("#status.wrong").count(), 0);
  // one number for both axes: one slider
  assert.equal(await parameter(page, "housing.damping").count(), 1);
  assert.equal(await parameter(page, "housing.damping.x").count(), 0);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});
