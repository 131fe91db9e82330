// Windows over the page: what to open, and what to do about a file that changed on disk.

import { button, make, say } from "./dom";
import { filename } from "./filename";
import type { Studio } from "./studio";

function dialog(title: string, ...inside: HTMLElement[]): HTMLDialogElement {
  const d = make("dialog", { "aria-label": title }, make("h2", {}, title), ...inside);
  d.append(make("p", { class: "acts" }, button("close", () => d.close())));
  d.addEventListener("close", () => d.remove());
  d.addEventListener("click", e => { if (e.target === d) d.close(); });
  document.body.append(d);
  d.showModal();
  return d;
}

export function openDialog(studio: Studio): void {
  const { folder_files, examples } = studio.start;
  const lists: HTMLElement[] = [];
  const list = (key: string, what: "file" | "example", all: { name: string; title: string }[]) => {
    if (!all.length) return;
    lists.push(make("section", {}, make("h3", {}, say(key)), make("ul", { class: "choices" }, ...all.map(e => make("li", {},
      make("button", { type: "button", "data-open": e.name, onclick: () => { d.close(); void studio.open(what, e.name); } }, e.title || e.name))))));
  };
  list("files", "file", folder_files.map(name => ({ name, title: name })));
  list("examples", "example", examples);
  const d = dialog(say("open"), ...lists);
}

export function conflictDialog(studio: Studio, sentence: string, file: string): void {
  const d = dialog(say("changed-on-disk"), make("p", {}, sentence), make("p", { class: "acts" },
    button("overwrite", () => { d.close(); void studio.save(file, true); }),
    button("load-from-disk", () => { d.close(); void studio.open("file", file); })));
}

export function saveAs(studio: Studio): void {
  const name = make("input", { type: "text", class: "file-name", value: studio.file || "machine.toml", "aria-label": say("file-name"), "aria-describedby": "file-wrong", autocomplete: "off", spellcheck: "false" });
  const wrong = make("p", { class: "wrong", id: "file-wrong", role: "alert" });
  const go = () => {
    const file = filename(name.value);
    if (file === null) {
      name.setAttribute("aria-invalid", "true");
      wrong.textContent = say("file-name-wrong");
      return name.focus();
    }
    d.close();
    void studio.save(file);
  };
  name.addEventListener("input", () => { name.removeAttribute("aria-invalid"); wrong.textContent = ""; });
  name.addEventListener("keydown", e => { if (e.key === "Enter") { e.preventDefault(); go(); } });
  const d = dialog(say("save-as"), make("p", {}, make("label", {}, say("file-name"), " ", name), " ", button("save", go)), wrong);
  name.select();
}
