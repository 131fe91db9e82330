// Draws a figure anew for the range that was chosen.

import { place } from "./axis";
import type { Figure } from "./figure";
import { f1 } from "./numbers";
import { el, linePath, markerPath } from "./path";

/** First and last place of an axis that are shown. */
export type Extent = [number, number];

export function redraw(f: Figure): void {
  const ax = f.data.x;
  for (const v of f.views) v.panels.forEach((p, i) => {
    p.kept ||= { gr: p.gr.innerHTML, tk: p.tk.innerHTML, se: p.se.map(e => e.getAttribute("d")) };
    const X = (t: number) => f.X(v, t), Y = (t: number) => f.Y(v, i, t), ay = f.data.p[i].y;
    const kx = 1 / (f.x[1] - f.x[0]), ky = 1 / (f.y[i][1] - f.y[i][0]);
    const tx = X(0) - kx * v.x0, ty = Y(1) - ky * p.y0;
    p.tf.forEach(e => e.setAttribute("transform", `matrix(${kx} 0 0 ${ky} ${tx} ${ty})`));
    p.tx.forEach(e => {
      const x = +e.getAttribute("x")!, y = +e.getAttribute("y")!;
      e.setAttribute("transform", `translate(${(kx - 1) * x + tx} ${(ky - 1) * y + ty})`);
    });
    for (const e of p.rl) {
      const along = e.dataset.x !== undefined, q = +(along ? e.dataset.x! : e.dataset.y!);
      const moved = along ? kx * q + tx : ky * q + ty;
      const inside = along ? moved >= v.x0 && moved <= v.x0 + v.w : moved >= p.y0 && moved <= p.y0 + p.h;
      e.setAttribute("visibility", inside && !e.classList.contains("re") ? "visible" : "hidden");
      e.setAttribute("transform", along ? `translate(${moved - q} 0)` : `translate(0 ${moved - q})`);
    }
    const t = f.ticks(v, i), labels: SVGTextElement[] = [];
    let d = "";
    for (const [q, text] of t.x) {
      const x = f1(X(place(ax, q)));
      d += `M${x} ${p.y0}v${p.h}`;
      if (i + 1 === v.panels.length) labels.push(el("text", { x, y: p.y0 + p.h + 15, "text-anchor": "middle" }, text));
    }
    for (const [q, text] of t.y) {
      const y = Y(place(ay, q));
      d += `M${v.x0} ${f1(y)}h${v.w}`;
      labels.push(el("text", { x: v.x0 - 5, y: f1(y + 4), "text-anchor": "end" }, text));
    }
    p.gr.replaceChildren(el("path", { d }));
    p.tk.replaceChildren(...labels);
    p.se.forEach((e, k) => {
      const s = f.data.p[i].s[k], c = f.of(i)[k];
      if (s.k === "l") return e.setAttribute("d", linePath(c.x, c.y, X, Y, v.x0, v.x0 + v.w));
      let m = "";
      for (let j = 0; j < c.x.length; j++) {
        const x = X(c.x[j]), y = Y(c.y[j]);
        if (x > v.x0 - 9 && x < v.x0 + v.w + 9 && y > p.y0 - 9 && y < p.y0 + p.h + 9) m += s.k === "d" ? `M${f1(x)} ${f1(y)}h0` : markerPath(s.sh, x, y);
      }
      e.setAttribute("d", m);
    });
  });
}
