// Solids of revolution as meshes, cut open so that the inside can be seen; each vertex knows how a mode moves it.

import { BufferAttribute, BufferGeometry, ShapeUtils, Vector2 } from "three";
import type { Frames, Shape, Solid, Station } from "./types";

const AROUND = 56;

/** Part of a turn that is drawn of hollow parts. */
const OPEN = 0.75;

/** Whether nothing is hidden inside: a part that reaches the axis everywhere it is drawn. */
const whole = (s: Solid): boolean => s.kind === "shaft" || s.kind === "ball";

interface Mesh { place: number[]; normal: number[]; index: number[] }

/** Pieces of the outline no longer than `most` along the axis, so that a shaft can bend. */
function pieces(outline: [number, number][], most: number): [number, number, number, number][] {
  const out: [number, number, number, number][] = [];
  outline.forEach(([z0, r0], i) => {
    const [z1, r1] = outline[(i + 1) % outline.length], n = Math.max(1, Math.min(80, Math.ceil(Math.abs(z1 - z0) / most)));
    if (r0 === 0 && r1 === 0) return;
    for (let k = 0; k < n; k++) {
      const mix = (t: number): [number, number] => [z0 + (z1 - z0) * t, r0 + (r1 - r0) * t];
      out.push([...mix(k / n), ...mix((k + 1) / n)]);
    }
  });
  return out;
}

const area = (outline: [number, number][]): number =>
  outline.reduce((sum, [z, r], i) => { const [z1, r1] = outline[(i + 1) % outline.length]; return sum + z * r1 - z1 * r; }, 0);

function lateral(m: Mesh, outline: [number, number][], most: number, turn: number): void {
  const n = Math.max(8, Math.ceil(AROUND * turn)), sign = area(outline) >= 0 ? 1 : -1;
  for (const [z0, r0, z1, r1] of pieces(outline, most)) {
    const size = Math.hypot(z1 - z0, r1 - r0) || 1, nz = sign * (r1 - r0) / size, nr = -sign * (z1 - z0) / size;
    const first = m.place.length / 3;
    for (let k = 0; k <= n; k++) {
      const a = 2 * Math.PI * turn * k / n, c = Math.cos(a), s = Math.sin(a);
      m.place.push(r0 * c, r0 * s, z0, r1 * c, r1 * s, z1);
      m.normal.push(nr * c, nr * s, nz, nr * c, nr * s, nz);
      if (k === n) continue;
      const a0 = first + 2 * k;
      // light falls on the side that the order of the corners makes the front
      if (sign > 0) m.index.push(a0, a0 + 1, a0 + 2, a0 + 1, a0 + 3, a0 + 2);
      else m.index.push(a0, a0 + 2, a0 + 1, a0 + 1, a0 + 2, a0 + 3);
    }
  }
}

/** The two faces of the cut. */
function faces(m: Mesh, outline: [number, number][], turn: number): void {
  const flat = outline.map(([z, r]) => new Vector2(z, r)), triangles = ShapeUtils.triangulateShape(flat, []);
  for (const a of [0, 2 * Math.PI * turn]) {
    const c = Math.cos(a), s = Math.sin(a), first = m.place.length / 3, side = a === 0 ? -1 : 1;
    for (const [z, r] of outline) { m.place.push(r * c, r * s, z); m.normal.push(-s * side, c * side, 0); }
    for (const [i, j, k] of triangles) {
      const left = area([outline[i], outline[j], outline[k]]) > 0;
      m.index.push(first + i, ...(left === (side > 0) ? [first + j, first + k] : [first + k, first + j]));
    }
  }
}

/** Mesh of a solid; `size` is the length of the machine, m. */
export function mesh(s: Solid, size: number): BufferGeometry {
  const m: Mesh = { place: [], normal: [], index: [] }, turn = whole(s) ? 1 : OPEN;
  lateral(m, s.outline, size / 40, turn);
  if (turn < 1) faces(m, s.outline, turn);
  for (let i = 0; i < m.place.length; i += 3) { m.place[i] += s.at[0]; m.place[i + 1] += s.at[1]; }
  const g = new BufferGeometry();
  g.setAttribute("position", new BufferAttribute(new Float32Array(m.place), 3));
  g.setAttribute("normal", new BufferAttribute(new Float32Array(m.normal), 3));
  g.setAttribute("whirl", new BufferAttribute(new Float32Array(m.place.length / 3 * 4), 4));
  g.setIndex(m.index);
  return g;
}

type Moved = [number, number, number, number];

/** Displacement of a body at a height: real and imaginary part of x, then of y. */
export function moved(stations: Station[], z: number): Moved {
  const flat = (s: Station): Moved => [s.x[0], s.x[1], s.y[0], s.y[1]];
  if (!stations.length) return [0, 0, 0, 0];
  if (stations.length === 1) return flat(stations[0]);
  let i = 0;
  while (i < stations.length - 2 && stations[i + 1].z < z) i++;
  const a = stations[i], b = stations[i + 1], t = b.z === a.z ? 0 : (z - a.z) / (b.z - a.z);
  const p = flat(a), q = flat(b);
  return [0, 1, 2, 3].map(k => p[k] + t * (q[k] - p[k])) as Moved;
}

export const stationsOf = (shape: Shape, body: string | null): Station[] =>
  body === null ? [] : shape.stations.filter(s => s.body === body).sort((a, b) => a.z - b.z);

/** Places along the axis that vertices have, and which one each has. */
interface Levels { places: number[]; of: Uint32Array }

function levels(g: BufferGeometry): Levels {
  const known = g.userData.levels as Levels | undefined;
  if (known) return known;
  const place = g.getAttribute("position") as BufferAttribute, seen = new Map<number, number>(), of = new Uint32Array(place.count);
  for (let i = 0; i < place.count; i++) {
    const z = place.getZ(i), n = seen.get(z) ?? seen.size;
    seen.set(z, n);
    of[i] = n;
  }
  return g.userData.levels = { places: [...seen.keys()], of };
}

/** Writes the motion of a mode, or of two frames, into the vertices of a solid. */
export function whirl(g: BufferGeometry, stations: Station[]): void {
  const to = g.getAttribute("whirl") as BufferAttribute, out = to.array, { places, of } = levels(g), all = places.map(z => moved(stations, z));
  for (let i = 0; i < of.length; i++) {
    const m = all[of[i]];
    out[4 * i] = m[0]; out[4 * i + 1] = m[1]; out[4 * i + 2] = m[2]; out[4 * i + 3] = m[3];
  }
  to.needsUpdate = true;
}

/** Two frames one after the other in place of real and imaginary part: between them the motion is straight. */
export const between = (frames: Frames, body: string | null, k: number): Station[] =>
  frames.paths.filter(p => p.body === body).sort((a, b) => a.z - b.z)
    .map(p => ({ body: p.body, z: p.z, x: [p.x[k] ?? 0, p.x[k + 1] ?? 0], y: [p.y[k] ?? 0, p.y[k + 1] ?? 0] }));

/** Largest displacement of a mode. */
export const largest = (shape: Shape): number =>
  shape.size ?? shape.stations.reduce((most, s) => Math.max(most, Math.hypot(...s.x), Math.hypot(...s.y)), 0);
