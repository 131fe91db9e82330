// Live figures: each is requested again after a change while it is in sight.

import { Chosen, Figure } from "../report/figure";
import { number, unit } from "../report/numbers";
import type { Payload } from "../report/payload";
import * as api from "./api";
import { find, make, say, write } from "./dom";
import { keep } from "./focus";
import { PATIENCE } from "./lane";
import { Layer, overlay } from "./overlay";
import { drawInto } from "./patch";
import type { Studio } from "./studio";
import { Pulled, targets } from "./targets";
import { Answer, WANTS, Want } from "./types";

/** Figures that are computed at a time beside the modes; the browser needs a core of its own. */
const AT_ONCE = Math.min(3, Math.max(1, (navigator.hardwareConcurrency || 2) - 1));

/** How long the text rests before its first page is requested, and after which time it is all the same, ms. */
const REST = 100, LONGEST = 500;

/** Time after which a figure of another text is dimmed, ms. */
const LATE = 600;

/** Checks of page one, as its table lists them. */
export interface Check { what: string; result: string; verdict: string; state: string }

interface Panel {
  want: Want;
  box: HTMLElement;
  body: HTMLElement;
  took: HTMLElement;
  /** In the heading: the speed that the modes are those of. */
  at: HTMLElement;
  /** A request on its way: which text, since when. */
  running: { abort: AbortController; key: string; since: number } | null;
  /** Since when another text is wanted; 0 where none is. */
  since: number;
  seen: boolean;
  /** Part of it that is seen. */
  part: number;
  /** Text and speed of the answer shown, or on its way. */
  asked: string | null;
  figures: Figure[];
  last: Answer | null;
  /** Text and speed of what is shown, when it was drawn, and whether it is dimmed as that of another text. */
  of: string | null;
  drawn: number;
  late: boolean;
}

export class Panels {
  private readonly panels = new Map<Want, Panel>();
  private readonly listeners: ((a: Answer) => void)[] = [];
  /** Curves of pinned designs for a figure. */
  layers: (want: Want, figure: number) => Layer[] = () => [];
  pulled: Pulled | null = null;
  private marking = 0;
  /** The last text and speed that the first page is wanted for, since when, since when any is wanted, and what looks again. */
  private readonly resting = { key: "", since: 0, first: 0, timer: 0 };

  constructor(host: HTMLElement, private readonly studio: Studio) {
    const seen = new IntersectionObserver(entries => {
      for (const e of entries) {
        const p = this.panels.get((e.target as HTMLElement).dataset.want as Want);
        if (!p) continue;
        p.seen = e.isIntersecting;
        p.part = e.intersectionRatio;
      }
      this.pump();
    }, { root: null, rootMargin: "40px", threshold: [0, 0.25, 0.5, 0.75, 0.95] });
    for (const want of WANTS) {
      const p = this.make(want);
      this.panels.set(want, p);
      host.append(p.box);
      seen.observe(p.box);
      find("#contents").append(make("button", { type: "button", onclick: () => p.box.scrollIntoView({ block: "start" }) }, say(`short-${want}`)));
    }
    studio.whenText(() => this.refresh());
    studio.quick = a => { const p = a.want === "edit" || a.want === "motion" ? undefined : this.panels.get(a.want); if (p) this.show(p, a); };
    studio.quickFits = () => { const p = this.panels.get("modes"); if (p) { p.asked = p.of = this.key(); this.mark(); } };
    studio.onComing = () => this.refresh();
    studio.whenMachine(() => this.dim());
    studio.whenStatus(() => { if (!studio.reachable) this.dim(); });
  }

  /** What is shown belongs to another text: that of before an error, or of before the server was gone. */
  private dim(): void {
    const other = this.studio.errors > 0 || !this.studio.reachable;
    for (const p of this.panels.values()) p.box.classList.toggle("stale", other);
  }

  private make(want: Want): Panel {
    const took = make("span", { class: "took", "aria-hidden": "true" }), at = make("span", { class: "at" }), body = make("div", { class: "body" });
    const box = make("section", { class: "panel", id: `panel-${want}`, "data-want": want, "aria-labelledby": `title-${want}` },
      make("h2", { id: `title-${want}` }, say(`want-${want}`), at, took), body);
    const panel: Panel = {
      want, box, body, took, at, seen: false, part: 0, asked: null, figures: [], last: null, of: null, drawn: 0, late: false, running: null, since: 0,
    };
    return panel;
  }

  /** Called for each answer shown. */
  when(f: (a: Answer) => void): void { this.listeners.push(f); }

  /** Asks for all figures that can be seen. */
  refresh(): void { this.pump(); }

  private key(): string { return `${this.studio.speed}|${this.studio.newest}`; }

  /** Whether a panel shows another text than that of the editor. */
  private wanted(p: Panel): boolean {
    // modes feed the view in space too
    if (!p.seen && p.want !== "modes") return false;
    if (p.want === "modes" && (this.studio.coming !== null || this.studio.promised === this.studio.text)) return false;
    if (p.asked === this.key()) return false;
    return p.want !== "page" || p.last === null || this.rested();
  }

  /** The first page takes the processors longest and is read, not watched: while the machine changes it comes now and then. */
  private rested(): boolean {
    const now = performance.now(), key = this.key(), r = this.resting;
    if (key !== r.key) { r.key = key; r.since = now; r.first ||= now; }
    // figures of a coming text are drawn first
    if (this.studio.coming !== null) return false;
    const wait = Math.min(r.since + REST, r.first + LONGEST) - now;
    clearTimeout(r.timer);
    if (wait > 0) r.timer = window.setTimeout(() => this.pump(), wait);
    return wait <= 0;
  }

  /**
   * Sends requests: modes at once, of the other figures only as many as the processor answers beside them. The one that waits longest comes first; of those that have waited
   * equally long, the one of which the largest part is visible.
   * What runs too long for a text that is no more is abandoned.
   */
  private pump(): void {
    const all = [...this.panels.values()], now = performance.now(), key = this.key();
    this.mark();
    for (const p of all) {
      const r = p.running;
      if (!r || r.key === key || !this.wanted(p)) continue;
      if (now - r.since > PATIENCE) r.abort.abort();
      else setTimeout(() => { if (p.running === r && r.key !== this.key()) r.abort.abort(); }, PATIENCE - (now - r.since));
    }
    const waiting = all.filter(p => !p.running && this.wanted(p));
    for (const p of waiting) p.since ||= now;
    waiting.sort((a, b) => a.since - b.since || b.part - a.part);
    let room = AT_ONCE - all.filter(p => p.running && p.want !== "modes").length;
    for (const p of waiting) if (p.want === "modes" || room-- > 0) void this.send(p);
  }

  /** What is shown belongs to another text than that of now: after a moment it is dimmed. */
  private mark(): void {
    const other = (p: Panel) => p.last !== null && p.of !== this.key();
    for (const p of this.panels.values()) if (p.late && !other(p)) { p.late = false; p.box.classList.remove("late"); }
    if (this.marking || ![...this.panels.values()].some(p => other(p) && !p.late)) return;
    this.marking = window.setTimeout(() => {
      this.marking = 0;
      // figures that follow a drag are always a little behind
      const before = performance.now() - LATE;
      for (const p of this.panels.values()) if (other(p) && !p.late && p.drawn <= before) { p.late = true; p.box.classList.add("late"); }
      this.mark();
    }, LATE);
  }

  private async send(p: Panel): Promise<void> {
    const { newest: text, speed } = this.studio, run = p.running = { abort: new AbortController(), key: this.key(), since: performance.now() };
    p.asked = run.key;
    p.since = 0;
    if (p.want === "page") this.resting.first = 0;
    p.box.classList.add("busy");
    p.box.setAttribute("aria-busy", "true");
    try {
      await api.answer({ text, want: [p.want], ...(speed !== null ? { speed } : {}) }, run.abort.signal, a => {
        if (a.want !== p.want) return;
        this.show(p, a);
        if (a.error === undefined) p.of = run.key;
        this.mark();
      });
    } catch (e) {
      p.running = null;
      // a refused request is not repeated
      if (p.asked === run.key && !(e instanceof api.Refused)) p.asked = null;
      if (!api.aborted(e)) return this.studio.failed(e);
      return this.pump();
    } finally {
      p.box.classList.remove("busy");
      p.box.removeAttribute("aria-busy");
    }
    p.running = null;
    this.pump();
  }

  private show(p: Panel, a: Answer): void {
    if (a.error !== undefined) {
      p.box.classList.add("stale");
      p.box.classList.add("filled");
      if (!p.last) p.body.replaceChildren(make("p", { class: "none" }, a.error));
      p.took.textContent = "";
      return;
    }
    p.last = a;
    p.of = this.key();
    p.drawn = performance.now();
    if (!p.box.matches(".filled:not(.stale)")) {
      p.box.classList.add("filled");
      p.box.classList.remove("stale");
    }
    write(p.took, a.ms === undefined ? "" : `${a.ms < 10 ? a.ms.toFixed(1) : Math.round(a.ms)} ms`);
    this.draw(p, a);
    this.listeners.forEach(f => f(a));
  }

  private draw(p: Panel, a: Answer): void {
    const chosen: Chosen[] = p.figures.map(f => f.choice()), open = [...p.body.querySelectorAll("details")].map(d => d.open);
    const html = a.html ?? "", refocus = keep(p.body);
    if (p.want === "modes") write(p.at, this.speed(a));
    // modes are drawings without listeners of their own: what is alike stays
    if (html && p.want === "modes") drawInto(p.body, html);
    else p.body.innerHTML = html || `<p class="none"></p>`;
    if (!html) p.body.querySelector("p")!.textContent = say("nothing");
    p.body.querySelectorAll("details").forEach((d, i) => { if (open[i] !== undefined) d.open = open[i]; });
    p.figures = [];
    p.body.querySelectorAll<HTMLElement>("figure.fig").forEach((box, n) => {
      if (!box.querySelector("script")) return;
      const f = new Figure(box);
      p.figures.push(f);
      const layers = this.layers(p.want, n);
      if (layers.length) overlay(f, layers);
      if (chosen[n]) f.choose(chosen[n]);
    });
    if (p.want !== "page" && a.targets?.length && p.figures[0] && this.pulled) targets(p.figures[0], p.body, a.targets, this.pulled);
    refocus();
  }

  /** Speed of the modes as it is written elsewhere. */
  private speed(a: Answer): string {
    const w = a.speed ?? this.studio.speed ?? this.studio.machine?.speed;
    return w ? `${number(+(w * 30 / Math.PI).toPrecision(4))}${unit(say("rpm"))}` : "";
  }

  /** Another machine: nothing of the last one stays. */
  forget(): void {
    for (const p of this.panels.values()) {
      p.running?.abort.abort();
      p.asked = p.last = null;
      p.figures = [];
      p.body.replaceChildren();
      p.took.textContent = p.at.textContent = "";
      p.box.classList.remove("filled", "stale");
    }
  }

  /** Draws anew what is there, after pins changed. */
  redraw(): void { for (const p of this.panels.values()) if (p.last) { this.draw(p, p.last); this.listeners.forEach(f => f(p.last as Answer)); } }

  /** A panel shows the answer to the text and the speed of now. */
  private current(p: Panel): boolean {
    return p.last !== null && p.asked === this.key() && !p.running && !p.box.classList.contains("stale");
  }

  /** Numbers of the figures that belong to the text of now, to be kept with a pin. */
  payloads(): Partial<Record<Want, Payload[]>> {
    const shown = [...this.panels.values()].filter(p => p.figures.length && this.current(p));
    return Object.fromEntries(shown.map(p => [p.want, p.figures.map(f => f.data)]));
  }

  /** Checks of page one of the text of now, computed where the panel shows those of another; nothing where the text describes no machine. */
  async checksNow(): Promise<Check[] | null> {
    const p = this.panels.get("page");
    if (p && this.current(p)) return this.checks();
    let found: Check[] | null = null;
    await api.answer({ text: this.studio.text, want: ["page"] }, new AbortController().signal, a => {
      if (a.want !== "page") return;
      if (a.error !== undefined) return this.studio.tell(a.error);
      const page = make("div");
      page.innerHTML = a.html ?? "";
      found = this.checks(page);
    });
    return found;
  }

  /** Checks of a page one: of that shown, or of another. */
  checks(page: ParentNode | undefined = this.panels.get("page")?.body): Check[] {
    const rows = page?.querySelectorAll<HTMLTableRowElement>("table.chk tbody tr") ?? [];
    return [...rows].map(r => {
      const [what, result, , verdict] = [...r.cells].map(c => c.textContent ?? ""), state = r.cells[3]?.className.replace(/^s /, "") ?? "no";
      const short = r.cells[1]?.firstChild?.textContent ?? result;
      return { what: what ?? "", result: short, verdict: verdict ?? "", state };
    });
  }

  last(want: Want): Answer | null { return this.panels.get(want)?.last ?? null; }
  box(want: Want): HTMLElement { return this.panels.get(want)!.box; }
}
