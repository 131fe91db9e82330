// Pinned designs: their checks beside those of the text, their curves over its figures.

import type { Payload } from "../report/payload";
import { button, make, say } from "./dom";
import type { Layer } from "./overlay";
import type { Check, Panels } from "./panels";
import type { Studio } from "./studio";
import type { Want } from "./types";

export interface Pin {
  name: string;
  text: string;
  checks: Check[];
  payloads: Partial<Record<Want, Payload[]>>;
}

const KEPT = "laval-pins";
/** More would make the figures unreadable. */
const MOST = 3;

export class Compare {
  readonly pins: Pin[] = [];
  private count = 0;

  constructor(private readonly host: HTMLElement, private readonly studio: Studio, private readonly panels: Panels) {
    this.restore();
    panels.layers = (want, figure) => this.pins.flatMap((p): Layer[] => {
      const data = p.payloads[want]?.[figure];
      return data ? [{ name: p.name, data }] : [];
    });
    panels.when(a => { if (a.want === "page") this.draw(); });
    this.draw();
  }

  /** Keeps the design of the text. */
  async pin(): Promise<void> {
    const text = this.studio.text, machine = this.studio.machine?.name || say("design"), payloads = this.panels.payloads();
    let checks;
    try { checks = await this.panels.checksNow(); } catch (e) { return this.studio.failed(e); }
    if (!checks) return;
    if (this.pins.length >= MOST) this.pins.shift();
    this.count++;
    this.pins.push({ name: `${machine} ${this.count}`, text, checks, payloads });
    this.changed();
  }

  private changed(): void {
    // pins are a convenience of this tab: a full or forbidden store loses nothing else
    try { sessionStorage.setItem(KEPT, JSON.stringify({ count: this.count, pins: this.pins })); } catch { /* kept in memory only */ }
    this.panels.redraw();
    this.draw();
  }

  private restore(): void {
    try {
      const kept = JSON.parse(sessionStorage.getItem(KEPT) ?? "null") as { count: number; pins: Pin[] } | null;
      if (kept) { this.count = kept.count; this.pins.push(...kept.pins); }
    } catch { /* nothing was kept */ }
  }

  private draw(): void {
    this.host.hidden = !this.pins.length;
    if (!this.pins.length) { this.host.replaceChildren(); return; }
    const now = this.panels.checks(), all = [...new Set([now, ...this.pins.map(p => p.checks)].flatMap(c => c.map(k => k.what)))];
    const head = this.pins.map((p, n) => {
      const name = make("input", { class: "pin-name", value: p.name, "aria-label": say("name") });
      name.addEventListener("change", () => { p.name = name.value; this.changed(); });
      return make("th", { scope: "col" }, make("i", { class: `key p${n % 3}`, "aria-hidden": "true" }), name, make("span", { class: "acts" },
        button("take-back", () => this.studio.editor.open(p.text, this.studio.editor.origin, true), { "aria-label": say("take-back-this", { name: p.name }) }),
        button("remove", () => { this.pins.splice(this.pins.indexOf(p), 1); this.changed(); }, { "aria-label": say("remove-this", { name: p.name }) })));
    });
    const cell = (c: Check | undefined, other: Check | undefined) => {
      if (!c) return make("td", { class: "none" }, "–");
      const td = make("td", { class: other && other.result !== c.result ? "differs" : "" }, c.result);
      if (c.verdict) td.append(make("span", { class: `s ${c.state}` }, c.verdict));
      return td;
    };
    const rows = all.map(what => {
      const of = (checks: Check[]) => checks.find(c => c.what === what), mine = of(now);
      return make("tr", {}, make("th", { scope: "row" }, what), cell(mine, undefined), ...this.pins.map(p => cell(of(p.checks), mine)));
    });
    // a name that is being written stays
    if (document.activeElement?.classList.contains("pin-name") && this.host.contains(document.activeElement)) {
      this.host.querySelector("tbody")?.replaceChildren(...rows);
      return;
    }
    this.host.replaceChildren(make("h2", { id: "title-compare" }, say("compare")), make("div", { class: "scroll" }, make("table", { class: "compare" },
      make("thead", {}, make("tr", {}, make("th", { scope: "col" }, say("check")), make("th", { scope: "col" }, say("now")), ...head)),
      make("tbody", {}, ...rows))));
  }
}
