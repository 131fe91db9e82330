// Changes a drawing into another one of the same structure; equal parts are not laid out again.

import { set } from "./dom";

/** Tags and texts of a drawing, and the elements and texts that they became. */
interface Drawn { pieces: string[]; nodes: Node[]; first: Node | null; last: Node | null }

const drawn = new WeakMap<Element, Drawn>();

const pieces = (html: string): string[] => html.split(/(?=<)|(?<=>)/);
const ends = (piece: string): boolean => piece.startsWith("</");
/** A tag without the values of its attributes; nothing of a text. */
const frame = (piece: string): string => piece.startsWith("<") ? piece.replace(/"[^"]*"/g, '""') : "";

/** Replaces the content; its elements and texts stand in the order of the pieces that begin one. */
function replace(host: Element, html: string): void {
  host.innerHTML = html;
  const nodes: Node[] = [], walk = document.createTreeWalker(host, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
  while (walk.nextNode()) nodes.push(walk.currentNode);
  const all = pieces(html);
  // what the browser reads otherwise than it is written is replaced each time
  const fits = !html.includes("&") && nodes.length === all.filter(p => !ends(p)).length;
  if (fits) drawn.set(host, { pieces: all, nodes, first: host.firstChild, last: host.lastChild });
  else drawn.delete(host);
}

/** Draws `html` into the element. Where only values and texts differ from what was drawn last, these are changed; attributes that others have set stay. */
export function drawInto(host: Element, html: string): void {
  const was = drawn.get(host), all = pieces(html);
  const same = was && was.first === host.firstChild && was.last === host.lastChild && was.pieces.length === all.length && !html.includes("&");
  if (!same || all.some((p, i) => p !== was.pieces[i] && frame(p) !== frame(was.pieces[i]))) return replace(host, html);
  let k = -1;
  all.forEach((p, i) => {
    if (!ends(p)) k++;
    if (p === was.pieces[i]) return;
    const node = was.nodes[k];
    if (!(node instanceof Element)) node.nodeValue = p;
    else for (const [, key, value] of p.matchAll(/\s([\w:-]+)="([^"]*)"/g)) set(node, key, value);
  });
  was.pieces = all;
}
