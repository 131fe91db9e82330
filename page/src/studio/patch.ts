// Changes a drawing into another one of the same structure; equal parts are not laid out again.

const alike = (a: Node, b: Node): boolean =>
  a.nodeName === b.nodeName && a.childNodes.length === b.childNodes.length && [...a.childNodes].every((c, i) => alike(c, b.childNodes[i]));

function copy(a: Node, b: Node): void {
  if (a instanceof Element && b instanceof Element) {
    for (const { name, value } of b.attributes) if (a.getAttribute(name) !== value) a.setAttribute(name, value);
  } else if (a.nodeValue !== b.nodeValue) a.nodeValue = b.nodeValue;
  a.childNodes.forEach((c, i) => copy(c, b.childNodes[i]));
}

/** Whether the content could be changed to that of `html`; attributes that `html` does not give stay. */
export function patched(host: Element, html: string): boolean {
  const other = document.createElement("template");
  other.innerHTML = html;
  const to = other.content;
  if (host.childNodes.length !== to.childNodes.length || ![...host.childNodes].every((c, i) => alike(c, to.childNodes[i]))) return false;
  host.childNodes.forEach((c, i) => copy(c, to.childNodes[i]));
  return true;
}
