// Axes of a figure: places between 0 and 1, and labelled ticks.

import { length, lengthName, lengthPower, lengthUnit, minus, number, powers, unit } from "./numbers";

/** An axis as the payload of a figure has it. */
export interface Axis {
  /** Value at which a scale of both signs bends from linear to logarithmic; 0 or null on other scales. */
  k: number | null;
  names: [number, string][];
  lo: number;
  hi: number;
  log: boolean;
  /** Power of ten in front of the ticks. */
  e: number;
  /** Label. */
  n: string;
  /** Unit, and as the language writes it. */
  u: string;
  ul: string;
  bare: boolean;
}

const bend = (ax: Axis, v: number): number => Math.asinh(v / (ax.k || 1));

/** Value at a place 0..1 of an axis. */
export const value = (ax: Axis, t: number): number =>
  ax.k ? ax.k * Math.sinh(bend(ax, ax.lo) + t * (bend(ax, ax.hi) - bend(ax, ax.lo)))
    : ax.log ? ax.lo * Math.pow(ax.hi / ax.lo, t) : ax.lo + t * (ax.hi - ax.lo);

/** Place 0..1 of a value on an axis. */
export const place = (ax: Axis, v: number): number =>
  ax.k ? (bend(ax, v) - bend(ax, ax.lo)) / (bend(ax, ax.hi) - bend(ax, ax.lo))
    : ax.log ? (v > 0 ? Math.log(v / ax.lo) / Math.log(ax.hi / ax.lo) : NaN) : (v - ax.lo) / (ax.hi - ax.lo);

function step(span: number, most: number): number {
  const raw = span / Math.max(most, 1), p = Math.pow(10, Math.floor(Math.log10(raw)));
  return [1, 2, 5, 10].map(m => m * p).find(s => s >= raw * (1 - 1e-9)) || 10 * p;
}

export type Tick = [number, string];

/** Labelled ticks of an axis between two values. */
export function ticks(ax: Axis, lo: number, hi: number, most: number): Tick[] {
  if (ax.bare) return [];
  if (ax.names.length) return ax.names.filter(n => n[0] >= lo && n[0] <= hi);
  if (ax.k) {
    const out = bent(ax, ax.k, lo, hi, most);
    if (out.length >= 3) return out;
  }
  const own = ax.log ? lengthPower(ax.u) : null;
  if (ax.log && hi / lo > 8) return decades(lo, hi, most, own);
  return even(ax, lo, hi, most, own);
}

/** Powers of ten on both sides of zero, then their twofold and fivefold where there is room. */
function bent(ax: Axis, k: number, lo: number, hi: number, most: number): Tick[] {
  const out: Tick[] = [], room = 1 / (most + 2);
  const at = (v: number) => (bend(ax, v) - bend(ax, lo)) / (bend(ax, hi) - bend(ax, lo));
  const put = (v: number, room: number) => {
    if (v >= lo && v <= hi && out.every(t => Math.abs(at(t[0]) - at(v)) >= room)) out.push([v, number(v)]);
  };
  const first = Math.ceil(Math.log10(k) - 1e-9), last = Math.floor(Math.log10(Math.max(Math.abs(lo), Math.abs(hi))) + 1e-9);
  put(0, room);
  for (const s of [-1, 1]) for (let d = last; d >= first; d--) put(s * Math.pow(10, d), room);
  for (const m of [2, 5]) for (let d = first; d <= last; d++) for (const s of [1, -1]) put(s * m * Math.pow(10, d), 1.5 * room);
  return out.sort((a, b) => a[0] - b[0]);
}

function decades(lo: number, hi: number, most: number, own: number | null): Tick[] {
  const all: [number, number, number][] = [];
  for (let d = Math.floor(Math.log10(lo)); d <= Math.ceil(Math.log10(hi)); d++)
    for (const m of [1, 2, 5]) all.push([m, d, m * Math.pow(10, d)]);
  let inside = all.filter(t => t[2] >= lo && t[2] <= hi);
  if (inside.length > most + 1) inside = inside.filter(t => t[0] === 1);
  const stride = Math.ceil(inside.length / most), plain = lo >= 0.9e-3 && hi <= 1.2e5;
  return inside.filter((_, i) => i % stride === 0).map(([m, d, v]): Tick =>
    [v, own !== null ? length(m, d + own) : plain ? minus(v.toFixed(Math.max(0, -d))) : powers(m, d)]);
}

function even(ax: Axis, lo: number, hi: number, most: number, own: number | null): Tick[] {
  const inside = (s: number) => Math.floor(hi / s + 1e-6) - Math.ceil(lo / s - 1e-6) + 1;
  let s = step(hi - lo, most);
  if (ax.u === "°" && !ax.log && hi - lo > 80 && !ax.e)
    s = [15, 30, 45, 90, 180].find(q => (hi - lo) / q <= Math.max(most, 2)) || 360 * Math.ceil((hi - lo) / 360 / Math.max(most, 2));
  else
    for (let m = most + 1; inside(s) < 3 && m < most + 6; m++) s = step(hi - lo, m);
  const [p, u]: [number, string] = own === null ? [0, ""] : lengthUnit(Math.floor(Math.log10(hi) + 1e-9) + own);
  const e = own === null ? Math.pow(10, ax.e) : Math.pow(10, p - own), out: Tick[] = [];
  const digits = Math.min(12, Math.max(0, Math.ceil(-Math.log10(s / e) - 1e-9)));
  for (let k = Math.ceil(lo / s - 1e-6); k <= hi / s + 1e-6 && out.length < 60; k++) {
    let label = (k * s / e).toFixed(digits);
    if (+label === 0) label = label.replace("-", "");
    if (ax.log && digits > 4) label = number(k * s / e);
    out.push([k * s, minus(label) + unit(lengthName(u))]);
  }
  return out;
}
