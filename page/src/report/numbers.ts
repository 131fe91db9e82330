// Numbers and units as the language of the page writes them.

const SUP = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** The language of the page stands in the attributes of its `head`. */
const language = (): DOMStringMap => document.head.dataset;

export const power = (d: number): string =>
  d === 0 ? "1" : d === 1 ? "10" : "10" + String(d).replace(/-/, "⁻").replace(/\d/g, c => SUP[+c]);

export const decimal = (): string => language().decimal || ".";
export const minus = (s: string): string => s.replace(/^-/, "−").replace(".", decimal());
export const unit = (u: string): string => u ? " " + u : "";

export function number(v: number): string {
  if (!isFinite(v)) return "–";
  const a = Math.abs(v);
  if (a !== 0 && (a >= 1e6 || a < 1e-4)) {
    const [m, e] = v.toExponential(4).split("e");
    return minus(String(+m)) + "·" + power(+e);
  }
  return minus(String(+v.toPrecision(5)));
}

// Logarithmic lengths: each tick with its own prefix, 100 µm, 1 mm.
const LENGTHS: [number, string][] = [[0, "m"], [-3, "mm"], [-6, "µm"], [-9, "nm"]];
export const lengthName = (u: string): string =>
  (language().lengths || "m mm µm nm").split(" ")[LENGTHS.findIndex(l => l[1] === u)] || u;
export const lengthPower = (u: string): number | null => LENGTHS.find(l => l[1] === u)?.[0] ?? null;
export const lengthUnit = (d: number): [number, string] => LENGTHS.find(l => d >= l[0]) || LENGTHS[3];
export const powers = (m: number, d: number): string =>
  d > 1 || d < 0 ? (m > 1 ? m + "·" : "") + power(d) : String(m * Math.pow(10, d));

export function length(m: number, d: number): string {
  const [p, u] = lengthUnit(d), r = d - p;
  return minus(r >= -3 && r <= 5 ? (m * Math.pow(10, r)).toFixed(Math.max(0, -r)) : powers(m, r)) + " " + lengthName(u);
}

/** Coordinates of a drawing to a tenth of a pixel. */
export const f1 = (v: number): string => String(Math.round(v * 10) / 10);

/** Single-precision numbers from base64. */
export function floats(text: string): Float32Array {
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return new Float32Array(bytes.buffer);
}
