// A number with a unit, as it is written into a field for the axis of a figure.

import { lengthName } from "../report/numbers";
import { say } from "./dom";

/** Units of one kind, in one of them. */
type Kind = Record<string, number>;

function kinds(): Kind[] {
  const lengths: Kind = { m: 1, mm: 1e-3, "µm": 1e-6, um: 1e-6, nm: 1e-9 };
  for (const u of ["m", "mm", "µm", "nm"]) lengths[lengthName(u)] = lengths[u];
  const speeds: Kind = { rpm: 1, "r/min": 1, "1/min": 1, "об/мин": 1, Hz: 60, "Гц": 60, "rad/s": 30 / Math.PI, "рад/с": 30 / Math.PI };
  speeds[say("rpm")] = 1;
  speeds[say("hertz")] = 60;
  return [speeds, lengths];
}

// the Greek letter and the micro sign look the same
const plain = (u: string): string => u.trim().replaceAll("μ", "µ").replace(/\s+/g, " ");

const factor = (kind: Kind, u: string): number | undefined =>
  Object.hasOwn(kind, u) ? kind[u] : Object.entries(kind).find(([k]) => k.length > 1 && k.toLowerCase() === u.toLowerCase())?.[1];

/** A number as people write it, and what follows it: decimal comma, spaces between digits, a typographic minus. */
export function split(text: string): { number: number; rest: string } | null {
  const tidy = text.trim().replace(/^[\u2212\u2013]\s*/, "-").replace(/(\d)[eE]\u2212/, "$1e-").replace(/(?<=\d)\s(?=\d{3}(?!\d))/g, "").replace(/^([+-])\s+/, "$1");
  const m = /^([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)(?![\d.,])(.*)$/s.exec(tidy);
  if (!m) return null;
  const number = Number(m[1].replace(",", "."));
  return isFinite(number) ? { number, rest: plain(m[2]) } : null;
}

/** A number without a unit. */
export const bare = (text: string): number | null => { const s = split(text); return s && !s.rest ? s.number : null; };

/** The number in the unit of the axis; null where there is none, or where its unit is of another kind. */
export function wanted(text: string, shown: string): number | null {
  const s = split(text), own = plain(shown);
  if (!s) return null;
  if (!s.rest || s.rest === own) return s.number;
  for (const kind of kinds()) {
    const from = factor(kind, s.rest), to = factor(kind, own);
    if (from !== undefined && to !== undefined) return +(s.number * from / to).toPrecision(12);
  }
  return null;
}
