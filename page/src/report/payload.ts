// The numbers behind a drawing, as the page embeds them.

import { Axis, place } from "./axis";
import { floats } from "./numbers";

export interface Series {
  /** Name, state, kind (line, marker, dot), shape, entry of the legend. */
  n: string;
  st: string;
  k: "l" | "m" | "d";
  sh: number;
  e: number;
  /** Pairs of values, packed. */
  d: string;
}

export interface Heat {
  x: string;
  y: string;
  v: string;
  n: string;
  u: string;
  /** Names of the classes, where colours stand for classes. */
  c?: string[];
}

export interface Payload {
  x: Axis;
  p: { y: Axis; s: Series[]; h: Heat | null }[];
}

/** A curve with its places 0..1 on both axes. */
export interface Curve {
  x: Float64Array;
  y: Float64Array;
  raw: Float32Array;
}

export interface Grid {
  x: Float32Array;
  y: Float32Array;
  v: Float32Array;
}

export function curve(s: Series, x: Axis, y: Axis): Curve {
  const raw = floats(s.d), n = raw.length / 2, out = { x: new Float64Array(n), y: new Float64Array(n), raw };
  for (let i = 0; i < n; i++) { out.x[i] = place(x, raw[2 * i]); out.y[i] = place(y, raw[2 * i + 1]); }
  return out;
}

export const grid = (h: Heat): Grid => ({ x: floats(h.x), y: floats(h.y), v: floats(h.v) });
