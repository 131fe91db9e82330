// Long studies beside the page: progress, pause, resume, cancel, and the same files as the program writes.

import * as api from "./api";
import { button, make, say } from "./dom";
import type { Studio } from "./studio";
import type { Listed, Progress, Study } from "./types";

const OVER = new Set(["done", "cancelled", "failed"]);

export class Runs {
  private readonly list: HTMLElement;
  private readonly jobs: HTMLElement;
  private drawn = "";
  /** Runs that are listed, or were removed from the list here. */
  private readonly known = new Set<string>();

  constructor(host: HTMLElement, private readonly studio: Studio) {
    this.list = make("ul", { class: "studies" });
    this.jobs = make("ul", { class: "jobs", "aria-live": "polite" });
    host.append(this.list, this.jobs);
    studio.whenMachine(() => this.draw());
    // runs of another tab, or of before a reload
    document.addEventListener("visibilitychange", () => { if (!document.hidden) void this.fetch(); });
    addEventListener("focus", () => void this.fetch());
    studio.returned = () => {
      // a program that was started anew counts its runs from the beginning
      this.known.clear();
      for (const e of this.jobs.querySelectorAll<HTMLElement>(".job")) if (!OVER.has(e.dataset.state!)) this.known.add(e.dataset.run!);
    };
    void this.fetch();
  }

  /** Lists the runs that the program remembers, the newest first. */
  private async fetch(): Promise<void> {
    let found: Listed[];
    try {
      found = (await api.runs()).runs;
    } catch (e) {
      // an older program lists none
      if (!(e instanceof api.Refused)) this.studio.failed(e);
      return;
    }
    for (const r of [...found].reverse()) if (!this.known.has(r.id)) this.follow(r.id, r.study, r);
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
      if (!this.known.has(id)) this.follow(id, s.name);
    } catch (e) { this.studio.failed(e); }
  }

  private follow(id: string, name: string, now: Listed | null = null): void {
    this.known.add(id);
    const bar = make("progress", { max: 1, "aria-label": name }), state = make("span", { class: "state" });
    let paused = false, last: Progress | null = null, going: Progress | null = null, cancelled = false;
    const steer = (what: "pause" | "resume" | "cancel") => api.steer(id, what).catch((e: unknown) => this.studio.failed(e));
    const hold = button("pause", () => { void steer(paused ? "resume" : "pause"); });
    const cancel = button("cancel", () => { cancelled = true; void steer("cancel"); });
    const acts = make("span", { class: "acts" }, hold, cancel);
    const job = make("li", { class: "job", "data-run": id, "data-state": "running" }, make("b", {}, name), bar, state, acts);
    this.jobs.prepend(job);
    let close = () => {};
    const show = (p: Progress) => {
      // what is left is passed over at the end: a cancelled run stands where it was
      if (p.state === "cancelled" && p.done >= p.total && going) p = { ...p, done: going.done, total: going.total };
      if (!OVER.has(p.state) && !cancelled) going = p;
      last = p;
      job.dataset.state = p.state;
      paused = p.state === "paused";
      hold.textContent = say(paused ? "resume" : "pause");
      if (p.total > 0) bar.value = p.done / p.total; else if (OVER.has(p.state)) bar.value = 0; else bar.removeAttribute("value");
      state.textContent = p.error ?? [say(`state-${p.state}`), p.total > 0 && p.state !== "done" && p.state !== "failed" ? `${p.done} / ${p.total}` : ""].filter(Boolean).join(" · ");
      if (!OVER.has(p.state)) return;
      close();
      if (p.state === "done") bar.value = 1;
      const report = make("a", { href: api.reportOf(id), target: "_blank", rel: "noopener" }, say("report"));
      const remove = button("remove", () => job.remove(), { "aria-label": say("remove-this", { name }) });
      const inside = acts.contains(document.activeElement);
      acts.replaceChildren(...(p.state === "done" || p.report ? [report, remove] : [remove]));
      if (inside) remove.focus();
    };
    // what is over needs no connection; of a cancelled one its event says whether there is a report
    if (now && OVER.has(now.state) && (now.state !== "cancelled" || now.report !== undefined)) return show(now);
    close = api.events(id, show, forGood => {
      if (last && OVER.has(last.state)) close();
      else if (forGood) show({ state: "failed", done: 0, total: 0 });
      else state.textContent = say("state-waiting");
    });
  }
}
