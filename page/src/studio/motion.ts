// Which motion the machine in space shows: a mode, the response to unbalance, a transient; play, amplitude, speed.

import { minus, number, unit } from "../report/numbers";
import * as api from "./api";
import { make, say, set, write } from "./dom";
import { Lane } from "./lane";
import type { Panels } from "./panels";
import type { SpaceView } from "./scene";
import type { Studio } from "./studio";
import type { MotionKind, Shape } from "./types";

const RPM = 30 / Math.PI;

/** Digits of a factor. */
const factor = (v: number): string => number(+v.toPrecision(2));

/** What can be chosen: a mode that is known, or a motion that is computed once it is chosen. */
interface Entry { key: string; title: string; shape: Shape | null; motion: MotionKind | null }

export class Motion {
  private view: SpaceView | null = null;
  private loading = false;
  private playing = true;
  private shapes: Shape[] = [];
  private entries: Entry[] = [];
  /** What is wanted, and what is shown of it: the wanted mode may not be known yet, or be no more. */
  private wish = "mode:0";
  private chosen = "mode:0";
  /** The last motions that were computed, and of what. */
  private found: { key: string; text: string; speed: number | null; shapes: Shape[]; error: string } | null = null;
  private readonly lane: Lane<{ key: string; motion: MotionKind; text: string; speed: number | null }>;
  private readonly clock: HTMLElement;
  private readonly pick: HTMLSelectElement;
  private readonly fact: HTMLElement;
  private readonly speed: HTMLInputElement;
  private readonly reads: HTMLOutputElement;
  private built = "";
  private shown = false;

  constructor(private readonly host: HTMLElement, controls: HTMLElement, private readonly studio: Studio, private readonly panels: Panels) {
    this.pick = make("select", { "aria-label": say("motion"), autocomplete: "off", onchange: () => this.take(this.pick.value) });
    this.fact = make("span", { class: "fact", role: "status" });
    this.clock = make("span", { class: "clock", "aria-hidden": "true" });
    this.lane = new Lane((asked, signal) => this.compute(asked, signal), e => studio.failed(e));
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.playing = !still;
    const play = make("button", { type: "button", "aria-pressed": String(!still) }, say(still ? "play" : "pause"));
    play.addEventListener("click", () => {
      const on = play.getAttribute("aria-pressed") !== "true";
      play.setAttribute("aria-pressed", String(on));
      play.textContent = say(on ? "pause" : "play");
      this.playing = on;
      this.view?.play(on);
    });
    const amplitude = make("input", { type: "range", min: 10, max: 300, value: 100, "aria-label": say("amplitude") });
    amplitude.addEventListener("input", () => { this.view?.setAmplitude(+amplitude.value / 100); this.state(); });
    this.speed = make("input", { type: "range", min: 0, max: 1000, value: 500, "aria-label": say("speed") });
    this.reads = make("output", {});
    this.speed.addEventListener("input", () => {
      const operating = studio.machine?.speed;
      if (!operating) return;
      studio.speed = operating * +this.speed.value / 500;
      this.read();
      panels.refresh();
      this.list();
    });
    this.speed.addEventListener("dblclick", () => { studio.speed = null; this.speed.value = "500"; this.read(); panels.refresh(); this.list(); });
    controls.append(
      make("label", {}, say("motion"), " ", this.pick), play,
      make("label", {}, say("amplitude"), " ", amplitude), make("label", {}, say("speed"), " ", this.speed, this.reads), this.fact, this.clock);
    panels.when(a => {
      if (a.want === "modes") { this.shapes = a.shapes ?? []; this.list(); this.cards(); }
    });
    studio.whenText(() => this.ask());
    studio.whenMachine(() => { this.read(); this.draw(); this.list(); });
  }

  private read(): void {
    const w = this.studio.speed ?? this.studio.machine?.speed;
    this.speed.disabled = !this.studio.machine?.speed;
    write(this.reads, w ? ` ${number(+(w * RPM).toPrecision(4))} ${say("rpm")}` : "");
  }

  /** The view is made when it is first looked at. */
  async show(on: boolean): Promise<void> {
    this.shown = on;
    if (!on) this.lane.stop();
    if (!on || this.view || this.loading) { if (on) { this.draw(); this.choose(); } return; }
    this.loading = true;
    try {
      const { open } = await import("./scene.js" as string) as typeof import("./scene");
      this.view = open(this.host);
      this.view.play(this.playing);
      this.view.at = t => this.time(t);
      this.host.dataset.ready = "";
      this.draw();
      this.choose();
    } catch (e) {
      // a browser without WebGL keeps the section
      this.host.replaceChildren(make("p", { class: "none" }, say("no-space"), " ", String(e)));
    }
    this.loading = false;
  }

  private draw(): void {
    const scene = this.studio.machine?.scene ?? null, key = JSON.stringify(scene);
    if (!this.view || !this.shown || key === this.built) return;
    this.built = key;
    this.view.show(scene);
  }

  /** Modes, responses and transients of the machine. */
  private all(): Entry[] {
    const modes: Entry[] = this.shapes.map((shape, i) => ({ key: `mode:${i}`, title: this.title(shape), shape, motion: null }));
    const machine = this.studio.machine, speed = this.studio.speed ?? machine?.speed;
    if (!speed) return modes;
    const value = number(+(speed * RPM).toPrecision(4)), known = (key: string) => this.found?.key === key ? this.found.shapes : [];
    const states = known("nonlinear");
    const one = (i: number) => states.length > 1 ? `, ${say("motion-state", { count: i + 1 })}` : "";
    const nonlinear = (states.length ? states : [null]).map((shape, i): Entry => ({
      key: i ? `nonlinear:${i}` : "nonlinear", shape, motion: { kind: "nonlinear" },
      title: say("motion-nonlinear", { value }) + one(i) + (shape?.stability === "unstable" ? `, ${say("motion-unstable")}` : ""),
    }));
    const own = (machine?.studies ?? []).filter(s => s.kind === "transient").map((s): Entry => ({
      key: `transient:${s.name}`, title: say("motion-transient", { name: s.name }), shape: known(`transient:${s.name}`)[0] ?? null, motion: { kind: "transient", study: s.name },
    }));
    return [
      ...modes,
      { key: "forced", title: say("motion-forced", { value }), shape: known("forced")[0] ?? null, motion: { kind: "forced" } },
      ...nonlinear, ...own,
      { key: "transient", title: say("motion-start", { value }), shape: known("transient")[0] ?? null, motion: { kind: "transient" } },
    ];
  }

  private list(): void {
    this.entries = this.all();
    const options = this.pick.options;
    if (options.length !== this.entries.length) this.pick.replaceChildren(...this.entries.map(e => make("option", { value: e.key }, e.title)));
    else this.entries.forEach((e, i) => {
      write(options[i], e.title);
      if (options[i].value !== e.key) options[i].value = e.key;
    });
    const has = (key: string) => this.entries.some(e => e.key === key), kind = this.wish.split(":")[0];
    this.chosen = [this.wish, kind].find(has) ?? this.entries[0]?.key ?? "mode:0";
    if (this.pick.value !== this.chosen) this.pick.value = this.chosen;
    this.choose();
  }

  private title(s: Shape): string { return `${say("mode", { count: s.name })} · ${number(+(s.frequency / (2 * Math.PI)).toPrecision(4))}${unit(say("hertz"))}`; }

  private get entry(): Entry | null { return this.entries.find(e => e.key === this.chosen) ?? null; }

  private take(key: string): void {
    this.wish = this.chosen = key;
    this.view?.rewind();
    if (this.pick.value !== key) this.pick.value = key;
    this.choose();
  }

  private choose(): void {
    this.ask();
    this.view?.whirls(this.entry?.shape ?? null);
    this.state();
    this.panels.box("modes").querySelectorAll(".mode").forEach((c, i) => set(c, "aria-pressed", String(this.chosen === `mode:${i}`)));
  }

  /** Computes the chosen motion for the text and the speed that are now, where it is seen. */
  private ask(): void {
    const motion = this.entry?.motion, { text, speed } = this.studio;
    if (!motion || !this.shown) { this.asked = ""; return this.lane.stop(); }
    const key = [motion.kind, motion.study].filter(x => x !== undefined).join(":"), f = this.found;
    if (f && f.key === key && f.text === text && f.speed === speed) return;
    if (f && f.key !== key) this.found = null;
    // it is on its way already
    const asked = `${key}|${speed}|${text}`;
    if (this.asked === asked && !this.lane.idle) return;
    this.asked = asked;
    this.lane.ask({ key, motion, text, speed });
  }

  private async compute(asked: { key: string; motion: MotionKind; text: string; speed: number | null }, signal: AbortSignal): Promise<void> {
    const { key, motion, text, speed } = asked;
    await api.answer({ text, want: ["motion"], motion, ...(speed !== null ? { speed } : {}) }, signal, a => {
      // of a text with a mistake the last motion stays
      const kept = a.error !== undefined && this.studio.errors > 0 && this.found?.key === key ? this.found.shapes : [];
      this.found = { key, text, speed, shapes: a.motions ?? kept, error: a.error ?? "" };
      this.list();
    });
  }

  /** What is known of the motion. */
  private state(): void {
    const e = this.entry, s = e?.shape, view = this.view;
    let fact = "";
    if (e?.motion && this.found?.error) fact = this.found.error;
    else if (e?.motion && !s) fact = this.shown ? say("computing") : "";
    else if (e?.motion && s) fact = say("shown", { value: s.largest ?? "", from: factor(view?.enlarged ?? 0), to: factor(view?.slowed ?? 0) });
    else if (s) fact = `${say(`whirl-${s.whirl}`)}, ${say(s.growth > 0 ? "grows" : "decays", { value: number(+Math.abs(s.growth).toPrecision(3)) })}`;
    write(this.fact, fact);
    if (!s?.frames || s.frames.closed) this.clock.textContent = "";
  }

  /** Time of a transient, a few times a second. */
  private time(t: number): void {
    const now = performance.now();
    if (now - this.ticked < 100 || this.entry?.shape?.frames?.closed !== false) return;
    this.ticked = now;
    this.clock.textContent = say("time", { value: minus(t.toFixed(t < 10 ? 3 : 1)) });
  }

  private ticked = 0;
  private asked = "";

  /** The cards of the modes choose too. */
  private cards(): void {
    const cards = [...this.panels.box("modes").querySelectorAll<HTMLElement>(".mode")];
    if (cards.length !== this.shapes.length) return;
    // a card whose drawing was changed in place is one already
    cards.filter(c => !c.hasAttribute("role")).forEach(c => {
      const i = cards.indexOf(c);
      c.setAttribute("role", "button");
      c.tabIndex = 0;
      const act = () => this.take(`mode:${i}`);
      c.addEventListener("click", act);
      c.addEventListener("keydown", e => { if (e.key === "Enter" || e.key === " ") { e.preventDefault(); act(); } });
    });
    cards.forEach((c, i) => set(c, "aria-pressed", String(this.chosen === `mode:${i}`)));
  }

  recolour(): void { this.view?.recolour(); }
}
