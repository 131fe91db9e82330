// Long studies beside the page: progress, pause, resume, cancel, and the same files as the program writes.

import * as api from "./api";
import { button, make, say } from "./dom";
import { Job, Steer } from "./job";
import type { Studio } from "./studio";
import type { Listed, Study } from "./types";

/** Time between two looks at the runs that go on, ms: a connection held for each would be one of the few that a browser has for all tabs. */
const BETWEEN = 400;

export class Runs {
  private readonly list: HTMLElement;
  private readonly jobs: HTMLElement;
  private drawn = "";
  /** Runs of this program, those included that were removed from the list here. */
  private readonly known = new Map<string, Job>();
  private next = 0;

  constructor(host: HTMLElement, private readonly studio: Studio) {
    this.list = make("ul", { class: "studies" });
    this.jobs = make("ul", { class: "jobs", "aria-live": "polite" });
    host.append(this.list, this.jobs);
    studio.whenMachine(() => this.draw());
    // runs that another tab has started
    document.addEventListener("visibilitychange", () => { if (!document.hidden) void this.fetch(); });
    addEventListener("focus", () => void this.fetch());
    studio.returned = () => {
      // a program that was started anew counts its runs from the beginning
      for (const [id, job] of this.known) if (job.over) this.known.delete(id);
      void this.fetch();
    };
    void this.fetch();
  }

  /** Asks for the runs that the program remembers, the newest first. */
  private async fetch(): Promise<void> {
    clearTimeout(this.next);
    // one that is started meanwhile is not in the answer yet
    const before = [...this.known.values()];
    let found: Listed[];
    try {
      found = (await api.runs()).runs;
    } catch (e) {
      for (const job of this.known.values()) job.wait();
      return this.studio.failed(e);
    }
    for (const r of [...found].reverse()) {
      (this.known.get(r.id) ?? this.add(r.id, r.study)).show(r);
    }
    const all = new Set(found.map(r => r.id));
    for (const job of before) if (!job.over && !all.has(job.id)) job.show({ state: "failed", done: 0, total: 0 });
    this.soon();
  }

  /** Looks again while something goes on. */
  private soon(): void {
    clearTimeout(this.next);
    if ([...this.known.values()].some(j => !j.over)) this.next = window.setTimeout(() => void this.fetch(), document.hidden ? 5 * BETWEEN : BETWEEN);
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
      if (!this.known.has(id)) this.add(id, s.name);
      await this.fetch();
    } catch (e) { this.studio.failed(e); }
  }

  private add(id: string, name: string): Job {
    const job = new Job(id, name, what => void this.steer(id, what));
    this.known.set(id, job);
    this.jobs.prepend(job.box);
    return job;
  }

  private async steer(id: string, what: Steer): Promise<void> {
    try {
      await api.steer(id, what);
      await this.fetch();
    } catch (e) { this.studio.failed(e); }
  }
}
