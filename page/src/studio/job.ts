// One run of a study: how far it is, and what can be done about it.

import * as api from "./api";
import { button, make, say } from "./dom";
import type { Progress } from "./types";

const OVER = new Set(["done", "cancelled", "failed"]);

export type Steer = "pause" | "resume" | "cancel";

export class Job {
  readonly box: HTMLElement;
  private readonly bar: HTMLProgressElement;
  private readonly state: HTMLElement;
  private readonly hold: HTMLButtonElement;
  private readonly acts: HTMLElement;
  private last: Progress | null = null;

  constructor(readonly id: string, readonly name: string, steer: (what: Steer) => void) {
    this.bar = make("progress", { max: 1, "aria-label": name });
    this.state = make("span", { class: "state" });
    this.hold = button("pause", () => steer(this.last?.state === "paused" ? "resume" : "pause"));
    this.acts = make("span", { class: "acts" }, this.hold, button("cancel", () => steer("cancel")));
    this.box = make("li", { class: "job", "data-run": id, "data-state": "running" }, make("b", {}, name), this.bar, this.state, this.acts);
  }

  get over(): boolean { return this.last !== null && OVER.has(this.last.state); }

  /** The program does not answer. */
  wait(): void { if (!this.over) this.state.textContent = say("state-waiting"); }

  show(p: Progress): void {
    if (this.over) return;
    this.last = p;
    this.box.dataset.state = p.state;
    const paused = p.state === "paused";
    this.hold.textContent = say(paused ? "resume" : "pause");
    if (p.total > 0) this.bar.value = p.done / p.total; else if (this.over) this.bar.value = 0; else this.bar.removeAttribute("value");
    if (p.state === "done") this.bar.value = 1;
    const counts = p.total > 0 && p.state !== "done" && p.state !== "failed" ? `${p.done} / ${p.total}` : "";
    this.state.textContent = p.error ?? [say(`state-${p.state}`), counts].filter(Boolean).join(" · ");
    if (this.over) this.end(p.state === "done" || p.report === true);
  }

  private end(reported: boolean): void {
    const { name, acts } = this, inside = acts.contains(document.activeElement);
    const report = make("a", { href: api.reportOf(this.id), target: "_blank", rel: "noopener" }, say("report"));
    const remove = button("remove", () => this.box.remove(), { "aria-label": say("remove-this", { name }) });
    acts.replaceChildren(...(reported ? [report, remove] : [remove]));
    if (inside) remove.focus();
  }
}
