// Sliders of values: linear, or logarithmic where the range spans decades.

import { number } from "../report/numbers";
import type { Parameter } from "./types";

const STEPS = 1000;

const bent = (low: number, high: number): boolean => low > 0 && high / low > 20;

export function toSlider(v: number, low: number, high: number): number {
  if (!(high > low)) return 0;
  const t = bent(low, high) ? Math.log(Math.max(v, low) / low) / Math.log(high / low) : (v - low) / (high - low);
  return Math.round(STEPS * Math.min(1, Math.max(0, t)));
}

export function fromSlider(k: number, low: number, high: number): number {
  const t = k / STEPS;
  const v = bent(low, high) ? low * Math.pow(high / low, t) : low + t * (high - low);
  // no digits finer than a step of the slider
  const fine = bent(low, high) ? v * Math.log(high / low) / STEPS : (high - low) / STEPS;
  const p = Math.pow(10, Math.floor(Math.log10(Math.max(fine, 1e-300))));
  return k === 0 ? low : k === STEPS ? high : +(Math.round(v / p) * p).toPrecision(12);
}

/** Units in which the file writes a parameter: their name, and how many make one SI unit. */
export function written(p: Parameter): { unit: string; factor: number } {
  const n = parseFloat(p.shown.replace(",", "."));
  // a default is not written: its text is rounded
  if (p.from === null || !isFinite(n) || n === 0 || p.value === 0) return { unit: p.unit, factor: 1 };
  return { unit: p.display_unit ?? p.unit, factor: +(n / p.value).toPrecision(9) };
}

/** A value in SI units as text. */
export const plain = (v: number, unit: string): string => unit ? `${number(v)} ${unit}` : number(v);

/** A value of a parameter as text, in the units of the file. */
export function inFile(p: Parameter | undefined, v: number): string {
  if (!p) return number(v);
  const { unit, factor } = written(p);
  return plain(+(v * factor).toPrecision(5), unit);
}
