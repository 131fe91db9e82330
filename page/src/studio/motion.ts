// Which motion the machine in space shows: a mode, or the orbit under unbalance; play, amplitude, speed.

import { number, unit } from "../report/numbers";
import { make, say } from "./dom";
import type { Panels } from "./panels";
import type { SpaceView } from "./scene";
import type { Studio } from "./studio";
import type { Shape } from "./types";

const RPM = 30 / Math.PI;

export class Motion {
  private view: SpaceView | null = null;
  private loading = false;
  private playing = true;
  private shapes: Shape[] = [];
  private orbits: Shape[] = [];
  private readonly pick: HTMLSelectElement;
  private readonly fact: HTMLElement;
  private readonly speed: HTMLInputElement;
  private readonly reads: HTMLOutputElement;
  private built = "";
  private shown = false;

  constructor(private readonly host: HTMLElement, controls: HTMLElement, private readonly studio: Studio, private readonly panels: Panels) {
    this.pick = make("select", { "aria-label": say("motion"), onchange: () => this.choose() });
    this.fact = make("span", { class: "fact", role: "status" });
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
    amplitude.addEventListener("input", () => this.view?.setAmplitude(+amplitude.value / 100));
    this.speed = make("input", { type: "range", min: 0, max: 1000, value: 500, "aria-label": say("speed") });
    this.reads = make("output", {});
    this.speed.addEventListener("input", () => {
      const operating = studio.machine?.speed;
      if (!operating) return;
      studio.speed = operating * +this.speed.value / 500;
      this.read();
      panels.refresh();
    });
    this.speed.addEventListener("dblclick", () => { studio.speed = null; this.speed.value = "500"; this.read(); panels.refresh(); });
    controls.append(
      make("label", {}, say("motion"), " ", this.pick), play,
      make("label", {}, say("amplitude"), " ", amplitude), make("label", {}, say("speed"), " ", this.speed, this.reads), this.fact);
    panels.when(a => {
      if (a.want === "modes") { this.shapes = a.shapes ?? []; this.list(); this.cards(); }
      if (a.orbits) { this.orbits = a.orbits; this.list(); }
    });
    studio.whenMachine(() => { this.read(); this.draw(); });
  }

  private read(): void {
    const w = this.studio.speed ?? this.studio.machine?.speed;
    this.speed.disabled = !this.studio.machine?.speed;
    this.reads.textContent = w ? ` ${number(+(w * RPM).toPrecision(4))} ${say("rpm")}` : "";
  }

  /** The view is made when it is first looked at. */
  async show(on: boolean): Promise<void> {
    this.shown = on;
    if (!on || this.view || this.loading) { if (on) this.draw(); return; }
    this.loading = true;
    try {
      const { open } = await import("./scene.js" as string) as typeof import("./scene");
      this.view = open(this.host);
      this.view.play(this.playing);
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

  private all(): Shape[] { return [...this.shapes, ...this.orbits]; }

  private list(): void {
    const all = this.all(), at = Math.max(0, this.pick.selectedIndex);
    const texts = all.map(s => this.title(s));
    if (this.pick.options.length !== texts.length) this.pick.replaceChildren(...texts.map(t => make("option", {}, t)));
    else texts.forEach((t, i) => { if (this.pick.options[i].textContent !== t) this.pick.options[i].textContent = t; });
    this.pick.selectedIndex = Math.min(at, all.length - 1);
    this.choose();
  }

  private title(s: Shape): string { return `${/^\d+$/.test(s.name) ? say("mode", { count: s.name }) : s.name} · ${number(+(s.frequency / (2 * Math.PI)).toPrecision(4))}${unit(say("hertz"))}`; }

  private choose(): void {
    const s = this.all()[this.pick.selectedIndex] ?? null;
    this.view?.whirls(s);
    this.fact.textContent = s ? `${say(`whirl-${s.whirl}`)}, ${say(s.growth > 0 ? "grows" : "decays", { value: number(+Math.abs(s.growth).toPrecision(3)) })}` : "";
    this.panels.box("modes").querySelectorAll(".mode").forEach((c, i) => c.setAttribute("aria-pressed", String(i === this.pick.selectedIndex)));
  }

  /** The cards of the modes choose too. */
  private cards(): void {
    const cards = [...this.panels.box("modes").querySelectorAll<HTMLElement>(".mode")];
    if (cards.length !== this.shapes.length) return;
    cards.forEach((c, i) => {
      c.setAttribute("role", "button");
      c.tabIndex = 0;
      const act = () => { this.pick.selectedIndex = i; this.choose(); };
      c.addEventListener("click", act);
      c.addEventListener("keydown", e => { if (e.key === "Enter" || e.key === " ") { e.preventDefault(); act(); } });
    });
    cards.forEach((c, i) => c.setAttribute("aria-pressed", String(i === this.pick.selectedIndex)));
  }

  recolour(): void { this.view?.recolour(); }
}
