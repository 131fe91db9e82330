// The machine in section, as the report draws it, with handles on what can be moved.

import { el } from "../report/path";
import { follow, steps } from "./drag";
import { say } from "./dom";
import type { Studio } from "./studio";
import type { Handle } from "./types";
import { inFile } from "./quantity";

export class Section {
  private active: string | null = null;
  private drawn = "";
  /** Value that the keys wanted last, until it is drawn. */
  private last: { path: string; value: number } | null = null;

  constructor(private readonly host: HTMLElement, private readonly studio: Studio) {
    studio.whenMachine(() => this.draw());
  }

  draw(): void {
    const d = this.studio.machine?.drawing;
    this.host.classList.toggle("stale", this.studio.errors > 0);
    if (!d) { this.host.replaceChildren(); this.drawn = ""; return; }
    if (this.last && !this.studio.waits(this.last.path)) this.last = null;
    const key = d.svg + JSON.stringify(d.handles);
    if (key === this.drawn) return;
    this.drawn = key;
    const focused = (this.host.getRootNode() as Document).activeElement?.getAttribute("data-path");
    this.host.innerHTML = d.svg;
    const svg = this.host.querySelector("svg");
    if (!svg) return;
    svg.setAttribute("role", "group");
    for (const h of d.handles) svg.append(this.handle(svg, h));
    if (focused) this.host.querySelector<SVGElement>(`[data-path="${CSS.escape(focused)}"]`)?.focus();
  }

  private handle(svg: SVGSVGElement, h: Handle): SVGGElement {
    const p = this.studio.parameter(h.path), shown = p?.shown || inFile(p, h.value);
    const g = el("g", {
      class: "handle" + (this.active === h.path ? " active" : ""), role: "slider", tabindex: 0, "data-path": h.path, "data-axis": h.axis,
      transform: `translate(${h.x} ${h.y})`,
      "aria-label": h.label, "aria-valuetext": shown, "aria-valuenow": h.value,
      ...(p ? { "aria-valuemin": p.low, "aria-valuemax": p.high } : {}),
    });
    g.append(
      el("title", {}, say("drag-this", { name: h.label, value: shown })),
      el("circle", { class: "hit", r: 13 }), el("circle", { class: "knob", r: 6.5 }),
      el("path", { class: "arrows", d: h.axis === "x" ? "M-7 -3.5L-11 0L-7 3.5M7 -3.5L11 0L7 3.5" : "M-3.5 -7L0 -11L3.5 -7M-3.5 7L0 11L3.5 7" }),
    );
    const { width } = svg.viewBox.baseVal, left = h.x > width / 2;
    g.append(el("text", { class: "value", x: left ? -13 : 13, y: -11, "text-anchor": left ? "end" : "start" }, `${h.label} ${shown}`));
    g.addEventListener("pointerdown", e => this.pull(svg, h, e));
    g.addEventListener("keydown", e => {
      const by = steps(e);
      if (!by) return;
      e.preventDefault();
      const span = p ? p.high - p.low : Math.abs(h.value);
      const from = this.last?.path === h.path ? this.last.value : h.value;
      this.last = { path: h.path, value: this.limited(h, from + by * span / 100) };
      this.studio.change([this.last]);
    });
    return g;
  }

  private limited(h: Handle, v: number): number {
    const p = this.studio.parameter(h.path);
    return +(p ? Math.min(Math.max(v, p.low), p.high) : v).toPrecision(4);
  }

  private pull(svg: SVGSVGElement, h: Handle, e: PointerEvent): void {
    const unit = svg.viewBox.baseVal.width / svg.getBoundingClientRect().width;
    follow(this.host, e, {
      begin: () => { this.active = h.path; this.studio.begin(); return true; },
      move: d => this.studio.change([{ path: h.path, value: this.limited(h, h.value + h.scale * unit * (h.axis === "x" ? d.dx : d.dy)) }]),
      end: kept => {
        this.active = null;
        this.drawn = "";
        this.studio.end(kept);
      },
    });
  }
}
