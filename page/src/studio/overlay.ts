// Curves of pinned designs over those of the text, on the axes of the figure.

import { place } from "../report/axis";
import type { Figure } from "../report/figure";
import { el, linePath } from "../report/path";
import { Payload, curve } from "../report/payload";

export interface Layer { name: string; data: Payload }

/** Draws the layers, and draws them again when the range of the figure changes. */
export function overlay(f: Figure, layers: Layer[]): void {
  const before = f.redrawn;
  const draw = () => {
    for (const v of f.views) v.panels.forEach((p, i) => {
      p.g.querySelectorAll(".pinned").forEach(e => e.remove());
      const clip = p.se[0]?.closest("[clip-path]")?.getAttribute("clip-path");
      layers.forEach((layer, n) => {
        const panel = layer.data.p[i];
        if (!panel) return;
        const g = el("g", { class: `pinned p${n % 3}`, ...(clip ? { "clip-path": clip } : {}) });
        for (const s of panel.s.filter(s => s.k === "l")) {
          const c = curve(s, layer.data.x, panel.y), n = c.x.length;
          const xs = new Float64Array(n), ys = new Float64Array(n);
          for (let j = 0; j < n; j++) { xs[j] = place(f.data.x, c.raw[2 * j]); ys[j] = place(f.data.p[i].y, c.raw[2 * j + 1]); }
          g.append(el("path", { d: linePath(xs, ys, t => f.X(v, t), t => f.Y(v, i, t), v.x0, v.x0 + v.w) }));
        }
        g.prepend(el("title", {}, layer.name));
        const under = p.se[0]?.closest(".se");
        if (under?.parentNode) under.parentNode.insertBefore(g, under); else p.g.append(g);
      });
    });
  };
  f.redrawn = () => { before(); draw(); };
  draw();
}
