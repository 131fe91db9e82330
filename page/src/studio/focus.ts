// The keyboard stays where it is when a part of the page is drawn anew.

const USABLE = "a[href], button, input, select, summary, [tabindex='0']:not(.target)";

/** Remembers what has the focus inside `host`; called after it was drawn anew, the answer gives the focus back. */
export function keep(host: HTMLElement): () => void {
  const active = document.activeElement, list = () => [...host.querySelectorAll<HTMLElement | SVGElement>(USABLE)];
  if (!active || active === host || !host.contains(active)) return () => {};
  const target = active.getAttribute("data-target"), all = target === null ? list() : [], at = all.indexOf(active as HTMLElement);
  return () => {
    if (target !== null) return refocus(host, target);
    const now = list();
    if (at >= 0 && now.length === all.length) now[at].focus({ preventScroll: true });
  };
}

/** Focus on a handle, in the drawing that is shown. */
export function refocus(host: ParentNode, target: string): void {
  const all = [...host.querySelectorAll<SVGElement>(`.target[data-target="${CSS.escape(target)}"]`)];
  all.find(e => e.getClientRects().length)?.focus({ preventScroll: true });
}
