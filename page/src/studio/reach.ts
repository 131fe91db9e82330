// Drag the answer: the program moves the released parameters until the result is where it was pulled to.

import * as api from "./api";
import { wanted } from "./ask";
import { button, make, say } from "./dom";
import { refocus } from "./focus";
import { Lane } from "./lane";
import { inFile } from "./quantity";
import { minus, number, unit } from "../report/numbers";
import { el } from "../report/path";
import type { Studio } from "./studio";
import type { Named, Pulled } from "./targets";
import type { Free, Reached } from "./types";

/** `at` is the place on the axis, `to` the same in SI units. */
interface Goal { target: Named; at: number; to: number; text: string; unit: string }

export class Reach implements Pulled {
  private readonly lane: Lane<Goal>;
  private answer: Reached | null = null;
  private released = false;
  private unfolded = false;
  private goal: Goal | null = null;
  /** Text that the message speaks of, and the last goal that this text has reached. */
  private holds: string | null = null;
  private there: Goal | null = null;
  private applying = false;

  constructor(private readonly host: HTMLElement, private readonly studio: Studio, private readonly free: () => Free[]) {
    this.lane = new Lane((g, signal) => this.work(g, signal), e => { this.answer = null; this.released = false; this.idle(); studio.failed(e); });
    this.lane.idled = () => { if (this.released) this.finish(); };
    studio.whenText(() => this.outlived());
    this.idle();
  }

  /** Without a pull: what can be done here. */
  idle(): void {
    const n = this.free().length;
    this.holds = null;
    this.goal = this.there = null;
    if (n && this.studio.notice === say("release-first")) this.studio.tell("");
    this.host.replaceChildren(make("p", { class: "hint" }, n ? say("pull-help", { count: n }) : say("release-first")));
  }

  /** After a change of the text: removes the message about the text before it. */
  private outlived(): void {
    if (this.applying || this.holds === null || this.holds === this.studio.text || !this.lane.idle) return;
    // a value that is being written stays
    if (this.host.querySelector(".pick")) { this.holds = this.there = null; return; }
    this.idle();
  }

  /** A change of the text that the message speaks of. */
  private apply(a: Reached): void {
    this.applying = true;
    this.studio.editor.apply(a.edits);
    this.applying = false;
    this.holds = this.studio.text;
    if (this.studio.notice) this.studio.tell("");
  }

  wanted(t: Named): number | null {
    const g = this.goal;
    if (g?.target.key !== t.key) return null;
    return !this.lane.idle || this.there === g && this.holds === this.studio.text ? g.at : null;
  }

  /** A target as it is known in the text of now: it stands where it was moved to last. */
  private now(t: Named): Named {
    const g = this.there;
    if (!g || g.target.key !== t.key || this.holds !== this.studio.text || t.along !== "x" || typeof t.which !== "object") return t;
    return { ...t, which: { ...t.which, at: g.to } };
  }

  begin(): boolean {
    this.released = false;
    this.answer = null;
    if (this.free().length) {
      this.studio.tell("");
      return true;
    }
    this.studio.tell(say("release-first"));
    return false;
  }

  move(target: Named, v: number, text: string, unit: string): void {
    this.goal = { target: this.now(target), at: v, to: v / target.factor, text, unit };
    this.lane.ask(this.goal);
  }

  end(_: Named, kept: boolean): void {
    if (!kept) { this.lane.stop(); this.answer = null; this.idle(); return; }
    this.released = true;
    if (this.lane.idle) this.finish();
  }

  pick(target: Named, v: number, name: string): void {
    const field = make("input", { type: "text", value: +v.toPrecision(5), "aria-label": target.label, "aria-describedby": "pick-wrong", autocomplete: "off", spellcheck: "false" });
    const wrong = make("p", { class: "wrong", id: "pick-wrong", role: "alert" });
    const right = () => { field.removeAttribute("aria-invalid"); wrong.textContent = ""; };
    const go = () => {
      const to = wanted(field.value, name);
      if (to === null) {
        field.setAttribute("aria-invalid", "true");
        wrong.textContent = say("not-a-number", { name });
        return field.focus();
      }
      right();
      this.released = true;
      this.goal = { target: this.now(target), at: to, to: to / target.factor, text: number(to) + unit(name), unit: name };
      this.lane.ask(this.goal);
    };
    field.addEventListener("input", right);
    field.addEventListener("keydown", e => { if (e.key === "Enter") { e.preventDefault(); go(); } else if (e.key === "Escape") { this.idle(); refocus(document, target.key); } });
    this.host.replaceChildren(make("p", { class: "pick" }, make("label", {}, target.label, " ", field, unit(name)), " ", button("reach", go)), wrong);
    field.select();
  }

  /** A search that takes long is stated, and can be given up. */
  private runs(g: Goal): void {
    const cancel = button("cancel", () => { this.lane.stop(); this.answer = null; this.released = false; this.idle(); });
    this.host.replaceChildren(make("p", { class: "hint", role: "status" }, say("reach-running", { name: g.target.label, value: g.text }), " ", cancel));
  }

  private async work(g: Goal, signal: AbortSignal): Promise<void> {
    const { what, which } = g.target, text = this.studio.text;
    const late = window.setTimeout(() => this.runs(g), 500);
    let answer: Reached;
    try {
      answer = await api.reach(text, { what, which, to: g.to }, this.free(), signal);
    } finally {
      clearTimeout(late);
    }
    // its changes would fall on other places of a text that was changed meanwhile
    if (text !== this.studio.text) return this.work(g, signal);
    this.answer = answer;
    this.holds = text;
    this.show(g, answer);
  }

  /** The text changes when the handle is let go, as one step. */
  private finish(): void {
    this.released = false;
    const a = this.answer;
    if (!a || !this.goal) return;
    if (this.holds !== this.studio.text) { this.released = true; return this.lane.ask(this.goal); }
    if (a.reached) { this.apply(a); this.there = this.goal; }
    else if (a.edits.length) this.host.append(button("take-nearest", () => { this.apply(a); this.idle(); }, { class: "nearest" }));
  }

  private show(g: Goal, a: Reached): void {
    const name = (path: string) => this.studio.parameter(path)?.label ?? path;
    const amount = (path: string, v: number) => inFile(this.studio.parameter(path), v);
    const percent = (v: number) => minus((100 * v).toFixed(0)) + " %";
    const head = make("p", { class: a.reached ? "ok" : "bad", role: "status" },
      a.impossible ? a.impossible.sentence : say(a.reached ? "reached" : "not-reached", { name: g.target.label, value: g.text }));
    const parts: HTMLElement[] = [head];
    const cell = (text: string) => make("td", {}, text);
    const th = (key: string) => make("th", { scope: "col" }, say(key));
    if (a.moved.length) {
      parts.push(make("table", { class: "moved" },
        make("thead", {}, make("tr", {}, th("parameter"), th("from"), th("to"), th("share-column"))),
        make("tbody", {}, ...a.moved.map(m => make("tr", { class: m.at_bound ? "bound" : "" },
          cell(name(m.path)), cell(amount(m.path, m.from)), cell(amount(m.path, m.to) + (m.at_bound ? ` (${say("at-bound")})` : "")), cell(percent(m.share)))))));
    }
    const curve = a.curve && a.curve.length > 2 ? this.curve(a.curve, g) : null;
    if (a.trade.length || curve) {
      const details = make("details", { open: this.unfolded }, make("summary", {}, say("trade")));
      details.addEventListener("toggle", () => { this.unfolded = details.open; });
      if (curve) details.append(curve);
      if (a.trade.length) details.append(make("table", { class: "moved" },
        make("thead", {}, make("tr", {}, th("alone"), th("to"), th("result"))),
        make("tbody", {}, ...a.trade.map(t => make("tr", { class: t.reached ? "" : "bound" }, cell(name(t.path)), cell(amount(t.path, t.value)), cell(this.result(g, t.target)))))));
      parts.push(details);
    }
    const inside = this.host.contains(document.activeElement);
    this.host.replaceChildren(...parts);
    // the field is gone: the keyboard goes on at the handle
    if (inside) refocus(document, g.target.key);
  }

  private result(g: Goal, v: number): string { return number(+(v * g.target.factor).toPrecision(4)) + unit(g.unit); }

  /** How much the parameters must change for how much of the result. */
  private curve(points: [number, number][], g: Goal): HTMLElement {
    const xs = points.map(p => p[0]), lo = Math.min(...xs), hi = Math.max(...xs), most = Math.max(...points.map(p => p[1]), 1e-9);
    const X = (v: number) => 8 + 284 * (v - lo) / (hi - lo || 1), Y = (v: number) => 84 - 74 * v / most;
    const svg = el("svg", { viewBox: "0 0 300 106", role: "img", class: "curve", "aria-label": say("trade-curve") });
    svg.append(
      el("path", { class: "ax", d: "M8 10V84H292", fill: "none" }),
      el("path", { class: "c0", fill: "none", "stroke-width": 2, d: points.map(([x, y], i) => `${i ? "L" : "M"}${X(x).toFixed(1)} ${Y(y).toFixed(1)}`).join("") }),
      el("text", { class: "t so", x: 8, y: 100 }, this.result(g, lo)), el("text", { class: "t so", x: 292, y: 100, "text-anchor": "end" }, this.result(g, hi)),
      el("text", { class: "t so", x: 12, y: 18 }, `${say("change")} ${minus((100 * most).toPrecision(2))} %`),
    );
    for (const [x, y] of points) svg.append(el("circle", { class: "mf c0", cx: X(x).toFixed(1), cy: Y(y).toFixed(1), r: 2.6 }));
    return make("figure", { class: "trade" }, svg);
  }
}
