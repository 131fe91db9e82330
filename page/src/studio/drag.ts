// A handle that is moved by a pointer or by the arrow keys.

export interface Dragged {
  /** Movement since the beginning, in pixels of the screen. */
  dx: number;
  dy: number;
}

export interface Listener {
  begin(): boolean;
  move(d: Dragged): void;
  /** `kept` is false when the drag was given up. */
  end(kept: boolean): void;
}

/** Follows a pointer that was pressed on something drawn inside `host`, which may be drawn anew meanwhile. */
export function follow(host: HTMLElement, e: PointerEvent, to: Listener): void {
  if (e.button !== 0 || !to.begin()) return;
  e.preventDefault();
  e.stopPropagation();
  const { clientX: x, clientY: y, pointerId } = e, off = new AbortController(), { signal } = off;
  let kept: Dragged | null = null, frame = 0;
  const flush = () => { frame = 0; if (kept) { to.move(kept); kept = null; } };
  const end = (ok: boolean) => {
    if (signal.aborted) return;
    off.abort();
    cancelAnimationFrame(frame);
    if (ok) flush();
    to.end(ok);
  };
  if (e.isTrusted) host.setPointerCapture(pointerId);
  host.addEventListener("pointermove", m => {
    if (m.pointerId !== pointerId) return;
    kept = { dx: m.clientX - x, dy: m.clientY - y };
    // pointers may report more often than the screen is drawn; the first movement goes out at once
    if (!frame) { to.move(kept); kept = null; frame = requestAnimationFrame(flush); }
  }, { signal });
  host.addEventListener("pointerup", m => { if (m.pointerId === pointerId) end(true); }, { signal });
  host.addEventListener("pointercancel", m => { if (m.pointerId === pointerId) end(false); }, { signal });
  addEventListener("keydown", k => { if (k.key === "Escape") { k.preventDefault(); end(false); } }, { signal, capture: true });
}

/** Steps of the arrow keys: 1 along, 10 with shift; 0 for other keys. */
export function steps(e: KeyboardEvent): number {
  const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[e.key] ?? 0;
  return by * (e.shiftKey ? 10 : 1);
}
