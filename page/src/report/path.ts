// Path data of curves and markers in pixels.

import { f1 } from "./numbers";

type Place = (t: number) => number;

/** Path of a curve; points in one pixel column become first, lowest, highest, last. */
export function linePath(xs: ArrayLike<number>, ys: ArrayLike<number>, X: Place, Y: Place, x0: number, x1: number): string {
  let d = "", pen = "M";
  const n = xs.length;
  const put = (i: number) => {
    if (!isFinite(X(xs[i])) || !isFinite(Y(ys[i]))) { pen = "M"; return; }
    d += pen + f1(X(xs[i])) + " " + f1(Math.max(-2e4, Math.min(2e4, Y(ys[i]))));
    pen = "L";
  };
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

/** Outline of a marker: circle, square, triangles, diamond; an arrow from 1000 on, its direction in degrees. */
export function markerPath(shape: number, x: number, y: number): string {
  if (shape >= 1000) {
    const w = (shape - 1000) * Math.PI / 180, S = Math.sin(w), C = Math.cos(w);
    const at = (a: number, b: number) => f1(x + a * C + b * S) + " " + f1(y - a * S + b * C);
    return "M" + at(7, 0) + "L" + at(-5, 5) + "L" + at(-5, -5) + "z";
  }
  const r = shape >= 20 ? 2.4 : shape >= 10 ? 5.6 - (shape - 10) : 4.2;
  const M = (a: number, b: number) => "M" + f1(a) + " " + f1(b), L = (a: number, b: number) => "L" + f1(a) + " " + f1(b);
  switch (shape % 5) {
    case 0: return `${M(x - r, y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0z`;
    case 1: return M(x - .88 * r, y - .88 * r) + `h${1.76 * r}v${1.76 * r}h${-1.76 * r}z`;
    case 2: return M(x, y - 1.15 * r) + L(x + 1.1 * r, y + 0.8 * r) + L(x - 1.1 * r, y + 0.8 * r) + "z";
    case 3: return M(x, y - 1.25 * r) + L(x + 1.25 * r, y) + L(x, y + 1.25 * r) + L(x - 1.25 * r, y) + "z";
    default: return M(x - 1.1 * r, y - 0.8 * r) + L(x + 1.1 * r, y - 0.8 * r) + L(x, y + 1.15 * r) + "z";
  }
}

export const NS = "http://www.w3.org/2000/svg";

export function el<K extends keyof SVGElementTagNameMap>(name: K, attributes: Record<string, string | number>, text?: string): SVGElementTagNameMap[K] {
  const e = document.createElementNS(NS, name);
  for (const k in attributes) e.setAttribute(k, String(attributes[k]));
  if (text !== undefined) e.textContent = text;
  return e;
}
