// The bar at the top: file, undo, pins, share, language, theme; and what must be known of the state.

import * as api from "./api";
import type { Compare } from "./compare";
import { conflictDialog, openDialog, saveAs } from "./dialogs";
import { button, find, make, say, write } from "./dom";
import { choose } from "./language";
import type { Studio } from "./studio";
import * as theme from "./theme";

async function share(studio: Studio, compare: Compare): Promise<void> {
  try {
    const blob = await api.share(studio.text, compare.pins.map(({ name, text }) => ({ name, text })));
    const url = URL.createObjectURL(blob), name = `${(studio.machine?.name || "machine").replace(/[^\p{L}\p{N}_-]+/gu, "-")}.html`;
    const a = make("a", { href: url, download: name });
    document.body.append(a);
    a.click();
    a.remove();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
  } catch (e) { studio.failed(e); }
}

export function bar(studio: Studio, compare: Compare, recoloured: () => void): void {
  const host = find("#bar"), status = find("#status");
  const file = make("span", { id: "file" });
  const undo = button("undo", () => studio.editor.undo(), { "data-act": "undo" });
  const redo = button("redo", () => studio.editor.redo(), { "data-act": "redo" });
  const save = button("save", () => { if (studio.file && studio.base) void studio.save(); else saveAs(studio); }, { "data-act": "save" });
  const language = make("select", { id: "language", "aria-label": say("language") }, ...studio.start.languages.map(l => make("option", { value: l.code, lang: l.code }, l.name)));
  language.value = studio.start.language;
  language.addEventListener("change", () => void choose(language.value).then(search => {
    // words are everywhere: the page is laid anew, with the text as it is
    try {
      sessionStorage.setItem("laval-kept", JSON.stringify({ file: studio.file, base: studio.base, text: studio.text }));
    } catch { /* the file is read again */ }
    leaving = true;
    if (location.search === search) location.reload(); else location.search = search;
  }, (e: unknown) => {
    language.value = studio.start.language;
    studio.failed(e);
  }));
  let now = theme.kept();
  const shade = make("button", { type: "button", "data-act": "theme" }, say(`theme-${now}`));
  shade.addEventListener("click", () => {
    now = theme.next(now);
    theme.apply(now);
    shade.textContent = say(`theme-${now}`);
    recoloured();
  });
  host.append(
    file,
    make("span", { class: "group" }, button("open", () => openDialog(studio), { "data-act": "open" }), save, button("save-as", () => saveAs(studio), { "data-act": "save-as" })),
    make("span", { class: "group" }, undo, redo),
    make("span", { class: "group" }, button("pin", () => compare.pin(), { "data-act": "pin", title: say("pin-help") }), button("share", () => void share(studio, compare), { "data-act": "share", title: say("share-help") })),
    make("span", { class: "group right" }, language, shade));

  let leaving = false, said = "";
  studio.conflict = (sentence, file) => conflictDialog(studio, sentence, file);
  studio.whenStatus(() => {
    write(file, `${studio.file || say("new-file")}${studio.unsaved ? " •" : ""}`);
    file.title = studio.unsaved ? say("unsaved") : "";
    undo.disabled = !studio.editor.undos;
    redo.disabled = !studio.editor.redos;
    const title = `${studio.machine?.name || studio.file || "laval"} · laval studio`;
    if (document.title !== title) document.title = title;
    const n = studio.errors, first = studio.diagnostics.find(d => d.severity === "error");
    const unsent = studio.reachable ? [] : studio.unsent.map(path => studio.parameter(path)?.label ?? path);
    const state = `${studio.reachable}|${unsent.join()}|${studio.notice}|${n}|${first?.message}|${first?.from}`;
    if (state === said) return;
    said = state;
    status.replaceChildren();
    status.className = "";
    if (!studio.reachable) {
      status.className = "lost";
      status.textContent = say("lost") + (unsent.length ? ` ${say("unsent", { name: unsent.join(", ") })}` : "");
    } else if (studio.notice) {
      status.className = "notice";
      status.append(studio.notice, " ", button("close", () => studio.tell("")));
    } else if (first) {
      status.className = "wrong";
      status.append(make("button", { type: "button", class: "link", onclick: () => studio.editor.goto(first.from) }, `${say("errors", { count: n })}: ${first.message}`));
    }
  });
  addEventListener("beforeunload", e => { if (studio.unsaved && !leaving && studio.base) e.preventDefault(); });
  addEventListener("keydown", e => {
    if (!(e.ctrlKey || e.metaKey) || e.defaultPrevented) return;
    const inside = e.target instanceof HTMLInputElement && e.target.type === "text";
    const key = e.key.toLowerCase();
    if (key === "s") { e.preventDefault(); save.click(); }
    else if (key === "z" && !e.shiftKey && !inside) { e.preventDefault(); studio.editor.undo(); }
    else if ((key === "y" || (key === "z" && e.shiftKey)) && !inside) { e.preventDefault(); studio.editor.redo(); }
  });
}
