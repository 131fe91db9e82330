// Makes the drawings of the report interactive.

import { Figure } from "./figure";
import { drawn, exercise } from "./selfcheck";

const errors: string[] = [];
addEventListener("error", e => errors.push(String(e.message)));
addEventListener("unhandledrejection", e => errors.push(String(e.reason)));
addEventListener("securitypolicyviolation", e => errors.push("blocked: " + e.violatedDirective));
const consoleError = console.error;
console.error = (...a: unknown[]) => { errors.push(a.join(" ")); consoleError.apply(console, a); };

addEventListener("DOMContentLoaded", () => {
  const root = document.documentElement, boxes = [...document.querySelectorAll<HTMLElement>("figure.fig")];
  const figures: Figure[] = [];
  for (const box of boxes) {
    try { figures.push(new Figure(box)); } catch (e) { errors.push(String(e)); }
  }
  addEventListener("beforeprint", () => document.querySelectorAll("details").forEach(d => { if (!d.open) { d.open = true; d.dataset.print = ""; } }));
  addEventListener("afterprint", () => document.querySelectorAll<HTMLDetailsElement>("details[data-print]").forEach(d => { d.open = false; delete d.dataset.print; }));
  if (location.hash === "#selfcheck") {
    for (const f of figures) { try { exercise(f); } catch (e) { errors.push(f.box.id + ": " + e); } }
    root.dataset.figures = String(boxes.length);
    root.dataset.drawn = String(figures.filter(drawn).length);
    root.dataset.overflow = String(root.scrollWidth > innerWidth + 1);
    root.dataset.errors = JSON.stringify(errors);
  }
});
