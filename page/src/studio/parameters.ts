// Every number of the machine: a slider, the value as the file writes it, and whether it may be moved by the program.

import * as api from "./api";
import { bare } from "./ask";
import { say, make } from "./dom";
import { Lane } from "./lane";
import { fromSlider, toSlider, written } from "./quantity";
import type { Studio } from "./studio";
import type { Free, Parameter, Range, Set as Wanted } from "./types";

/** The label without the name of the part, which stands above. */
function short(p: Parameter): string {
  const part = p.path.split(".")[0].replaceAll("_", " "), label = p.label.replaceAll("_", " ");
  return label.length > part.length + 1 && label.startsWith(part) ? label.slice(part.length).replace(/^[,\s]+/, "") : label;
}

interface Row {
  box: HTMLElement;
  slider: HTMLInputElement;
  written: HTMLInputElement;
  free: HTMLInputElement;
  low: HTMLInputElement;
  high: HTMLInputElement;
  of: Parameter;
  /** Range of the slider: it stays as long as the value is inside, so that a thumb that is moved does not shift its own scale. */
  from: number;
  to: number;
  /** Another number of the file limits the range. */
  narrow: boolean;
  unit: HTMLElement;
  /** Text that stands in the field. */
  shown: string;
  /** What was typed was refused while the file had this value: it stays until it is mended. */
  refused: string | null;
}

export class Parameters {
  private readonly rows = new Map<string, Row>();
  private readonly groups = new Map<string, HTMLDetailsElement>();
  private sliding = false;

  constructor(private readonly host: HTMLElement, private readonly studio: Studio, private readonly released: () => void) {
    this.lane = new Lane(async (text, signal) => this.narrow(text, (await api.ranges(text, signal)).ranges), e => { if (!(e instanceof api.Refused)) studio.failed(e); });
    studio.whenMachine(() => { this.update(); this.soon(); });
    studio.refused = (set, sentence) => this.refuse(set, sentence);
  }

  private readonly lane: Lane<string>;
  private later = 0;
  private narrowed = "";

  /** Ranges are narrowed once nothing changes for a moment: each takes reading the file several times. */
  private soon(): void {
    clearTimeout(this.later);
    this.lane.stop();
    if (this.studio.text === this.narrowed) return;
    this.later = window.setTimeout(() => { if (this.sliding) this.soon(); else if (!this.studio.errors) this.lane.ask(this.studio.text); }, 400);
  }

  private narrow(text: string, ranges: Range[]): void {
    if (text !== this.studio.text || this.sliding) return;
    this.narrowed = text;
    const by = new Map(ranges.map(r => [r.path, r]));
    for (const [path, row] of this.rows) {
      const to = by.get(path) ?? row.of;
      // a range that another number does not limit stays, so that the thumb keeps its place
      if (!by.has(path) && !row.narrow) continue;
      row.narrow = by.has(path);
      [row.from, row.to] = [to.low, to.high];
      row.slider.value = String(toSlider(row.of.value, row.from, row.to));
    }
  }

  /** Parameters that the program may move, with their ranges. */
  free(): Free[] {
    return [...this.rows.values()].filter(r => r.free.checked)
      .map(r => ({ path: r.of.path, low: this.bound(r, r.low, r.from), high: this.bound(r, r.high, r.to) }));
  }

  /** A bound is written in the units of the file. */
  private bound(r: Row, input: HTMLInputElement, otherwise: number): number {
    const v = bare(input.value);
    return v !== null ? v / written(r.of).factor : otherwise;
  }

  /** Another machine: nothing of the last one stays. */
  forget(): void {
    for (const row of this.rows.values()) row.box.remove();
    this.rows.clear();
  }

  /** Fields keep what was refused, with the reason; sliders go back. */
  private refuse(set: Wanted[], sentence: string): void {
    for (const s of set) {
      const row = this.rows.get(s.path);
      if (!row || !("written" in s)) continue;
      row.refused = row.of.shown;
      row.shown = row.written.value = s.written;
      row.written.setAttribute("aria-invalid", "true");
      row.written.title = sentence;
    }
    this.update();
  }

  private mended(row: Row): void {
    row.refused = null;
    row.written.removeAttribute("aria-invalid");
    row.written.removeAttribute("title");
  }

  private update(): void {
    const all = this.studio.machine?.parameters ?? [], known = new Set(all.map(p => p.path)), active = document.activeElement;
    let less = false;
    for (const [path, row] of this.rows) if (!known.has(path)) { less ||= row.free.checked; row.box.remove(); this.rows.delete(path); }
    if (less) this.released();
    for (const p of all) {
      const row = this.rows.get(p.path) ?? this.add(p);
      row.of = p;
      // what waits for the connection stays as it was wanted
      if (this.studio.waits(p.path) && !this.studio.reachable) continue;
      if (p.value < row.from || p.value > row.to) { row.from = p.low; row.to = p.high; }
      // an input that is written to is laid out anew even when nothing changes
      const slides = this.sliding && row.slider === active, at = String(toSlider(p.value, row.from, row.to));
      if (!slides && row.slider.value !== at) row.slider.value = at;
      if (row.refused !== null && row.refused !== p.shown) this.mended(row);
      if (row.shown === p.shown || row.written === active || row.refused !== null) continue;
      row.shown = row.written.value = p.shown;
      row.slider.setAttribute("aria-valuetext", p.shown);
    }
    for (const [name, group] of this.groups) {
      if (group.querySelector(".row")) continue;
      group.remove();
      this.groups.delete(name);
    }
  }

  private group(path: string): HTMLElement {
    const name = path.includes(".") ? path.slice(0, path.indexOf(".")) : "";
    let group = this.groups.get(name);
    if (!group) {
      group = make("details", { open: this.groups.size < 6 }, make("summary", {}, name || say("machine")));
      this.groups.set(name, group);
      this.host.append(group);
    }
    return group;
  }

  private add(p: Parameter): Row {
    const slider = make("input", { type: "range", min: 0, max: 1000, "aria-label": p.label, title: p.doc });
    const field = make("input", { type: "text", class: "written", spellcheck: "false", autocomplete: "off", "aria-label": `${p.label}, ${say("value")}` });
    const free = make("input", { type: "checkbox", "aria-label": `${p.label}, ${say("released")}`, title: say("released-help") });
    const end = (key: string) => make("input", { type: "text", inputmode: "decimal", class: "bound", "aria-label": `${p.label}, ${say(key)}`, title: p.unit });
    const unit = make("span", {});
    const low = end("from"), high = end("to");
    const range = make("div", { class: "range", hidden: true }, say("range"), " ", low, "–", high, " ", unit);
    const box = make("div", { class: "row", "data-path": p.path },
      make("label", { class: "name", title: p.doc }, short(p)), slider, field, make("label", { class: "release" }, free, make("span", {}, say("released"))), range);
    const row: Row = { box, slider, written: field, free, low, high, of: p, from: p.low, to: p.high, narrow: false, unit, shown: "", refused: null };
    slider.addEventListener("input", () => {
      if (!this.sliding) { this.sliding = true; this.studio.begin(); }
      this.studio.change([{ path: row.of.path, value: fromSlider(+slider.value, row.from, row.to) }]);
    });
    const done = () => { if (this.sliding) { this.sliding = false; this.studio.end(); } };
    slider.addEventListener("change", done);
    slider.addEventListener("blur", done);
    field.addEventListener("change", () => {
      const text = field.value.trim();
      row.shown = field.value;
      this.mended(row);
      // a number alone has the unit that the field shows
      const unit = bare(text) === null ? "" : row.of.display_unit;
      if (text && text !== row.of.shown) this.studio.change([{ path: row.of.path, written: unit ? `${text} ${unit}` : text }]);
      else row.shown = field.value = row.of.shown;
    });
    field.addEventListener("keydown", e => {
      if (e.key === "Escape") { this.mended(row); row.shown = field.value = row.of.shown; field.blur(); }
    });
    for (const bound of [low, high]) bound.addEventListener("input", () => {
      if (bound.value.trim() && bare(bound.value) === null) bound.setAttribute("aria-invalid", "true"); else bound.removeAttribute("aria-invalid");
    });
    free.addEventListener("change", () => {
      range.hidden = !free.checked;
      box.classList.toggle("free", free.checked);
      if (free.checked && !low.value) {
        const { unit, factor } = written(row.of);
        row.unit.textContent = unit;
        [low.value, high.value] = [row.from, row.to].map(v => String(+(v * factor).toPrecision(4)));
      }
      this.released();
    });
    this.rows.set(p.path, row);
    this.group(p.path).append(box);
    return row;
  }
}
