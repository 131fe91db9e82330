// Sliders of values: linear, or logarithmic where the range spans decades.

import { number } from "../report/numbers";

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

/** A value in SI units as text. */
export const plain = (v: number, unit: string): string => unit ? `${number(v)} ${unit}` : number(v);
