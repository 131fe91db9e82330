// Runs through everything a reader can do with a figure; for the test that opens the report.

import type { Figure, Pointed } from "./figure";

/** Whether the visible drawing shows data. */
export function drawn(f: Figure): boolean {
  const v = f.visible(), r = v.svg.getBoundingClientRect();
  return r.width > 50 && r.height > 50 && [...v.svg.querySelectorAll(".s, .heat path, .tf path")].some(e => (e.getAttribute("d") || "").length > 3);
}

/** Zoom, readout, switches and keys. */
export function exercise(f: Figure): void {
  const v = f.visible(), before = v.svg.querySelector("g.p")!.innerHTML;
  const r = v.svg.getBoundingClientRect(), k = r.width / v.svg.viewBox.baseVal.width, p = v.panels[0];
  const event = (a: number, b: number): Pointed =>
    ({ button: 0, target: v.svg, clientX: r.left + (v.x0 + a * v.w) * k, clientY: r.top + (p.y0 + b * p.h) * k });
  f.down(v, event(0.2, 0.1));
  f.move(v, event(0.4, 0.5));
  f.up(v, event(0.6, 0.9));
  if (Math.abs(f.x[0] - 0.2) + Math.abs(f.x[1] - 0.6) + Math.abs(f.y[0][0] - 0.1) > 0.01) throw new Error("dragging does not zoom");
  if (v.svg.querySelector("g.p")!.innerHTML === before) throw new Error("zoom draws nothing new");
  if (/NaN|undefined/.test(v.svg.innerHTML)) throw new Error("zoomed drawing holds NaN");
  for (let a = 0.1; a < 1; a += 0.2) f.move(v, event(a, a));
  for (const key of ["ArrowRight", "ArrowDown", "+", "-", "0"]) f.key({ key, target: f.box, preventDefault() {} });
  const g = v.svg.querySelector<SVGGElement>(".lg[role]");
  if (g) { f.toggle(+g.dataset.k!); f.toggle(+g.dataset.k!); }
  f.reset();
  if (v.svg.querySelector("g.p")!.innerHTML !== before) throw new Error("reset does not restore the drawing");
}
