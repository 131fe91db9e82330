// Pieces of the page that need no browser.

import assert from "node:assert/strict";
import { test } from "node:test";
import { build } from "esbuild";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const sources = join(dirname(fileURLToPath(import.meta.url)), "../src");
globalThis.document = { head: { dataset: {} } };

async function load(file) {
  const { outputFiles } = await build({ entryPoints: [join(sources, file)], bundle: true, write: false, format: "esm", target: "es2022", logLevel: "silent" });
  return import("data:text/javascript;base64," + Buffer.from(outputFiles[0].text).toString("base64"));
}

const tick = ms => new Promise(r => setTimeout(r, ms));

test("one request of a kind at a time, the newest wins, what waits too long is abandoned", async () => {
  const { Lane } = await load("studio/lane.ts");
  const begun = [], done = [], abandoned = [];
  let running = 0;
  const lane = new Lane(async (n, signal) => {
    begun.push(n);
    assert.equal(++running, 1);
    try {
      await new Promise((ok, no) => {
        const t = setTimeout(ok, n === 100 ? 5000 : 20);
        signal.addEventListener("abort", () => { clearTimeout(t); no(new DOMException("", "AbortError")); });
      });
      done.push(n);
    } catch (e) { abandoned.push(n); throw e; } finally { running--; }
  }, e => assert.fail(e));
  let rests = 0;
  lane.idled = () => { rests++; };
  const rest = async lane => { while (!lane.idle) await tick(5); };
  for (let n = 1; n <= 9; n++) lane.ask(n);
  await rest(lane);
  assert.deepEqual(begun, [1, 9]);
  assert.equal(done.at(-1), 9);
  assert.equal(rests, 1);
  lane.ask(100);
  await tick(20);
  const since = performance.now();
  lane.ask(101);
  await rest(lane);
  assert.ok(abandoned.includes(100) && performance.now() - since < 4000);
  assert.equal(done.at(-1), 101);
  // a failure does not end the lane
  let failures = 0;
  const weak = new Lane(n => n === 1 ? Promise.reject(new Error("x")) : Promise.resolve(), () => { failures++; });
  weak.ask(1);
  weak.ask(2);
  await rest(weak);
  assert.equal(failures, 1);
});

test("a slider and its value are inverses, to the digits of a step", async () => {
  const { toSlider, fromSlider, written, inFile } = await load("studio/quantity.ts");
  for (const [low, high] of [[1, 3], [1e5, 1e8], [-0.2, 0.4], [0, 1]])
    for (const k of [0, 1, 250, 500, 999, 1000]) {
      const v = fromSlider(k, low, high);
      assert.ok(v >= low && v <= high && Math.abs(toSlider(v, low, high) - k) <= 1, `${low} ${high} ${k}: ${v}`);
    }
  assert.equal(toSlider(7, 3, 3), 0);
  assert.ok(String(fromSlider(333, 0, 1)).length <= 6);
  const p = { path: "oil.r", value: 0.0467, unit: "m", display_unit: "mm", shown: "46.7 mm", from: 3, to: 9 };
  assert.deepEqual(written(p), { unit: "mm", factor: 1000 });
  assert.equal(inFile(p, 0.05), "50 mm");
  assert.deepEqual(written({ ...p, from: null }), { unit: "m", factor: 1 });
});

test("places and values of axes are inverses on all scales", async () => {
  const { place, value, ticks } = await load("report/axis.ts");
  const axis = { k: 0, names: [], lo: 2, hi: 900, log: false, e: 0, n: "", u: "", ul: "", bare: false };
  for (const ax of [axis, { ...axis, log: true }, { ...axis, k: 5, lo: -300 }])
    for (const t of [0, 0.1, 0.5, 1]) assert.ok(Math.abs(place(ax, value(ax, t)) - t) < 1e-12);
  assert.ok(Number.isNaN(place({ ...axis, log: true }, -1)));
  for (const ax of [axis, { ...axis, log: true }, { ...axis, k: 5, lo: -300 }]) {
    const all = ticks(ax, ax.lo, ax.hi, 6);
    assert.ok(all.length >= 2 && all.length <= 12 && all.every(t => t[0] >= ax.lo && t[0] <= ax.hi && t[1]), JSON.stringify(all));
  }
});

test("a curve is interrupted where it has no value", async () => {
  const { linePath } = await load("report/path.ts");
  const d = linePath([0, 1, 2, 3, 4], [0, 1, NaN, 1, 2], t => 10 * t, t => 10 * t, 0, 40);
  assert.equal((d.match(/M/g) ?? []).length, 2);
  assert.doesNotMatch(d, /NaN/);
});

test("solids of revolution move as their stations do", async () => {
  const { mesh, moved, stationsOf, whirl } = await load("studio/solid.ts");
  const solid = { name: "s", body: "b", kind: "shaft", outline: [[0, 0], [0, 1], [4, 1], [4, 0]], at: [0, 0] };
  const g = mesh(solid, 4), n = g.getAttribute("position"), normal = g.getAttribute("normal");
  // light falls from outside: a normal points away from the inside
  for (let i = 0; i < n.count; i++) {
    const out = normal.getX(i) * n.getX(i) + normal.getY(i) * n.getY(i) + normal.getZ(i) * (n.getZ(i) - 2);
    assert.ok(out > -1e-9, `vertex ${i}`);
  }
  const shape = { stations: [{ body: "b", z: 4, x: [3, 0], y: [0, 1] }, { body: "b", z: 0, x: [1, 0], y: [0, 0] }, { body: "c", z: 0, x: [9, 9], y: [9, 9] }] };
  const own = stationsOf(shape, "b");
  assert.deepEqual(moved(own, 1), [1.5, 0, 0, 0.25]);
  assert.deepEqual(moved(own, 6), [4, 0, 0, 1.5]);
  assert.deepEqual(stationsOf(shape, null), []);
  whirl(g, own);
  const w = g.getAttribute("whirl");
  for (let i = 0; i < n.count; i++) assert.ok(Math.abs(w.getX(i) - (1 + n.getZ(i) / 2)) < 1e-5);
});
