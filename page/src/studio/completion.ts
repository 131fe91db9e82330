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

const kinds = (all: Completion, name: string): Kind[] => name === "part" ? all.parts : name === "study" ? all.studies : all.blocks?.[name]?.kinds ?? [];

function about(k: Key): string {
  const rest = [k.unit && `${say("unit")}: ${k.unit}`, k.default && `${say("default")}: ${k.default}`, k.values?.length && k.values.join(", ")];
  return [k.doc, ...rest].filter(Boolean).join("\n");
}

/** What may stand behind the equals sign: words inside quotation marks, or whole values before any is written. */
function values(c: CompletionContext, name: string, written: string, keys: Key[], of: Kind[], text: string): CompletionResult | null {
  const inside = /"([^"]*)$/.exec(written), quotes = (written.match(/"/g) ?? []).length % 2 === 1;
  const offer = (label: string, info?: string): Offer => ({ label, type: "enum", ...(info ? { info } : {}) });
  const own = keys.find(k => k.name === name)?.values ?? [];
  if (inside && quotes) {
    const words = name === "kind" ? of.map(k => offer(k.kind, k.doc))
      : own.some(v => v.startsWith('"')) ? own.filter(v => v.startsWith('"')).map(v => offer(v.slice(1, -1)))
      : /^(between|in|of|on|body|at|bodies)$/.test(name) ? [...names(text), "ground"].map(v => offer(v)) : [];
    return words.length ? { from: c.pos - inside[1].length, options: words, validFor: /^[\w. -]*$/ } : null;
  }
  const begun = /^[\w{]*$/.exec(written);
  if (!begun) return null;
  const whole = name === "kind" ? of.map(k => offer(`"${k.kind}"`, k.doc)) : own.map(v => offer(v));
  return whole.length && (written || c.explicit) ? { from: c.pos - written.length, options: whole, validFor: /^[\w{]*$/ } : null;
}

export function complete(c: CompletionContext, all: Completion): CompletionResult | null {
  const text = c.state.doc.toString(), line = c.state.doc.lineAt(c.pos), start = text.slice(line.from, c.pos);
  if (/^\s*\[/.test(start)) {
    const from = line.from + start.indexOf("[");
    const others = Object.entries(all.blocks ?? {}).map(([word, b]) => b.several ? `[[${word}]]` : `[${word}]`);
    const labels = [...new Set(["[machine]", "[[part]]", "[[study]]", ...others])];
    // brackets that the editor closed are replaced too
    const to = c.pos + (/^\]*/.exec(text.slice(c.pos))?.[0].length ?? 0);
    return { from, to, options: labels.map(label => ({ label, type: "keyword" })), validFor: /^\[\[?\w*$/ };
  }
  const at = table(text.slice(0, line.from), text.slice(line.to));
  if (!at || start.includes("#")) return null;
  const of = kinds(all, at.name), single = of.length === 1 && at.name !== "part" && at.name !== "study" ? of[0] : undefined;
  const keys = at.name === "machine" ? all.machine.keys : (of.find(k => k.kind === at.kind) ?? single)?.keys ?? [];
  const assigned = /^\s*([\w.]+)\s*=\s*(.*)$/.exec(start);
  if (assigned) return values(c, assigned[1], assigned[2], keys, of, text);
  const word = /^\s*([\w.]*)$/.exec(start);
  if (!word || (!word[1] && !c.explicit)) return null;
  const kind: Key[] = of.length && !at.kind && !single ? [{ name: "kind", doc: "" }] : [];
  const options = [...kind, ...keys].map((k): Offer => ({
    label: k.name, type: "property", apply: `${k.name} = `, boost: k.required ? 1 : 0, info: about(k), ...(k.unit ? { detail: k.unit } : {}),
  }));
  return options.length ? { from: c.pos - word[1].length, options, validFor: /^[\w.]*$/ } : null;
}
