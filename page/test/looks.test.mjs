// Languages, dark and light, tablets and phones, names for screen readers, the machine in space.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Server, launch, open, panel, picture } from "./studio.mjs";

let b, server;
before(async () => { b = await launch(); server = await Server.start(); });
after(async () => { await b.close(); await server.close(); });

/** Elements that can be used but have no name, and words that no catalogue has. */
const defects = page => page.evaluate(() => {
  const out = [];
  for (const e of document.querySelectorAll("button, input, select, [role=slider], [role=tab], [tabindex='0']")) {
    if (!e.getClientRects().length) continue;
    const by = e.getAttribute("aria-labelledby"), named = e.getAttribute("aria-label") || (by && document.getElementById(by)?.textContent) || e.textContent.trim() || e.closest("label")?.textContent.trim() || e.title;
    if (!named) out.push("no name: " + e.outerHTML.slice(0, 120));
  }
  const text = document.body.innerText;
  for (const m of text.matchAll(/\b(?:want|tab|short|state|theme)-[a-z]+\b|\{\w+\}/g)) out.push("raw word: " + m[0]);
  if (document.documentElement.scrollWidth > innerWidth + 1) out.push("the page scrolls sideways");
  for (const id of ["pane-text", "pane-machine", "pane-figures"]) {
    const e = document.getElementById(id);
    if (e.getClientRects().length && e.scrollWidth > e.clientWidth + 1) out.push(`${id} scrolls sideways`);
  }
  return out;
});

for (const lang of ["en", "ru", "kk", "uz"]) test(`all words in ${lang}`, async () => {
  const page = await open(b, server, { query: `?lang=${lang}` });
  await panel(page, "page");
  assert.equal(await page.evaluate(() => document.documentElement.lang), lang);
  assert.deepEqual(await defects(page), []);
  await picture(page, `language-${lang}`);
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

for (const [name, width, height] of [["tablet", 820, 1180], ["phone", 390, 844]]) test(`on a ${name}, dark`, async () => {
  const page = await open(b, server, { width, height, colorScheme: "dark", hasTouch: true });
  for (const tab of ["text", "machine", "figures"]) {
    await page.tap(`#panes-tabs [data-tab=${tab}]`);
    await page.waitForTimeout(300);
    assert.deepEqual(await defects(page), [], tab);
    await picture(page, `${name}-${tab}`);
  }
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

test("dark and light by choice", async () => {
  const page = await open(b, server, { colorScheme: "light" });
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await paper();
  await page.click("[data-act=theme]");
  assert.equal(await paper(), light);
  await page.click("[data-act=theme]");
  assert.notEqual(await paper(), light);
  await picture(page, "dark");
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  assert.notEqual(await paper(), light);
  await page.context().close();
});

test("the machine in space whirls, and stops", async () => {
  const page = await open(b, server);
  await panel(page, "modes");
  await page.click("#tab-space");
  await page.waitForSelector("#space[data-ready] canvas");
  await page.waitForTimeout(800);
  await picture(page, "space");
  const shot = async () => (await page.locator("#space").screenshot()).toString("base64");
  const one = await shot();
  await page.waitForTimeout(300);
  assert.notEqual(await shot(), one, "it moves");
  await page.locator("#motion button").click();
  await page.waitForTimeout(200);
  const held = await shot();
  await page.waitForTimeout(300);
  assert.equal(await shot(), held, "it stands still");
  await page.locator("#space").focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForTimeout(200);
  assert.notEqual(await shot(), held, "keys turn it");
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});
