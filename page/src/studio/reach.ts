// Drag the answer: the program moves the released parameters until the result is where it was pulled to.

import * as api from "./api";
import { button, make, say } from "./dom";
import { Lane } from "./lane";
import { plain } from "./quantity";
import { minus } from "../report/numbers";
import type { Studio } from "./studio";
import type { Pulled } from "./targets";
import type { Free, Reached, Target } from "./types";

interface Goal { target: Target; to: number; text: string }

export class Reach implements Pulled {
  private readonly lane: Lane<Goal>;
  private answer: Reached | null = null;
  private released = false;
  private goal: Goal | null = null;

  constructor(private readonly host: HTMLElement, private readonly studio: Studio, private readonly free: () => Free[]) {
    this.lane = new Lane((g, signal) => this.work(g, signal), e => { this.answer = null; studio.failed(e); });
    this.lane.idled = () => { if (this.released) this.finish(); };
    this.idle();
  }

  /** Without a pull: what can be done here. */
  idle(): void {
    const n = this.free().length;
    this.host.replaceChildren(make("p", { class: "hint" }, n ? say("pull-help", { count: n }) : say("release-first")));
  }

  begin(): boolean {
    this.released = false;
    this.answer = null;
    if (this.free().length) return true;
    this.studio.tell(say("release-first"));
    return false;
  }

  move(target: Target, v: number, text: string): void {
    this.goal = { target, to: v / target.factor, text };
    this.lane.ask(this.goal);
  }

  end(_: Target, kept: boolean): void {
    if (!kept) { this.lane.stop(); this.answer = null; this.idle(); return; }
    this.released = true;
    if (this.lane.idle) this.finish();
  }

  private async work(g: Goal, signal: AbortSignal): Promise<void> {
    const { what, which } = g.target;
    this.answer = await api.reach(this.studio.text, { what, which, to: g.to }, this.free(), signal);
    this.show(g, this.answer);
  }

  /** The text changes when the handle is let go, as one step. */
  private finish(): void {
    this.released = false;
    const a = this.answer;
    if (!a || !this.goal) return;
    if (a.reached) this.studio.editor.apply(a.edits);
    else if (a.edits.length) this.host.append(button("take-nearest", () => { this.studio.editor.apply(a.edits); this.idle(); }, { class: "nearest" }));
  }

  private show(g: Goal, a: Reached): void {
    const name = (path: string) => this.studio.parameter(path)?.label ?? path;
    const amount = (path: string, v: number) => plain(v, this.studio.parameter(path)?.unit ?? "");
    const percent = (v: number) => minus((100 * v).toFixed(0)) + " %";
    const head = make("p", { class: a.reached ? "ok" : "bad", role: "status" },
      a.impossible ? a.impossible.sentence : say(a.reached ? "reached" : "not-reached", { name: g.target.label, value: g.text }));
    const parts: HTMLElement[] = [head];
    if (a.moved.length) {
      const cell = (text: string) => make("td", {}, text);
      const th = (key: string) => make("th", { scope: "col" }, say(key));
      parts.push(make("table", { class: "moved" },
        make("thead", {}, make("tr", {}, th("parameter"), th("from"), th("to"), th("share-column"))),
        make("tbody", {}, ...a.moved.map(m => make("tr", { class: m.at_bound ? "bound" : "" },
          cell(name(m.path)), cell(amount(m.path, m.from)), cell(amount(m.path, m.to) + (m.at_bound ? ` (${say("at-bound")})` : "")), cell(percent(m.share)))))));
    }
    if (a.trade.length) parts.push(this.trade(a, amount, name));
    this.host.replaceChildren(...parts);
  }

  /** What each parameter alone would have to be. */
  private trade(a: Reached, amount: (path: string, v: number) => string, name: (path: string) => string): HTMLElement {
    const rows = a.trade.map(t => make("li", {}, `${name(t.path)}: ${amount(t.path, t.value)}`));
    return make("details", {}, make("summary", {}, say("trade")), make("ul", {}, ...rows));
  }
}
