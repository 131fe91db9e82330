// Handles in a figure on what can be pulled: a critical speed, a limit of stability, a peak, a jump.

import { place, value } from "../report/axis";
import type { Figure, View } from "../report/figure";
import { number, unit } from "../report/numbers";
import { el } from "../report/path";
import { follow, steps } from "./drag";
import { say } from "./dom";
import type { Target } from "./types";

export interface Pulled {
  /** A pull begins; false where nothing is released. */
  begin(t: Target): boolean;
  /** Value on the axis, as text, and its unit. */
  move(t: Target, v: number, text: string, unit: string): void;
  end(t: Target, kept: boolean): void;
  /** Chosen without a pull: its value is to be written. */
  pick(t: Target, v: number, unit: string): void;
}

const axisOf = (f: Figure, t: Target) => t.along === "x" ? f.data.x : f.data.p[t.panel].y;

export const shownOn = (f: Figure, t: Target, v: number): string => { const ax = axisOf(f, t); return number(v) + unit(ax.ul); };

export function targets(f: Figure, host: HTMLElement, all: Target[], to: Pulled): void {
  const fitting = all.filter(t => f.data.p[t.panel] && (t.along === "x" ? t.x : t.y) !== null);
  const before = f.redrawn;
  const draw = () => {
    const focus = document.activeElement?.getAttribute("data-target");
    for (const v of f.views) {
      v.svg.querySelectorAll(".target").forEach(e => e.remove());
      fitting.forEach((t, n) => {
        const g = handle(f, v, host, t, n, to);
        if (g) v.svg.append(g);
      });
    }
    if (focus) f.visible().svg.querySelector<SVGElement>(`.target[data-target="${focus}"]`)?.focus();
  };
  f.redrawn = () => { before(); draw(); };
  draw();
}

function handle(f: Figure, v: View, host: HTMLElement, t: Target, n: number, to: Pulled): SVGGElement | null {
  const p = v.panels[t.panel], ay = f.data.p[t.panel].y, ax = axisOf(f, t), from = (t.along === "x" ? t.x : t.y) ?? 0;
  const x = t.x === null ? null : f.X(v, place(f.data.x, t.x)), y = t.y === null ? null : f.Y(v, t.panel, place(ay, t.y));
  if ((x !== null && !(x >= v.x0 - 1 && x <= v.x0 + v.w + 1)) || (y !== null && !(y >= p.y0 - 1 && y <= p.y0 + p.h + 1))) return null;
  const cx = x ?? v.x0 + v.w - 8, cy = y ?? p.y0 + 8, shown = shownOn(f, t, from);
  const g = el("g", {
    class: `target ${t.along}`, role: "slider", tabindex: 0, "data-target": n, "data-what": t.what,
    "aria-label": say("pull-this", { name: t.label }), "aria-valuenow": from, "aria-valuetext": shown,
  });
  const line = t.along === "x" ? `M${cx} ${p.y0}v${p.h}` : `M${v.x0} ${cy}h${v.w}`;
  g.append(el("title", {}, `${say("pull-this", { name: t.label })}: ${shown}`));
  g.append(el("path", { class: "guide", d: line }), el("circle", { class: "hit", cx, cy, r: 14 }), el("circle", { class: "knob", cx, cy, r: 6 }));
  const ghost = el("path", { class: "ghost", visibility: "hidden" });
  g.append(ghost);

  const at = (place: number) => value(ax, place), start = place(ax, from);
  const shift = (moved: number) => t.along === "x" ? start + moved / v.w * (f.x[1] - f.x[0]) : start - moved / p.h * (f.y[t.panel][1] - f.y[t.panel][0]);
  const mark = (q: number) => {
    const X = f.X(v, q), Y = f.Y(v, t.panel, q);
    ghost.setAttribute("d", t.along === "x" ? `M${X} ${p.y0}v${p.h}` : `M${v.x0} ${Y}h${v.w}`);
    ghost.setAttribute("visibility", "visible");
  };
  g.addEventListener("pointerdown", e => {
    const scale = v.svg.viewBox.baseVal.width / v.svg.getBoundingClientRect().width;
    let moved = false;
    follow(host, e, {
      begin: () => to.begin(t),
      move: d => {
        const px = (t.along === "x" ? d.dx : d.dy) * scale;
        if (!moved && Math.abs(px) < 2) return;
        moved = true;
        const q = Math.min(1, Math.max(0, shift(px)));
        mark(q);
        to.move(t, at(q), shownOn(f, t, at(q)), ax.ul);
      },
      end: kept => { ghost.setAttribute("visibility", "hidden"); 
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
    if (!to.begin(t)) return;
    const q = Math.min(1, Math.max(0, start + by / 100));
    to.move(t, at(q), shownOn(f, t, at(q)), ax.ul);
    to.end(t, true);
  });
  return g;
}
