// Long studies beside the page: progress, pause, resume, cancel, and the same files as the program writes.

import * as api from "./api";
import { button, make, say } from "./dom";
import type { Studio } from "./studio";
import type { Progress, Study } from "./types";

const OVER = new Set(["done", "cancelled", "failed"]);

export class Runs {
  private readonly list: HTMLElement;
  private readonly jobs: HTMLElement;
  private drawn = "";

  constructor(host: HTMLElement, private readonly studio: Studio) {
    this.list = make("ul", { class: "studies" });
    this.jobs = make("ul", { class: "jobs", "aria-live": "polite" });
    host.append(this.list, this.jobs);
    studio.whenMachine(() => this.draw());
  }

  private draw(): void {
    const all = this.studio.machine?.studies ?? [], key = JSON.stringify(all);
    if (key === this.drawn) return;
    this.drawn = key;
    this.list.replaceChildren(...all.map(s => make("li", {},
      make("span", {}, s.name, s.name === s.kind ? "" : make("small", {}, s.kind)),
      button("run", () => void this.start(s), { "aria-label": say("run-this", { name: s.name }) }))));
    if (!all.length) this.list.append(make("li", { class: "none" }, say("no-studies")));
  }

  private async start(s: Study): Promise<void> {
    try {
      const { id } = await api.run(this.studio.text, s.name, this.studio.file);
      this.follow(id, s.name);
    } catch (e) { this.studio.failed(e); }
  }

  private follow(id: string, name: string): void {
    const bar = make("progress", { max: 1, "aria-label": name }), state = make("span", { class: "state" });
    let paused = false, last: Progress | null = null;
    const steer = (what: "pause" | "resume" | "cancel") => api.steer(id, what).catch((e: unknown) => this.studio.failed(e));
    const hold = button("pause", () => { void steer(paused ? "resume" : "pause"); });
    const cancel = button("cancel", () => { void steer("cancel"); });
    const acts = make("span", { class: "acts" }, hold, cancel);
    const job = make("li", { class: "job", "data-run": id, "data-state": "running" }, make("b", {}, name), bar, state, acts);
    this.jobs.prepend(job);
    const show = (p: Progress) => {
      last = p;
      job.dataset.state = p.state;
      paused = p.state === "paused";
      hold.textContent = say(paused ? "resume" : "pause");
      if (p.total > 0) bar.value = p.done / p.total; else bar.removeAttribute("value");
      state.textContent = p.error ?? [say(`state-${p.state}`), p.total > 0 && !OVER.has(p.state) ? `${p.done} / ${p.total}` : ""].filter(Boolean).join(" · ");
      if (!OVER.has(p.state)) return;
      close();
      if (p.state === "done") bar.value = 1;
      const report = make("a", { href: api.reportOf(id), target: "_blank", rel: "noopener" }, say("report"));
      const remove = button("remove", () => job.remove(), { "aria-label": say("remove-this", { name }) });
      acts.replaceChildren(...(p.state === "done" ? [report, remove] : [remove]));
    };
    const close = api.events(id, show, forGood => {
      if (last && OVER.has(last.state)) close();
      else if (forGood) show({ state: "failed", done: 0, total: 0 });
      else state.textContent = say("state-waiting");
    });
  }
}
