// Plays the motion of rotor, tracks and balls: frames are in axes that turn with the rotor, the spin angle turns them.

import { decimal } from "./numbers";

interface Frames {
  /** Times, spin angles, places of each circle. */
  t: number[];
  p: number[];
  c: { x: number[]; y: number[] }[];
}

export class Player {
  private readonly data: Frames;
  private readonly controls: HTMLElement;
  private readonly button: HTMLButtonElement;
  private readonly label: string;
  private readonly slider: HTMLInputElement;
  private readonly axes: HTMLSelectElement;
  private readonly pace: HTMLSelectElement;
  private readonly output: HTMLOutputElement;
  private readonly circles: SVGCircleElement[];
  private readonly keys: (Element | null)[];
  private at: number;
  private running = false;

  constructor(box: HTMLElement) {
    this.data = JSON.parse(box.querySelector("script")!.textContent!) as Frames;
    this.controls = box.querySelector(".controls")!;
    this.button = this.controls.querySelector("button")!;
    this.label = this.button.textContent!;
    this.slider = this.controls.querySelector("input")!;
    [this.axes, this.pace] = this.controls.querySelectorAll("select");
    this.output = this.controls.querySelector("output")!;
    this.circles = [...box.querySelectorAll("circle")];
    this.keys = this.circles.map(c => c.classList.contains("centre") ? c.previousElementSibling : null);
    this.at = this.last();
    this.controls.hidden = false;
    this.button.addEventListener("click", () => this.running ? this.stop() : this.play());
    this.slider.addEventListener("input", () => { this.at = this.first() + +this.slider.value / 1000 * this.length(); this.draw(); });
    this.axes.addEventListener("change", () => { this.pace.value = this.axes.value === "0" ? "1" : "0"; this.draw(); });
    this.draw();
  }

  private first(): number { return this.data.t[0]; }
  private last(): number { return this.data.t[this.data.t.length - 1]; }
  private length(): number { return Math.max(this.last() - this.first(), 1e-300); }

  /** Frame before a time, and how far it is to the next. */
  private place(t: number): [number, number, number] {
    const ts = this.data.t;
    let lo = 0, hi = ts.length - 1;
    while (hi - lo > 1) { const mid = (lo + hi) >> 1; if (ts[mid] <= t) lo = mid; else hi = mid; }
    const span = ts[hi] - ts[lo];
    return [lo, hi, span > 0 ? Math.min(1, Math.max(0, (t - ts[lo]) / span)) : 0];
  }

  private draw(): void {
    const [a, b, w] = this.place(this.at), mix = (v: number[]) => (1 - w) * v[a] + w * v[b];
    const phase = mix(this.data.p), turn = this.axes.value === "0" ? phase : 0;
    const c = Math.cos(turn), s = Math.sin(turn);
    this.circles.forEach((e, k) => {
      const x = mix(this.data.c[k].x), y = mix(this.data.c[k].y);
      const px = c * x - s * y, py = s * x + c * y;
      e.setAttribute("cx", px.toFixed(2));
      e.setAttribute("cy", (-py).toFixed(2));
      this.keys[k]?.setAttribute("d", `M${px.toFixed(2)} ${(-py).toFixed(2)}l${(30 * c).toFixed(2)} ${(-30 * s).toFixed(2)}`);
    });
    this.slider.value = String(Math.round(1000 * (this.at - this.first()) / this.length()));
    const rate = a === b ? 0 : (this.data.p[b] - this.data.p[a]) / (this.data.t[b] - this.data.t[a]);
    const d = this.controls.dataset, write = (v: number) => v.toPrecision(4).replace(".", decimal());
    this.output.textContent = `${write(this.at)} ${d.time}, ${write(rate / +d.size!)} ${d.speed}`;
  }

  /** Seconds of the motion in a second of the clock. */
  private rate(): number {
    if (this.pace.value === "0") return this.length() / 20;
    const turns = Math.abs(this.data.p[this.data.p.length - 1] - this.data.p[0]) / (2 * Math.PI);
    return this.length() / Math.max(turns, 1);
  }

  play(): void {
    if (this.at >= this.last()) this.at = this.first();
    this.running = true;
    this.button.textContent = this.button.dataset.pause!;
    let before = performance.now();
    const next = (now: number) => {
      if (!this.running) return;
      this.at = Math.min(this.last(), this.at + (now - before) / 1000 * this.rate());
      before = now;
      this.draw();
      if (this.at >= this.last()) this.stop(); else requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  }

  stop(): void {
    this.running = false;
    this.button.textContent = this.label;
  }

  /** Runs through slider, axes and play; whether all that moves was drawn. */
  exercise(): boolean {
    const places = () => this.circles.map(c => c.getAttribute("cx") + " " + c.getAttribute("cy")).join();
    const seen = new Set<string>();
    for (const axes of ["1", "0"]) for (const at of [0, 400, 1000]) {
      this.axes.value = axes;
      this.slider.value = String(at);
      this.slider.dispatchEvent(new Event("input"));
      seen.add(places());
    }
    this.axes.value = "1";
    this.axes.dispatchEvent(new Event("change"));
    this.play();
    this.stop();
    return seen.size > 3 && ![...seen].some(p => /NaN|undefined/.test(p));
  }
}
