// Completion in machine files: tables, kinds, keys, names, words.

import type { Completion as Offer, CompletionContext, CompletionResult } from "@codemirror/autocomplete";
import { say } from "./dom";
import type { Completion, Key, Kind } from "./types";

/** Table around a place: its name, and its kind where it states one. */
function table(before: string, after: string): { name: string; kind: string | null } | null {
  const heads = [...before.matchAll(/^[ \t]*\[\[?([\w.]+)\]\]?[^\n]*$/gm)], last = heads.at(-1);
  if (!last) return null;
  const next = after.search(/^[ \t]*\[/m);
  const inside = before.slice(last.index) + (next < 0 ? after : after.slice(0, next));
  return { name: last[1], kind: /^[ \t]*kind[ \t]*=[ \t]*"([^"\n]*)"/m.exec(inside)?.[1] ?? null };
}

const names = (text: string): string[] => [...new Set([...text.matchAll(/^[ \t]*name[ \t]*=[ \t]*"([^"\n]+)"/gm)].map(m => m[1]))];

const kinds = (all: Completion, name: string): Kind[] => name === "part" ? all.parts : name === "study" ? all.studies : [];

function about(k: Key): string {
  const rest = [k.unit && `${say("unit")}: ${k.unit}`, k.default && `${say("default")}: ${k.default}`, k.values?.length && k.values.join(", ")];
  return [k.doc, ...rest].filter(Boolean).join("\n");
}

export function complete(c: CompletionContext, all: Completion): CompletionResult | null {
  const text = c.state.doc.toString(), line = c.state.doc.lineAt(c.pos), start = text.slice(line.from, c.pos);
  if (/^\s*\[/.test(start)) {
    const from = line.from + start.indexOf("[");
    return { from, options: ["[machine]", "[[part]]", "[[study]]"].map(label => ({ label, type: "keyword" })), validFor: /^\[\[?\w*$/ };
  }
  const at = table(text.slice(0, line.from), text.slice(line.to));
  if (!at || start.includes("#")) return null;
  const of = kinds(all, at.name), keys = at.name === "machine" ? all.machine.keys : of.find(k => k.kind === at.kind)?.keys ?? [];
  const assigned = /^\s*([\w.]+)\s*=\s*(.*)$/.exec(start);
  if (assigned) {
    const inside = /"([^"]*)$/.exec(assigned[2]);
    if (!inside) return null;
    const from = c.pos - inside[1].length, key = keys.find(k => k.name === assigned[1]);
    const offer = (label: string, info?: string): Offer => ({ label, type: "enum", ...(info ? { info } : {}) });
    const options = assigned[1] === "kind" ? of.map(k => offer(k.kind, k.doc))
      : key?.values?.length ? key.values.map(v => offer(v))
      : /^(between|in|of|on|body|at|bodies)$/.test(assigned[1]) ? [...names(text), "ground"].map(v => offer(v)) : [];
    return options.length ? { from, options, validFor: /^[\w. -]*$/ } : null;
  }
  const word = /^\s*([\w.]*)$/.exec(start);
  if (!word || (!word[1] && !c.explicit)) return null;
  const kind: Key[] = of.length && !at.kind ? [{ name: "kind", doc: "" }] : [];
  const options = [...kind, ...keys].map((k): Offer => ({
    label: k.name, type: "property", apply: `${k.name} = `, boost: k.required ? 1 : 0, info: about(k), ...(k.unit ? { detail: k.unit } : {}),
  }));
  return options.length ? { from: c.pos - word[1].length, options, validFor: /^[\w.]*$/ } : null;
}
