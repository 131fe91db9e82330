// Makes the drawings of the report interactive: readout, zoom, legend switches. The drawings are complete without it.
"use strict";
(() => {
const errors = [];
addEventListener("error", e => errors.push(String(e.message)));
addEventListener("unhandledrejection", e => errors.push(String(e.reason)));
addEventListener("securitypolicyviolation", e => errors.push("blocked: " + e.violatedDirective));
const consoleError = console.error;
console.error = (...a) => { errors.push(a.join(" ")); consoleError.apply(console, a); };

const SUP = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const power = d => d === 0 ? "1" : d === 1 ? "10" : "10" + String(d).replace(/-/, "⁻").replace(/\d/g, c => SUP[c]);
// Numbers and units as the language of the page writes them.
const words = document.head.dataset;
const minus = s => s.replace(/^-/, "−").replace(".", words.decimal || ".");
const unit = u => u ? " " + u : "";

function number(v) {
  if (!isFinite(v)) return "–";
  const a = Math.abs(v);
  if (a !== 0 && (a >= 1e6 || a < 1e-4)) {
    const [m, e] = v.toExponential(4).split("e");
    return minus(String(+m)) + "·" + power(+e);
  }
  return minus(String(+v.toPrecision(5)));
}

function floats(text) {
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return new Float32Array(bytes.buffer);
}

// Value at a place 0..1 of an axis, and back.
const bend = (ax, v) => Math.asinh(v / ax.k);
const value = (ax, t) => ax.k ? ax.k * Math.sinh(bend(ax, ax.lo) + t * (bend(ax, ax.hi) - bend(ax, ax.lo))) : ax.log ? ax.lo * Math.pow(ax.hi / ax.lo, t) : ax.lo + t * (ax.hi - ax.lo);
const place = (ax, v) => ax.k ? (bend(ax, v) - bend(ax, ax.lo)) / (bend(ax, ax.hi) - bend(ax, ax.lo)) : ax.log ? (v > 0 ? Math.log(v / ax.lo) / Math.log(ax.hi / ax.lo) : NaN) : (v - ax.lo) / (ax.hi - ax.lo);

function step(span, most) {
  const raw = span / Math.max(most, 1), p = Math.pow(10, Math.floor(Math.log10(raw)));
  return [1, 2, 5, 10].map(m => m * p).find(s => s >= raw * (1 - 1e-9)) || 10 * p;
}

// Logarithmic lengths: each tick with its own prefix, 100 µm, 1 mm.
const LENGTHS = [[0, "m"], [-3, "mm"], [-6, "µm"], [-9, "nm"]];
const NAMES = (words.lengths || "m mm µm nm").split(" ");
const lengthName = u => NAMES[LENGTHS.findIndex(l => l[1] === u)] || u;
const metres = ax => { const l = ax.log && LENGTHS.find(l => l[1] === ax.u); return l ? l[0] : null; };
const lengthUnit = d => LENGTHS.find(l => d >= l[0]) || LENGTHS[3];
const powers = (m, d) => d > 1 || d < 0 ? (m > 1 ? m + "·" : "") + power(d) : String(m * Math.pow(10, d));
function length(m, d) {
  const [p, u] = lengthUnit(d), r = d - p;
  return minus(r >= -3 && r <= 5 ? (m * Math.pow(10, r)).toFixed(Math.max(0, -r)) : powers(m, r)) + " " + lengthName(u);
}

// Labelled ticks of an axis between two values.
function ticks(ax, lo, hi, most) {
  if (ax.bare) return [];
  if (ax.names.length) return ax.names.filter(n => n[0] >= lo && n[0] <= hi);
  if (ax.k) {
    const out = [], room = 1 / (most + 2), at = v => (bend(ax, v) - bend(ax, lo)) / (bend(ax, hi) - bend(ax, lo));
    const put = (v, room) => { if (v >= lo && v <= hi && out.every(t => Math.abs(at(t[0]) - at(v)) >= room)) out.push([v, number(v)]); };
    const first = Math.ceil(Math.log10(ax.k) - 1e-9), last = Math.floor(Math.log10(Math.max(Math.abs(lo), Math.abs(hi))) + 1e-9);
    put(0, room);
    for (const s of [-1, 1]) for (let d = last; d >= first; d--) put(s * Math.pow(10, d), room);
    for (const m of [2, 5]) for (let d = first; d <= last; d++) for (const s of [1, -1]) put(s * m * Math.pow(10, d), 1.5 * room);
    if (out.length >= 3) return out.sort((a, b) => a[0] - b[0]);
  }
  const own = metres(ax);
  if (ax.log && hi / lo > 8) {
    const all = [];
    for (let d = Math.floor(Math.log10(lo)); d <= Math.ceil(Math.log10(hi)); d++)
      for (const m of [1, 2, 5]) all.push([m, d, m * Math.pow(10, d)]);
    let inside = all.filter(t => t[2] >= lo && t[2] <= hi);
    if (inside.length > most + 1) inside = inside.filter(t => t[0] === 1);
    const stride = Math.ceil(inside.length / most);
    const plain = lo >= 0.9e-3 && hi <= 1.2e5;
    return inside.filter((t, i) => i % stride === 0).map(([m, d, v]) =>
      [v, own !== null ? length(m, d + own) : plain ? minus(v.toFixed(Math.max(0, -d))) : powers(m, d)]);
  }
  const inside = s => Math.floor(hi / s + 1e-6) - Math.ceil(lo / s - 1e-6) + 1;
  let s = step(hi - lo, most);
  if (ax.u === "°" && !ax.log && hi - lo > 80 && !ax.e)
    s = [15, 30, 45, 90, 180].find(q => (hi - lo) / q <= Math.max(most, 2)) || 360 * Math.ceil((hi - lo) / 360 / Math.max(most, 2));
  else
  for (let m = most + 1; inside(s) < 3 && m < most + 6; m++) s = step(hi - lo, m);
  const [p, u] = own === null ? [0, ""] : lengthUnit(Math.floor(Math.log10(hi) + 1e-9) + own);
  const e = own === null ? Math.pow(10, ax.e) : Math.pow(10, p - own), out = [];
  const digits = Math.min(12, Math.max(0, Math.ceil(-Math.log10(s / e) - 1e-9)));
  for (let k = Math.ceil(lo / s - 1e-6); k <= hi / s + 1e-6 && out.length < 60; k++) {
    let label = (k * s / e).toFixed(digits);
    if (+label === 0) label = label.replace("-", "");
    if (ax.log && digits > 4) label = number(k * s / e);
    out.push([k * s, minus(label) + unit(lengthName(u))]);
  }
  return out;
}

const f1 = v => String(Math.round(v * 10) / 10);

// Path data in pixels; points in one pixel column become first, lowest, highest, last.
function linePath(xs, ys, X, Y, x0, x1) {
  let d = "", pen = "M", n = xs.length;
  const put = i => { if (!isFinite(X(xs[i])) || !isFinite(Y(ys[i]))) { pen = "M"; return; } d += pen + f1(X(xs[i])) + " " + f1(Math.max(-2e4, Math.min(2e4, Y(ys[i])))); pen = "L"; };
  for (let i = 0; i < n;) {
    const x = X(xs[i]), y = Y(ys[i]);
    if (!(isFinite(x) && isFinite(y))) { pen = "M"; i++; continue; }
    // far outside the view only the neighbours of visible points matter
    const out = x < x0 - 50 ? -1 : x > x1 + 50 ? 1 : 0;
    if (out) {
      let j = i;
      while (j + 1 < n && (out < 0 ? X(xs[j + 1]) < x0 - 50 : X(xs[j + 1]) > x1 + 50)) j++;
      if (pen === "L" || d) put(i);
      pen = "M";
      if (j + 1 < n) put(j);
      i = j + 1;
      continue;
    }
    const cell = Math.floor(x);
    let lo = i, hi = i, last = i;
    while (last + 1 < n && Math.floor(X(xs[last + 1])) === cell && isFinite(ys[last + 1])) {
      last++;
      if (ys[last] < ys[lo]) lo = last;
      if (ys[last] > ys[hi]) hi = last;
    }
    [...new Set([i, lo, hi, last])].sort((a, b) => a - b).forEach(put);
    i = last + 1;
  }
  return d;
}

function markerPath(shape, x, y) {
  if (shape >= 1000) {
    const w = (shape - 1000) * Math.PI / 180, S = Math.sin(w), C = Math.cos(w), at = (a, b) => f1(x + a * C + b * S) + " " + f1(y - a * S + b * C);
    return "M" + at(7, 0) + "L" + at(-5, 5) + "L" + at(-5, -5) + "z";
  }
  const r = shape >= 20 ? 2.4 : shape >= 10 ? 5.6 - (shape - 10) : 4.2, M = (a, b) => "M" + f1(a) + " " + f1(b), L = (a, b) => "L" + f1(a) + " " + f1(b);
  switch (shape % 5) {
    case 0: return `${M(x - r, y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0z`;
    case 1: return M(x - .88 * r, y - .88 * r) + `h${1.76 * r}v${1.76 * r}h${-1.76 * r}z`;
    case 2: return M(x, y - 1.15 * r) + L(x + 1.1 * r, y + 0.8 * r) + L(x - 1.1 * r, y + 0.8 * r) + "z";
    case 3: return M(x, y - 1.25 * r) + L(x + 1.25 * r, y) + L(x, y + 1.25 * r) + L(x - 1.25 * r, y) + "z";
    default: return M(x - 1.1 * r, y - 0.8 * r) + L(x + 1.1 * r, y - 0.8 * r) + L(x, y + 1.15 * r) + "z";
  }
}

const NS = "http://www.w3.org/2000/svg";
const el = (name, attributes, text) => {
  const e = document.createElementNS(NS, name);
  for (const k in attributes) e.setAttribute(k, attributes[k]);
  if (text !== undefined) e.textContent = text;
  return e;
};

class Figure {
  constructor(box) {
    this.box = box;
    this.data = JSON.parse(box.querySelector("script").textContent);
    this.tip = box.querySelector(".tip");
    this.hidden = new Set();
    this.views = [...box.querySelectorAll("svg")].map(svg => this.prepare(svg));
    this.button = box.querySelector("button");
    this.button.addEventListener("click", () => this.reset());
    box.addEventListener("keydown", e => this.key(e));
    box.addEventListener("blur", () => this.leave());
    this.unzoomed();
  }

  unzoomed() {
    this.x = [0, 1];
    this.y = this.data.p.map(() => [0, 1]);
  }

  load() {
    if (this.ready) return;
    this.ready = true;
    for (const p of this.data.p) {
      for (const s of p.s) {
        const raw = floats(s.d), n = raw.length / 2;
        s.x = new Float64Array(n); s.y = new Float64Array(n); s.raw = raw;
        for (let i = 0; i < n; i++) { s.x[i] = place(this.data.x, raw[2 * i]); s.y[i] = place(p.y, raw[2 * i + 1]); }
      }
      if (p.h) for (const k of ["x", "y", "v"]) p.h[k] = floats(p.h[k]);
    }
  }

  prepare(svg) {
    const v = { svg, x0: +svg.dataset.x, w: +svg.dataset.w };
    v.panels = [...svg.querySelectorAll(".p")].map(g => ({
      g, y0: +g.dataset.y, h: +g.dataset.h,
      gr: g.querySelector(".gr"), tk: g.querySelector(".tk"), tf: [...g.querySelectorAll(".tf")],
      se: [...g.querySelectorAll(".se > .s")], tx: [...g.querySelectorAll(".tx > text")], rl: [...g.querySelectorAll(".rl")],
      kept: null,
    }));
    v.dot = el("circle", { class: "dot", r: 4.5, visibility: "hidden" });
    v.rubber = el("rect", { class: "rubber", visibility: "hidden" });
    svg.append(v.rubber, v.dot);
    svg.setAttribute("role", "group");
    svg.addEventListener("pointermove", e => this.move(v, e));
    svg.addEventListener("pointerdown", e => this.down(v, e));
    svg.addEventListener("pointerup", e => this.up(v, e));
    svg.addEventListener("pointercancel", () => { this.drag = null; v.rubber.setAttribute("visibility", "hidden"); });
    svg.addEventListener("pointerleave", () => { if (!this.drag) this.leave(); });
    svg.addEventListener("dblclick", () => this.reset());
    for (const g of svg.querySelectorAll(".lg")) {
      if (!this.data.p.some(p => p.s.some(s => s.e === +g.dataset.k))) continue;
      g.setAttribute("role", "button");
      g.setAttribute("tabindex", "0");
      g.setAttribute("aria-pressed", "true");
      const flip = e => { e.preventDefault(); e.stopPropagation(); this.toggle(+g.dataset.k); };
      g.addEventListener("click", flip);
      g.addEventListener("keydown", e => { if (e.key === "Enter" || e.key === " ") flip(e); });
    }
    return v;
  }

  toggle(k) {
    if (!this.hidden.delete(k)) this.hidden.add(k);
    for (const v of this.views) {
      for (const e of v.svg.querySelectorAll(`.s[data-k="${k}"]`)) e.classList.toggle("off", this.hidden.has(k));
      const g = v.svg.querySelector(`.lg[data-k="${k}"]`);
      g.classList.toggle("dim", this.hidden.has(k));
      g.setAttribute("aria-pressed", String(!this.hidden.has(k)));
    }
    this.leave();
  }

  // Pixels of the drawing under the pointer.
  at(v, e) {
    const r = v.svg.getBoundingClientRect(), k = v.svg.viewBox.baseVal.width / r.width;
    return [(e.clientX - r.left) * k, (e.clientY - r.top) * k];
  }

  panelAt(v, x, y) {
    return v.panels.findIndex(p => x >= v.x0 && x <= v.x0 + v.w && y >= p.y0 && y <= p.y0 + p.h);
  }

  X(v, t) { return v.x0 + (t - this.x[0]) / (this.x[1] - this.x[0]) * v.w; }
  Y(v, i, t) { const p = v.panels[i], c = this.y[i]; return p.y0 + (1 - (t - c[0]) / (c[1] - c[0])) * p.h; }

  move(v, e) {
    const [x, y] = this.at(v, e);
    if (this.drag) return this.stretch(v, x, y);
    const i = this.panelAt(v, x, y);
    if (i < 0) return this.leave();
    this.load();
    let best = null, least = 60 * 60;
    this.data.p[i].s.forEach((s, k) => {
      if (this.hidden.has(s.e)) return;
      for (let j = 0; j < s.x.length; j++) {
        const dx = this.X(v, s.x[j]) - x, dy = this.Y(v, i, s.y[j]) - y, d = dx * dx + dy * dy;
        if (d < least && s.x[j] >= this.x[0] && s.x[j] <= this.x[1]) { least = d; best = [k, j]; }
      }
    });
    const heat = this.data.p[i].h;
    if (best && !(heat && least > 144)) return this.show(v, i, best[0], best[1]);
    if (heat) return this.showCell(v, i, x, y);
    this.leave();
  }

  show(v, i, k, j) {
    const p = this.data.p[i], s = p.s[k], x = this.X(v, s.x[j]), y = this.Y(v, i, s.y[j]);
    this.current = [v, i, k, j];
    v.dot.setAttribute("cx", x); v.dot.setAttribute("cy", y); v.dot.setAttribute("visibility", "visible");
    const lines = [[this.data.x.n, number(s.raw[2 * j]) + unit(this.data.x.ul)], [p.y.n, number(s.raw[2 * j + 1]) + unit(p.y.ul)]];
    this.say(v, [s.n, s.st].filter(Boolean).join(", "), lines, x, y);
  }

  showCell(v, i, x, y) {
    const p = this.data.p[i], c = this.y[i], near = (list, w) => { let b = 0; list.forEach((q, j) => { if (Math.abs(q - w) < Math.abs(list[b] - w)) b = j; }); return b; };
    const tx = this.x[0] + (x - v.x0) / v.w * (this.x[1] - this.x[0]);
    const ty = c[0] + (1 - (y - v.panels[i].y0) / v.panels[i].h) * (c[1] - c[0]);
    const a = near(Array.from(p.h.x, q => place(this.data.x, q)), tx), b = near(Array.from(p.h.y, q => place(p.y, q)), ty);
    v.dot.setAttribute("visibility", "hidden");
    const lines = [[this.data.x.n, number(p.h.x[a]) + unit(this.data.x.ul)], [p.y.n, number(p.h.y[b]) + unit(p.y.ul)], [p.h.n, (q => p.h.c ? p.h.c[q] || "" : number(q) + unit(p.h.u))(p.h.v[b * p.h.x.length + a])]];
    this.say(v, "", lines, x, y);
  }

  say(v, head, lines, x, y) {
    const t = this.tip;
    t.replaceChildren();
    const add = (tag, text, to) => { const e = document.createElement(tag); e.textContent = text; to.append(e); return e; };
    if (head) add("b", head, t);
    for (const [name, text] of lines) { const row = add("span", name + " ", t); add("i", text, row); }
    t.hidden = false;
    const r = v.svg.getBoundingClientRect(), o = t.parentElement.getBoundingClientRect(), k = r.width / v.svg.viewBox.baseVal.width;
    const left = x * k + r.left - o.left, top = y * k + r.top - o.top;
    t.style.left = Math.max(0, left + 14 + t.offsetWidth > o.width ? left - t.offsetWidth - 14 : left + 14) + "px";
    t.style.top = Math.max(0, top - t.offsetHeight - 8) + "px";
  }

  leave() {
    this.tip.hidden = true;
    for (const v of this.views) v.dot.setAttribute("visibility", "hidden");
  }

  down(v, e) {
    if (e.button !== 0 || e.target.closest(".lg")) return;
    const [x, y] = this.at(v, e), i = this.panelAt(v, x, y);
    if (i < 0) return;
    this.drag = { i, x, y };
    if (e.isTrusted) v.svg.setPointerCapture(e.pointerId);
  }

  // The rectangle chosen so far; a flat one chooses a range of x only.
  chosen(v, x, y) {
    const d = this.drag, p = v.panels[d.i], clamp = (q, a, b) => Math.min(Math.max(q, a), b);
    const x2 = clamp(x, v.x0, v.x0 + v.w), y2 = clamp(y, p.y0, p.y0 + p.h), flat = Math.abs(y2 - d.y) < 14;
    return [Math.min(d.x, x2), Math.max(d.x, x2), flat ? p.y0 : Math.min(d.y, y2), flat ? p.y0 + p.h : Math.max(d.y, y2), flat];
  }

  stretch(v, x, y) {
    this.leave();
    const [a, b, c, d] = this.chosen(v, x, y);
    for (const [k, q] of [["x", a], ["y", c], ["width", b - a], ["height", d - c], ["visibility", "visible"]]) v.rubber.setAttribute(k, q);
  }

  up(v, e) {
    if (!this.drag) return;
    const [x, y] = this.at(v, e), [a, b, c, d, flat] = this.chosen(v, x, y), i = this.drag.i;
    this.drag = null;
    v.rubber.setAttribute("visibility", "hidden");
    if (b - a < 8) return;
    const p = v.panels[i], tx = q => this.x[0] + (q - v.x0) / v.w * (this.x[1] - this.x[0]);
    const xs = [tx(a), tx(b)], old = this.y[i], ty = q => old[0] + (1 - (q - p.y0) / p.h) * (old[1] - old[0]);
    const ys = [ty(d), ty(c)];
    if (xs[1] - xs[0] < 1e-6 || ys[1] - ys[0] < 1e-6) return;
    this.x = xs;
    if (!flat) this.y[i] = ys;
    this.redraw();
  }

  zoom(factor) {
    const mid = (this.x[0] + this.x[1]) / 2, half = Math.min(0.5, (this.x[1] - this.x[0]) / 2 * factor);
    if (half < 1e-5) return;
    const c = Math.min(Math.max(mid, half), 1 - half);
    this.x = [c - half, c + half];
    if (half >= 0.5) this.reset(); else this.redraw();
  }

  reset() {
    this.unzoomed();
    this.button.hidden = true;
    for (const v of this.views) for (const p of v.panels) {
      if (!p.kept) continue;
      p.gr.innerHTML = p.kept.gr; p.tk.innerHTML = p.kept.tk;
      p.se.forEach((e, k) => e.setAttribute("d", p.kept.se[k]));
      [...p.tf, ...p.tx, ...p.rl].forEach(e => { e.removeAttribute("transform"); e.removeAttribute("visibility"); });
      p.kept = null;
    }
    this.leave();
  }

  redraw() {
    this.load();
    this.leave();
    this.button.hidden = false;
    const ax = this.data.x;
    for (const v of this.views) v.panels.forEach((p, i) => {
      p.kept ||= { gr: p.gr.innerHTML, tk: p.tk.innerHTML, se: p.se.map(e => e.getAttribute("d")) };
      const X = t => this.X(v, t), Y = t => this.Y(v, i, t), ay = this.data.p[i].y;
      const kx = 1 / (this.x[1] - this.x[0]), ky = 1 / (this.y[i][1] - this.y[i][0]);
      const tx = X(0) - kx * v.x0, ty = Y(1) - ky * p.y0;
      p.tf.forEach(e => e.setAttribute("transform", `matrix(${kx} 0 0 ${ky} ${tx} ${ty})`));
      p.tx.forEach(e => { const x = +e.getAttribute("x"), y = +e.getAttribute("y"); e.setAttribute("transform", `translate(${(kx - 1) * x + tx} ${(ky - 1) * y + ty})`); });
      for (const e of p.rl) {
        const along = e.dataset.x !== undefined, q = +(along ? e.dataset.x : e.dataset.y);
        const moved = along ? kx * q + tx : ky * q + ty;
        const inside = along ? moved >= v.x0 && moved <= v.x0 + v.w : moved >= p.y0 && moved <= p.y0 + p.h;
        e.setAttribute("visibility", inside && !e.classList.contains("re") ? "visible" : "hidden");
        e.setAttribute("transform", along ? `translate(${moved - q} 0)` : `translate(0 ${moved - q})`);
      }
      const xt = ticks(ax, value(ax, this.x[0]), value(ax, this.x[1]), Math.max(2, Math.floor(v.w / 80)));
      const yt = ticks(ay, value(ay, this.y[i][0]), value(ay, this.y[i][1]), Math.max(2, Math.floor(p.h / 42)));
      let d = "";
      const labels = [];
      for (const [q, text] of xt) {
        const x = f1(X(place(ax, q)));
        d += `M${x} ${p.y0}v${p.h}`;
        if (i + 1 === v.panels.length) labels.push(el("text", { x, y: p.y0 + p.h + 15, "text-anchor": "middle" }, text));
      }
      for (const [q, text] of yt) {
        const y = Y(place(ay, q));
        d += `M${v.x0} ${f1(y)}h${v.w}`;
        labels.push(el("text", { x: v.x0 - 5, y: f1(y + 4), "text-anchor": "end" }, text));
      }
      p.gr.replaceChildren(el("path", { d }));
      p.tk.replaceChildren(...labels);
      p.se.forEach((e, k) => {
        const s = this.data.p[i].s[k];
        if (s.k === "l") return e.setAttribute("d", linePath(s.x, s.y, X, Y, v.x0, v.x0 + v.w));
        let m = "";
        for (let j = 0; j < s.x.length; j++) {
          const x = X(s.x[j]), y = Y(s.y[j]);
          if (x > v.x0 - 9 && x < v.x0 + v.w + 9 && y > p.y0 - 9 && y < p.y0 + p.h + 9) m += s.k === "d" ? `M${f1(x)} ${f1(y)}h0` : markerPath(s.sh, x, y);
        }
        e.setAttribute("d", m);
      });
    });
  }

  key(e) {
    if (e.target !== this.box) return;
    const done = () => e.preventDefault();
    if (e.key === "+" || e.key === "=") { this.zoom(0.5); return done(); }
    if (e.key === "-") { this.zoom(2); return done(); }
    if (e.key === "0" || e.key === "Escape") { this.reset(); return done(); }
    const steps = { ArrowRight: 1, ArrowLeft: -1, ArrowUp: 0, ArrowDown: 0 };
    if (!(e.key in steps)) return;
    done();
    this.load();
    const v = this.visible();
    let [, i, k, j] = this.current || [v, 0, 0, 0];
    const all = this.data.p.flatMap((p, a) => p.s.map((s, b) => [a, b])).filter(([a, b]) => !this.hidden.has(this.data.p[a].s[b].e));
    if (!all.length) return;
    let n = Math.max(0, all.findIndex(q => q[0] === i && q[1] === k));
    if (!steps[e.key]) n = (n + (e.key === "ArrowDown" ? 1 : all.length - 1)) % all.length;
    [i, k] = all[n];
    const s = this.data.p[i].s[k], jump = e.shiftKey ? 1 : Math.max(1, Math.round(s.x.length / 100));
    j = Math.min(s.x.length - 1, Math.max(0, j + steps[e.key] * jump));
    while (j > 0 && j < s.x.length - 1 && !(isFinite(s.x[j]) && isFinite(s.y[j]))) j += steps[e.key] || 1;
    this.show(v, i, k, j);
  }

  visible() { return this.views.find(v => v.svg.getClientRects().length) || this.views[0]; }

  // Whether the visible drawing shows data.
  drawn() {
    const v = this.visible(), r = v.svg.getBoundingClientRect();
    return r.width > 50 && r.height > 50 && [...v.svg.querySelectorAll(".s, .heat path, .tf path")].some(e => (e.getAttribute("d") || "").length > 3);
  }

  // Runs through zoom, readout, switches and keys.
  exercise() {
    const v = this.visible(), before = v.svg.querySelector("g.p").innerHTML;
    const r = v.svg.getBoundingClientRect(), k = r.width / v.svg.viewBox.baseVal.width, p = v.panels[0];
    const event = (a, b) => ({ button: 0, target: v.svg, clientX: r.left + (v.x0 + a * v.w) * k, clientY: r.top + (p.y0 + b * p.h) * k });
    this.down(v, event(0.2, 0.1));
    this.move(v, event(0.4, 0.5));
    this.up(v, event(0.6, 0.9));
    if (Math.abs(this.x[0] - 0.2) + Math.abs(this.x[1] - 0.6) + Math.abs(this.y[0][0] - 0.1) > 0.01) throw new Error("dragging does not zoom");
    if (v.svg.querySelector("g.p").innerHTML === before) throw new Error("zoom draws nothing new");
    if (/NaN|undefined/.test(v.svg.innerHTML)) throw new Error("zoomed drawing holds NaN");
    for (let a = 0.1; a < 1; a += 0.2) this.move(v, event(a, a));
    for (const key of ["ArrowRight", "ArrowDown", "+", "-", "0"]) this.key({ key, target: this.box, preventDefault() {} });
    const g = v.svg.querySelector(".lg[role]");
    if (g) { this.toggle(+g.dataset.k); this.toggle(+g.dataset.k); }
    this.reset();
    if (v.svg.querySelector("g.p").innerHTML !== before) throw new Error("reset does not restore the drawing");
  }
}

addEventListener("DOMContentLoaded", () => {
  const root = document.documentElement, boxes = [...document.querySelectorAll("figure.fig")];
  const figures = [];
  for (const box of boxes) {
    try { figures.push(new Figure(box)); } catch (e) { errors.push(String(e)); }
  }
  addEventListener("beforeprint", () => document.querySelectorAll("details").forEach(d => { if (!d.open) { d.open = true; d.dataset.print = ""; } }));
  addEventListener("afterprint", () => document.querySelectorAll("details[data-print]").forEach(d => { d.open = false; delete d.dataset.print; }));
  if (location.hash === "#selfcheck") {
    for (const f of figures) { try { f.exercise(); } catch (e) { errors.push(f.box.id + ": " + e); } }
    root.dataset.figures = boxes.length;
    root.dataset.drawn = figures.filter(f => f.drawn()).length;
    root.dataset.overflow = String(root.scrollWidth > innerWidth + 1);
    root.dataset.errors = JSON.stringify(errors);
  }
});
})();
