// Changes a drawing into another one of the same structure; equal parts are not laid out again.

/** Adds the pairs of nodes that differ, each before its children; false where the structure differs. */
function differing(a: Node, b: Node, pairs: [Node, Node][]): boolean {
  let x = a.firstChild, y = b.firstChild;
  for (; x && y; x = x.nextSibling, y = y.nextSibling) {
    if (x.nodeName !== y.nodeName) return false;
    if (x.isEqualNode(y)) continue;
    pairs.push([x, y]);
    if (!differing(x, y, pairs)) return false;
  }
  return !x && !y;
}

/** Whether the content could be changed to that of `html`; attributes that `html` does not give stay. */
export function patched(host: Element, html: string): boolean {
  const other = document.createElement("template"), pairs: [Node, Node][] = [];
  other.innerHTML = html;
  if (!differing(host, other.content, pairs)) return false;
  for (const [x, y] of pairs) {
    if (!(x instanceof Element && y instanceof Element)) x.nodeValue = y.nodeValue;
    else for (const name of y.getAttributeNames()) {
      const value = y.getAttribute(name)!;
      if (x.getAttribute(name) !== value) x.setAttribute(name, value);
    }
  }
  return true;
}
