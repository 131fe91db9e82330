// Handles in a figure on what can be pulled: a critical speed, a limit of stability, a peak, a jump.

import { place, value } from "../report/axis";
import type { Figure, View } from "../report/figure";
import { number, unit } from "../report/numbers";
import { el } from "../report/path";
import { follow, steps } from "./drag";
import { say } from "./dom";
import { refocus } from "./focus";
import { staggered } from "./knobs";
import type { Target } from "./types";

export interface Pulled {
  /** A pull begins; false where nothing is released. */
  begin(t: Named): boolean;
  /** Value on the axis, as text, and its unit. */
  move(t: Named, v: number, text: string, unit: string): void;
  end(t: Named, kept: boolean): void;
  /** Chosen without a pull: its value is to be written. */
  pick(t: Named, v: number, unit: string): void;
  /** Value that was wanted last, while the figure may not show it yet. */
  wanted(t: Named): number | null;
}

/** A target that is known again in the next answer. */
export interface Named extends Target { key: string }

/** A handle and its place in a drawing. */
interface Held { t: Named; x: number; y: number; kx: number; ky: number }

const axisOf = (f: Figure, t: Target) => t.along === "x" ? f.data.x : f.data.p[t.panel].y;

export const shownOn = (f: Figure, t: Target, v: number): string => { const ax = axisOf(f, t); return number(v) + unit(ax.ul); };

/** Targets with names that hold from one answer to the next: their kind, and which of its kind. */
export function named(all: Target[]): Named[] {
  const count = new Map<string, number>();
  return all.map(t => {
    const kind = `${t.what} ${t.label} ${t.along}`, n = count.get(kind) ?? 0;
    count.set(kind, n + 1);
    return { ...t, key: `${kind} ${n}` };
  });
}

export function targets(f: Figure, host: HTMLElement, all: Target[], to: Pulled): void {
  const fitting = named(all.filter(t => f.data.p[t.panel] && (t.along === "x" ? t.x : t.y) !== null));
  const before = f.redrawn;
  const draw = () => {
    const active = document.activeElement, focus = active && f.box.contains(active) ? active.getAttribute("data-target") : null;
    for (const v of f.views) {
      v.svg.querySelectorAll(".target").forEach(e => e.remove());
      for (const h of placed(f, v, fitting)) v.svg.append(handle(f, v, host, h, to));
    }
    if (focus) refocus(f.box, focus);
  };
  f.redrawn = () => { before(); draw(); };
  draw();
}

/** Handles in sight: a speed at the axis, whatever the height of its curve; a size at its curve. */
function placed(f: Figure, v: View, all: Named[]): Held[] {
  const out: Held[] = [];
  f.data.p.forEach((q, i) => {
    const p = v.panels[i], right = v.x0 + v.w, bottom = p.y0 + p.h;
    const seen = all.filter(t => t.panel === i).flatMap(t => {
      const x = t.x === null ? right - 8 : f.X(v, place(f.data.x, t.x)), y = t.along === "x" || t.y === null ? bottom : f.Y(v, i, place(q.y, t.y));
      return x >= v.x0 - 1 && x <= right + 1 && y >= p.y0 - 1 && y <= bottom + 1 ? [{ t, x, y, along: t.along }] : [];
    });
    const knobs = staggered(seen, { left: v.x0, right, top: p.y0, bottom });
    seen.forEach(({ t, x, y }, n) => out.push({ t, x, y, kx: knobs[n].x, ky: knobs[n].y }));
  });
  return out;
}

function handle(f: Figure, v: View, host: HTMLElement, { t, x, y, kx, ky }: Held, to: Pulled): SVGGElement {
  const p = v.panels[t.panel], ax = axisOf(f, t), from = (t.along === "x" ? t.x : t.y) ?? 0, shown = shownOn(f, t, from);
  const g = el("g", {
    class: `target ${t.along}`, role: "slider", tabindex: 0, "data-target": t.key, "data-what": t.what,
    "aria-label": say("pull-this", { name: t.label }), "aria-valuenow": from, "aria-valuetext": shown,
  });
  const line = (X: number, Y: number) => t.along === "x" ? `M${X} ${p.y0}v${p.h}` : `M${v.x0} ${Y}h${v.w}`;
  g.append(el("title", {}, `${say("pull-this", { name: t.label })}: ${shown}`));
  // a knob beside its line is joined to it
  const joint = t.along === "x" ? `M${x} ${ky}H${kx}` : `M${kx} ${y}V${ky}`;
  g.append(el("path", { class: "guide", d: line(x, y) + joint }), el("circle", { class: "hit", cx: kx, cy: ky, r: 14 }), el("circle", { class: "knob", cx: kx, cy: ky, r: 6 }));
  g.append(el("path", { class: "arrows", transform: `translate(${kx} ${ky})`, d: t.along === "x" ? "M-7 -3L-10 0L-7 3M7 -3L10 0L7 3" : "M-3 -7L0 -10L3 -7M-3 7L0 10L3 7" }));
  // which of several it is, while it is pointed at
  const left = kx > v.x0 + v.w / 2;
  g.append(el("text", { class: "value", x: kx + (left ? -13 : 13), y: ky - 10, "text-anchor": left ? "end" : "start" }, `${t.label} ${shown}`));
  const ghost = el("path", { class: "ghost", visibility: "hidden" });
  g.append(ghost);

  const at = (place: number) => value(ax, place), start = place(ax, from), range = t.along === "x" ? f.x : f.y[t.panel];
  const inside = (q: number) => Math.min(1, Math.max(0, q));
  const shift = (moved: number) => start + (t.along === "x" ? moved / v.w : -moved / p.h) * (range[1] - range[0]);
  const mark = (q: number) => {
    ghost.setAttribute("d", line(f.X(v, q), f.Y(v, t.panel, q)));
    ghost.setAttribute("visibility", "visible");
  };
  // the readout of the curves would cover its name
  g.addEventListener("pointermove", e => { if (!e.buttons) { e.stopPropagation(); f.leave(); } });
  g.addEventListener("pointerdown", e => {
    // a pull that is refused chooses no range of the figure
    e.stopPropagation();
    const scale = v.svg.viewBox.baseVal.width / v.svg.getBoundingClientRect().width;
    let moved = false;
    follow(host, e, {
      begin: () => to.begin(t),
      move: d => {
        const px = (t.along === "x" ? d.dx : d.dy) * scale;
        if (!moved && Math.abs(px) < 2) return;
        moved = true;
        const q = inside(shift(px));
        mark(q);
        to.move(t, at(q), shownOn(f, t, at(q)), ax.ul);
      },
      end: kept => {
        ghost.setAttribute("visibility", "hidden");
        to.end(t, kept && moved);
        if (kept && !moved) to.pick(t, from, ax.ul);
      },
    });
  });
  g.addEventListener("keydown", e => {
    if (e.key === "Enter" && to.begin(t)) { e.preventDefault(); return to.pick(t, from, ax.ul); }
    const by = steps(e);
    if (!by) return;
    e.preventDefault();
    e.stopPropagation();
    const last = to.wanted(t);
    if (!to.begin(t)) return;
    // a hundredth of what is seen, from what was wanted last: figures follow later than keys
    const q = inside((last === null ? start : place(ax, last)) + by / 100 * (range[1] - range[0]));
    to.move(t, at(q), shownOn(f, t, at(q)), ax.ul);
    to.end(t, true);
  });
  return g;
}
