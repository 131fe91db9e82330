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

test("knobs of handles lie apart from each other: speeds up from the axis, sizes beside the curve", async () => {
  const { staggered, GAP } = await load("studio/knobs.ts"), area = { left: 0, right: 300, top: 0, bottom: 160 };
  const apart = all => all.every((p, i) => all.every((q, j) => i === j || Math.hypot(p.x - q.x, p.y - q.y) >= 26));
  const speeds = staggered([40, 41, 52, 120, 141].map(x => ({ x, y: 160, along: "x" })), area);
  assert.ok(apart(speeds), JSON.stringify(speeds));
  assert.deepEqual(speeds.map(p => p.x), [40, 41, 52, 120, 141]);
  assert.deepEqual([speeds[0].y, speeds[3].y], [160, 160]);
  const sizes = staggered([{ x: 298, y: 20, along: "y" }, { x: 298, y: 22, along: "y" }, { x: 298, y: 24, along: "y" }], area);
  assert.ok(apart(sizes) && sizes.every((p, i) => p.y === 20 + 2 * i && p.x <= 300), JSON.stringify(sizes));
  const both = staggered([{ x: 100, y: 155, along: "y" }, { x: 100, y: 160, along: "x" }], area);
  assert.deepEqual(both, [{ x: 100 + GAP, y: 155 }, { x: 100, y: 160 }]);
  // as many as there are, all stay inside
  const many = staggered(Array.from({ length: 24 }, (_, i) => i % 2 ? { x: 5, y: 160, along: "x" } : { x: 6, y: 10 + i, along: "y" }), area);
  assert.ok(apart(many) && many.every(p => p.x >= -1 && p.x <= 301 && p.y >= -1 && p.y <= 161), JSON.stringify(many));
});

test("a number is read with the units of its axis, and no other", async () => {
  const { wanted, bare } = await load("studio/ask.ts"), near = (text, shown, v) => assert.ok(Math.abs(wanted(text, shown) - v) < 1e-9 * Math.abs(v), `${text}: ${wanted(text, shown)}`);
  for (const [t, v] of [["25000", 25000], [" 25 000 rpm", 25000], ["25\u00a0000", 25000], ["30 Hz", 1800], ["30hz", 1800], ["100 rad/s", 3000 / Math.PI], ["1,5e3", 1500], ["\u22125", -5], ["- 5", -5], ["+5 RPM", 5], [".5", 0.5]]) near(t, "rpm", v);
  near("3000 rpm", "Hz", 50);
  near("3000 rpm", "rad/s", 100 * Math.PI);
  for (const u of ["µm", "μm", "um"]) near(`250 ${u}`, "mm", 0.25);
  near("2 mm", "µm", 2000);
  near("0,002 m", "mm", 2);
  for (const t of ["", " ", "abc", "nan", "NaN", "inf", "-", "1.2.3", "1,000.5", "30 mm", "5 kg", "rpm", "1e999", "3 4"]) assert.equal(wanted(t, "rpm"), null, t);
  assert.equal(wanted("5 rpm", "mm"), null);
  assert.equal(wanted("5 N", "N"), 5);
  assert.deepEqual([bare("46,5"), bare("46.5 mm"), bare("")], [46.5, null, null]);
});

test("names of files that can be saved", async () => {
  const { filename } = await load("studio/filename.ts");
  for (const [written, name] of [["a.toml", "a.toml"], [" rotor ", "rotor.toml"], ["sub/rotor", "sub/rotor.toml"], ["ротор 2", "ротор 2.toml"], ["v1.2.toml", "v1.2.toml"]]) assert.equal(filename(written), name);
  for (const wrong of ["", "   ", "..", ".", "../a.toml", "a/", "a//b", "/a", "a\\b", "C:a", ".toml", "a.txt", "a/..", "a\u0000b", "a/ /b"]) assert.equal(filename(wrong), null, wrong);
});

test("whether a curve passes through a range", async () => {
  const { inside } = await load("report/inside.ts"), line = { x: [0, 1], y: [0, 1], joined: true };
  assert.ok(inside(line, [0.4, 0.6], [0.4, 0.6]));
  assert.ok(!inside(line, [0.4, 0.5], [0.6, 0.9]));
  assert.ok(!inside({ ...line, joined: false }, [0.4, 0.6], [0.4, 0.6]));
  assert.ok(!inside({ x: [0, 0.5, 1], y: [0, NaN, 1], joined: true }, [0.4, 0.6], [0.4, 0.6]));
  assert.ok(inside({ x: [0.5], y: [0.5], joined: true }, [0, 1], [0, 1]));
});
