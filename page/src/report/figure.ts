// A drawing with readout, zoom and legend switches. It is complete without them.

import { place, ticks, value } from "./axis";
import { inside } from "./inside";
import { Extent, redraw } from "./redraw";
import { number, unit } from "./numbers";
import { el } from "./path";
import { Curve, Grid, Payload, curve, grid } from "./payload";

export interface PanelView {
  g: SVGGElement;
  y0: number;
  h: number;
  gr: Element;
  tk: Element;
  tf: Element[];
  se: Element[];
  tx: Element[];
  rl: HTMLElement[];
  kept: { gr: string; tk: string; se: (string | null)[] } | null;
}

/** One of the drawings of a figure: for wide and for narrow screens. */
export interface View {
  svg: SVGSVGElement;
  x0: number;
  w: number;
  panels: PanelView[];
  dot: SVGCircleElement;
  rubber: SVGRectElement;
}

/** A pointer over a drawing, as far as it is read here. */
export interface Pointed {
  button: number;
  target: EventTarget | null;
  clientX: number;
  clientY: number;
  pointerId?: number;
  isTrusted?: boolean;
}

/** A key, as far as it is read here. */
export interface Pressed {
  key: string;
  target: EventTarget | null;
  shiftKey?: boolean;
  preventDefault(): void;
}

/** What a reader chose in a figure: range in values of the axes, curves switched off. */
export interface Chosen {
  x: [number, number] | null;
  y: ([number, number] | null)[];
  hidden: number[];
}

export class Figure {
  readonly data: Payload;
  readonly views: View[];
  x: Extent = [0, 1];
  y: Extent[] = [];
  private readonly tip: HTMLElement;
  private readonly button: HTMLButtonElement;
  private readonly hidden = new Set<number>();
  private drag: { i: number; x: number; y: number } | null = null;
  private current: [View, number, number, number] | null = null;
  private curves: Curve[][] | null = null;
  private grids: (Grid | null)[] = [];

  constructor(readonly box: HTMLElement) {
    this.data = JSON.parse(box.querySelector("script")!.textContent!) as Payload;
    this.tip = box.querySelector(".tip")!;
    this.views = [...box.querySelectorAll<SVGSVGElement>(".plot > svg")].map(svg => this.prepare(svg));
    this.button = box.querySelector("button")!;
    this.button.addEventListener("click", () => this.reset());
    box.addEventListener("keydown", e => this.key(e));
    box.addEventListener("blur", () => this.leave());
    this.unzoomed();
  }

  private unzoomed(): void {
    this.x = [0, 1];
    this.y = this.data.p.map((): Extent => [0, 1]);
  }

  /** Curves of a panel, unpacked when they are first needed. */
  of(i: number): Curve[] {
    return this.load()[i];
  }

  private load(): Curve[][] {
    this.curves ??= this.data.p.map(p => {
      this.grids.push(p.h ? grid(p.h) : null);
      return p.s.map(s => curve(s, this.data.x, p.y));
    });
    return this.curves;
  }

  private prepare(svg: SVGSVGElement): View {
    const all = (g: Element, s: string) => [...g.querySelectorAll<HTMLElement>(s)];
    const v: View = {
      svg, x0: +svg.dataset.x!, w: +svg.dataset.w!,
      panels: [...svg.querySelectorAll<SVGGElement>(".p")].map(g => ({
        g, y0: +g.dataset.y!, h: +g.dataset.h!,
        gr: g.querySelector(".gr")!, tk: g.querySelector(".tk")!, tf: all(g, ".tf"),
        se: all(g, ".se > .s"), tx: all(g, ".tx > text"), rl: all(g, ".rl"),
        kept: null,
      })),
      dot: el("circle", { class: "dot", r: 4.5, visibility: "hidden" }),
      rubber: el("rect", { class: "rubber", visibility: "hidden" }),
    };
    svg.append(v.rubber, v.dot);
    svg.setAttribute("role", "group");
    svg.addEventListener("pointermove", e => this.move(v, e));
    svg.addEventListener("pointerdown", e => this.down(v, e));
    svg.addEventListener("pointerup", e => this.up(v, e));
    svg.addEventListener("pointercancel", () => { this.drag = null; v.rubber.setAttribute("visibility", "hidden"); });
    svg.addEventListener("pointerleave", () => { if (!this.drag) this.leave(); });
    svg.addEventListener("dblclick", () => this.reset());
    for (const g of svg.querySelectorAll<SVGGElement>(".lg")) {
      const k = +g.dataset.k!;
      if (!this.data.p.some(p => p.s.some(s => s.e === k))) continue;
      g.setAttribute("role", "button");
      g.setAttribute("tabindex", "0");
      g.setAttribute("aria-pressed", "true");
      const flip = (e: Event) => { e.preventDefault(); e.stopPropagation(); this.toggle(k); };
      g.addEventListener("click", flip);
      g.addEventListener("keydown", e => { if (e.key === "Enter" || e.key === " ") flip(e); });
    }
    return v;
  }

  toggle(k: number): void {
    if (!this.hidden.delete(k)) this.hidden.add(k);
    const off = this.hidden.has(k);
    for (const v of this.views) {
      for (const e of v.svg.querySelectorAll(`.s[data-k="${k}"]`)) e.classList.toggle("off", off);
      const g = v.svg.querySelector(`.lg[data-k="${k}"]`);
      g?.classList.toggle("dim", off);
      g?.setAttribute("aria-pressed", String(!off));
    }
    this.leave();
  }

  /** Pixels of the drawing under the pointer. */
  at(v: View, e: Pointed): [number, number] {
    const r = v.svg.getBoundingClientRect(), k = v.svg.viewBox.baseVal.width / r.width;
    return [(e.clientX - r.left) * k, (e.clientY - r.top) * k];
  }

  panelAt(v: View, x: number, y: number): number {
    return v.panels.findIndex(p => x >= v.x0 && x <= v.x0 + v.w && y >= p.y0 && y <= p.y0 + p.h);
  }

  /** Pixel of a place on an axis, and back. */
  X(v: View, t: number): number { return v.x0 + (t - this.x[0]) / (this.x[1] - this.x[0]) * v.w; }
  Y(v: View, i: number, t: number): number {
    const p = v.panels[i], c = this.y[i];
    return p.y0 + (1 - (t - c[0]) / (c[1] - c[0])) * p.h;
  }
  tx(v: View, x: number): number { return this.x[0] + (x - v.x0) / v.w * (this.x[1] - this.x[0]); }
  ty(v: View, i: number, y: number): number {
    const p = v.panels[i], c = this.y[i];
    return c[0] + (1 - (y - p.y0) / p.h) * (c[1] - c[0]);
  }

  move(v: View, e: Pointed): void {
    const [x, y] = this.at(v, e);
    if (this.drag) return this.stretch(v, x, y);
    const i = this.panelAt(v, x, y);
    if (i < 0) return this.leave();
    let best: [number, number] | null = null, least = 60 * 60;
    this.of(i).forEach((s, k) => {
      if (this.hidden.has(this.data.p[i].s[k].e)) return;
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

  private show(v: View, i: number, k: number, j: number): void {
    const p = this.data.p[i], s = p.s[k], c = this.of(i)[k], x = this.X(v, c.x[j]), y = this.Y(v, i, c.y[j]);
    this.current = [v, i, k, j];
    v.dot.setAttribute("cx", String(x)); v.dot.setAttribute("cy", String(y)); v.dot.setAttribute("visibility", "visible");
    this.say(v, [s.n, s.st].filter(Boolean).join(", "), [
      [this.data.x.n, number(c.raw[2 * j]) + unit(this.data.x.ul)], [p.y.n, number(c.raw[2 * j + 1]) + unit(p.y.ul)],
    ], x, y);
  }

  private showCell(v: View, i: number, x: number, y: number): void {
    const p = this.data.p[i], heat = p.h, g = (this.load(), this.grids[i]);
    if (!heat || !g) return;
    const near = (list: number[], w: number) => { let b = 0; list.forEach((q, j) => { if (Math.abs(q - w) < Math.abs(list[b] - w)) b = j; }); return b; };
    const a = near(Array.from(g.x, q => place(this.data.x, q)), this.tx(v, x)), b = near(Array.from(g.y, q => place(p.y, q)), this.ty(v, i, y));
    const q = g.v[b * g.x.length + a];
    v.dot.setAttribute("visibility", "hidden");
    this.say(v, "", [
      [this.data.x.n, number(g.x[a]) + unit(this.data.x.ul)], [p.y.n, number(g.y[b]) + unit(p.y.ul)],
      [heat.n, heat.c ? heat.c[q] || "" : number(q) + unit(heat.u)],
    ], x, y);
  }

  private say(v: View, head: string, lines: [string, string][], x: number, y: number): void {
    const t = this.tip;
    t.replaceChildren();
    const add = (tag: string, text: string, to: HTMLElement) => { const e = document.createElement(tag); e.textContent = text; to.append(e); return e; };
    if (head) add("b", head, t);
    for (const [name, text] of lines) { const row = add("span", name + " ", t); add("i", text, row); }
    t.hidden = false;
    const r = v.svg.getBoundingClientRect(), o = t.parentElement!.getBoundingClientRect(), k = r.width / v.svg.viewBox.baseVal.width;
    const left = x * k + r.left - o.left, top = y * k + r.top - o.top;
    t.style.left = Math.max(0, left + 14 + t.offsetWidth > o.width ? left - t.offsetWidth - 14 : left + 14) + "px";
    t.style.top = Math.max(0, top - t.offsetHeight - 8) + "px";
  }

  leave(): void {
    this.tip.hidden = true;
    for (const v of this.views) v.dot.setAttribute("visibility", "hidden");
  }

  down(v: View, e: Pointed): void {
    if (e.button !== 0 || (e.target as Element).closest(".lg")) return;
    // a press just beside the axis begins at the axis
    const [px, y] = this.at(v, e), x = Math.min(Math.max(px, px > v.x0 - 8 ? v.x0 : px), px < v.x0 + v.w + 8 ? v.x0 + v.w : px), i = this.panelAt(v, x, y);
    if (i < 0) return;
    this.drag = { i, x, y };
    if (e.isTrusted && e.pointerId !== undefined) v.svg.setPointerCapture(e.pointerId);
  }

  /** The rectangle chosen so far; a flat one chooses a range of x only. */
  private chosen(v: View, d: { i: number; x: number; y: number }, x: number, y: number): [number, number, number, number, boolean] {
    const p = v.panels[d.i], clamp = (q: number, a: number, b: number) => Math.min(Math.max(q, a), b);
    const x2 = clamp(x, v.x0, v.x0 + v.w), y2 = clamp(y, p.y0, p.y0 + p.h), flat = Math.abs(y2 - d.y) < 14;
    return [Math.min(d.x, x2), Math.max(d.x, x2), flat ? p.y0 : Math.min(d.y, y2), flat ? p.y0 + p.h : Math.max(d.y, y2), flat];
  }

  private stretch(v: View, x: number, y: number): void {
    if (!this.drag) return;
    this.leave();
    const [a, b, c, d] = this.chosen(v, this.drag, x, y);
    for (const [k, q] of [["x", a], ["y", c], ["width", b - a], ["height", d - c], ["visibility", "visible"]] as const) v.rubber.setAttribute(k, String(q));
  }

  up(v: View, e: Pointed): void {
    if (!this.drag) return;
    const i = this.drag.i, [x, y] = this.at(v, e), [a, b, c, d, flat] = this.chosen(v, this.drag, x, y);
    this.drag = null;
    v.rubber.setAttribute("visibility", "hidden");
    if (b - a < 8) return;
    const xs: Extent = [this.tx(v, a), this.tx(v, b)], ys: Extent = [this.ty(v, i, d), this.ty(v, i, c)];
    if (xs[1] - xs[0] < 1e-6 || ys[1] - ys[0] < 1e-6) return;
    this.x = xs;
    if (!flat) this.y[i] = ys;
    this.redraw();
  }

  zoom(factor: number): void {
    const mid = (this.x[0] + this.x[1]) / 2, half = Math.min(0.5, (this.x[1] - this.x[0]) / 2 * factor);
    if (half < 1e-5) return;
    const c = Math.min(Math.max(mid, half), 1 - half);
    this.x = [c - half, c + half];
    if (half >= 0.5) this.reset(); else this.redraw();
  }

  reset(): void {
    this.unzoomed();
    this.button.hidden = true;
    for (const v of this.views) for (const p of v.panels) {
      const kept = p.kept;
      if (!kept) continue;
      p.gr.innerHTML = kept.gr; p.tk.innerHTML = kept.tk;
      p.se.forEach((e, k) => e.setAttribute("d", kept.se[k] || ""));
      [...p.tf, ...p.tx, ...p.rl].forEach(e => { e.removeAttribute("transform"); e.removeAttribute("visibility"); });
      p.kept = null;
    }
    this.leave();
    this.redrawn();
  }

  redraw(): void {
    this.leave();
    this.button.hidden = false;
    redraw(this);
    this.redrawn();
  }

  /** Called after the range changed. */
  redrawn: () => void = () => {};

  /** Range and switches, to be kept when new numbers replace the figure. */
  choice(): Chosen {
    const zoomed = (e: Extent) => e[0] !== 0 || e[1] !== 1;
    const { x, p } = this.data;
    return {
      x: zoomed(this.x) ? [value(x, this.x[0]), value(x, this.x[1])] : null,
      y: this.y.map((c, i) => zoomed(c) ? [value(p[i].y, c[0]), value(p[i].y, c[1])] : null),
      hidden: [...this.hidden],
    };
  }

  choose(c: Chosen): void {
    const known = new Set(this.data.p.flatMap(p => p.s.map(s => s.e)));
    for (const k of c.hidden) if (known.has(k)) this.toggle(k);
    if (!c.x && c.y.every(y => !y)) return;
    if (c.x) this.x = [place(this.data.x, c.x[0]), place(this.data.x, c.x[1])];
    c.y.forEach((y, i) => { if (y && this.data.p[i]) this.y[i] = [place(this.data.p[i].y, y[0]), place(this.data.p[i].y, y[1])]; });
    if ([this.x, ...this.y].some(([a, b]) => !(b - a > 1e-9))) return this.unzoomed();
    if (this.empty()) return this.unzoomed();
    this.redraw();
  }

  /** Nothing of the visible curves lies in the range: none of the figure, or none of a drawing whose own range was chosen. */
  private empty(): boolean {
    const drawn = this.data.p.map((p, i) => {
      const seen = this.of(i).map((c, k) => ({ ...c, joined: p.s[k].k === "l", e: p.s[k].e })).filter(c => !this.hidden.has(c.e));
      if (!seen.length) return null;
      return p.h !== null || seen.some(c => inside(c, this.x, this.y[i]));
    });
    const own = drawn.some((d, i) => d === false && (this.y[i][0] !== 0 || this.y[i][1] !== 1));
    return own || drawn.includes(false) && !drawn.includes(true);
  }

  key(e: Pressed): void {
    if (e.target !== this.box) return;
    const done = () => e.preventDefault();
    if (e.key === "+" || e.key === "=") { this.zoom(0.5); return done(); }
    if (e.key === "-") { this.zoom(2); return done(); }
    if (e.key === "0" || e.key === "Escape") { this.reset(); return done(); }
    const steps: Record<string, number> = { ArrowRight: 1, ArrowLeft: -1, ArrowUp: 0, ArrowDown: 0 };
    if (!(e.key in steps)) return;
    done();
    const by = steps[e.key], v = this.visible();
    let [, i, k, j] = this.current || [v, 0, 0, 0];
    const all = this.data.p.flatMap((p, a) => p.s.map((_, b) => [a, b])).filter(([a, b]) => !this.hidden.has(this.data.p[a].s[b].e));
    if (!all.length) return;
    let n = Math.max(0, all.findIndex(q => q[0] === i && q[1] === k));
    if (!by) n = (n + (e.key === "ArrowDown" ? 1 : all.length - 1)) % all.length;
    [i, k] = all[n];
    const s = this.of(i)[k], jump = e.shiftKey ? 1 : Math.max(1, Math.round(s.x.length / 100));
    j = Math.min(s.x.length - 1, Math.max(0, j + by * jump));
    while (j > 0 && j < s.x.length - 1 && !(isFinite(s.x[j]) && isFinite(s.y[j]))) j += by || 1;
    this.show(v, i, k, j);
  }

  visible(): View { return this.views.find(v => v.svg.getClientRects().length) || this.views[0]; }

  /** Labelled ticks of the range shown. */
  ticks(v: View, i: number): { x: [number, string][]; y: [number, string][] } {
    const ax = this.data.x, ay = this.data.p[i].y;
    return {
      x: ticks(ax, value(ax, this.x[0]), value(ax, this.x[1]), Math.max(2, Math.floor(v.w / 80))),
      y: ticks(ay, value(ay, this.y[i][0]), value(ay, this.y[i][1]), Math.max(2, Math.floor(v.panels[i].h / 42))),
    };
  }
}
