// The page of the studio: asks what there is to show, and puts the pieces together.

import { bar } from "./bar";
import { Compare } from "./compare";
import { find, make, say, teach } from "./dom";
import { Editor } from "./editor";
import { begin } from "./language";
import { Motion } from "./motion";
import { Panels } from "./panels";
import { Parameters } from "./parameters";
import { Reach } from "./reach";
import { Runs } from "./runs";
import { Section } from "./section";
import { Studio } from "./studio";
import * as theme from "./theme";
import type { Start } from "./types";

/** The text of a page that was laid anew for another language. */
function kept(): { file: string; base: string; text: string } | null {
  try {
    const text = sessionStorage.getItem("laval-kept");
    sessionStorage.removeItem("laval-kept");
    return text ? JSON.parse(text) as { file: string; base: string; text: string } : null;
  } catch { return null; }
}

/** The file of a page that is loaded anew, if it is another than the one that the program was started with. */
function again(start: Start): string | null {
  const [entry] = performance.getEntriesByType("navigation") as PerformanceNavigationTiming[];
  try {
    const file = sessionStorage.getItem("laval-file");
    return entry?.type === "reload" && file && file !== start.file && start.folder_files.includes(file) ? file : null;
  } catch { return null; }
}

function remember(file: string): void {
  try { if (file) sessionStorage.setItem("laval-file", file); } catch { /* the file of the program is opened */ }
}

/** Tabs that show one of several things; arrow keys move between them. */
function tabs(host: HTMLElement, shown: (name: string) => void): (name: string) => void {
  const all = [...host.querySelectorAll<HTMLButtonElement>("[role=tab]")];
  const choose = (t: HTMLButtonElement) => {
    for (const o of all) {
      const on = o === t;
      o.setAttribute("aria-selected", String(on));
      o.tabIndex = on ? 0 : -1;
      const of = o.getAttribute("aria-controls");
      if (of) find(`#${of}`).classList.toggle("shown", on);
    }
    shown(t.dataset.tab!);
  };
  all.forEach((t, i) => {
    t.textContent = say(`tab-${t.dataset.tab}`);
    t.addEventListener("click", () => choose(t));
    t.addEventListener("keydown", e => {
      const by = e.key === "ArrowRight" ? 1 : e.key === "ArrowLeft" ? all.length - 1 : 0;
      if (by) { const to = all[(i + by) % all.length]; to.focus(); choose(to); }
    });
  });
  choose(all[0]);
  return name => { const t = all.find(o => o.dataset.tab === name); if (t) choose(t); };
}

function lay(start: Start): void {
  teach(start.words);
  document.documentElement.lang = start.language;
  document.head.dataset.decimal = start.decimal ?? ".";
  document.head.dataset.lengths = start.lengths ?? "m mm µm nm";
  for (const e of document.querySelectorAll<HTMLElement>("[data-say]")) e.textContent = say(e.dataset.say!);
  for (const e of document.querySelectorAll<HTMLElement>("[data-label]")) e.setAttribute("aria-label", say(e.dataset.label!));
  find("#version").textContent = start.version;

  const studio = new Studio(start), before = kept();
  studio.editor = new Editor(find("#editor"), () => start.completion, () => studio.changed(), () => find("[data-act=save]").click());
  const panels = new Panels(find("#figures"), studio);
  let reach: Reach | null = null;
  const parameters = new Parameters(find("#parameters"), studio, () => reach?.idle());
  reach = new Reach(find("#reach"), studio, () => parameters.free());
  panels.pulled = reach;
  studio.opened = () => {
    studio.speed = null;
    parameters.forget();
    panels.forget();
    reach?.idle();
    for (const pane of ["#results", "#pane-machine"]) find(pane).scrollTop = 0;
  };
  new Section(find("#section"), studio);
  const motion = new Motion(find("#space"), find("#motion"), studio, panels);
  const compare = new Compare(find("#compare"), studio, panels);
  new Runs(find("#runs"), studio);
  bar(studio, compare, () => motion.recolour());
  tabs(find("#machine-tabs"), name => void motion.show(name === "space"));
  const pane = tabs(find("#panes-tabs"), () => {});
  addEventListener("keydown", e => {
    if (!e.altKey || e.ctrlKey || !/^[123]$/.test(e.key)) return;
    e.preventDefault();
    const name = ["text", "machine", "figures"][+e.key - 1];
    pane(name);
    if (name === "text") studio.editor.focus(); else find(`#pane-${name}`).focus();
  });

  studio.editor.open(before?.text ?? start.text, { file: before?.file ?? start.file, base: before?.base ?? start.text }, false);
  const last = again(start);
  if (last && !before) void studio.open("file", last);
  studio.whenStatus(() => remember(studio.file));
  if (!studio.text) studio.changed();
  document.documentElement.dataset.ready = "";
}

theme.apply(theme.kept());
begin().then(lay, (e: unknown) => {
  document.body.append(make("p", { class: "fatal", role: "alert" }, e instanceof Error ? e.message : String(e)));
});
