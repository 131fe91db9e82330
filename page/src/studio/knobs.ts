// Places of the knobs of handles: speeds on the axis, sizes at the curve, none on another.

export interface Knob { x: number; y: number; along: "x" | "y" }
/** Edges of the panel that knobs stay inside. */
export interface Area { left: number; right: number; top: number; bottom: number }

/** Least distance of two knobs, in pixels of the drawing: a narrow screen draws them a little smaller. */
export const GAP = 30;

/** Steps away from the wanted place, the nearest first. */
const AWAY = Array.from({ length: 41 }, (_, n) => (n % 2 ? 1 : -1) * Math.ceil(n / 2));
const UP = AWAY.filter(n => n >= 0);

/**
 * Moves knobs along their guide lines until each can be grasped: speeds up from the axis, sizes to the sides of the curve. Where a line is full they stand beside it.
 * Speeds come first, since they belong on the axis.
 */
export function staggered(wanted: Knob[], area: Area): { x: number; y: number }[] {
  const placed: { x: number; y: number }[] = [], out: { x: number; y: number }[] = new Array(wanted.length);
  const free = (p: { x: number; y: number }) => placed.every(q => Math.hypot(p.x - q.x, p.y - q.y) >= GAP - 1e-9);
  const inside = (p: { x: number; y: number }) => p.x >= area.left - 1 && p.x <= area.right + 1 && p.y >= area.top - 1 && p.y <= area.bottom + 1;
  const order = wanted.map((_, i) => i).sort((a, b) => wanted[a].along.localeCompare(wanted[b].along) || wanted[a].x - wanted[b].x);
  for (const i of order) {
    const k = wanted[i];
    const tries = k.along === "x"
      ? AWAY.flatMap(beside => UP.map(n => ({ x: k.x + beside * GAP, y: k.y - n * GAP })))
      : AWAY.flatMap(beside => AWAY.map(n => ({ x: k.x + n * GAP, y: k.y + beside * GAP })));
    out[i] = tries.find(p => inside(p) && free(p)) ?? { x: k.x, y: k.y };
    placed.push(out[i]);
  }
  return out;
}
