// Whether anything of the curves lies in a range of places.

import type { Extent } from "./redraw";

export interface Line { x: ArrayLike<number>; y: ArrayLike<number>; joined: boolean }

/** Whether a straight piece passes through a rectangle (Liang and Barsky). */
export function passes(x0: number, y0: number, x1: number, y1: number, [a, b]: Extent, [c, d]: Extent): boolean {
  let from = 0, to = 1;
  for (const [by, room] of [[x0 - x1, x0 - a], [x1 - x0, b - x0], [y0 - y1, y0 - c], [y1 - y0, d - y0]]) {
    if (by === 0) { if (room < 0) return false; continue; }
    const t = room / by;
    if (by < 0) from = Math.max(from, t); else to = Math.min(to, t);
    if (from > to) return false;
  }
  return true;
}

/** Points and, of a joined curve, the pieces between them. */
export function inside(c: Line, x: Extent, y: Extent): boolean {
  for (let i = 0; i < c.x.length; i++) {
    if (!isFinite(c.x[i]) || !isFinite(c.y[i])) continue;
    const j = c.joined && i > 0 && isFinite(c.x[i - 1]) && isFinite(c.y[i - 1]) ? i - 1 : i;
    if (passes(c.x[j], c.y[j], c.x[i], c.y[i], x, y)) return true;
  }
  return false;
}
