// Small things about elements and words.

let words: Record<string, string> = {};

export const teach = (all: Record<string, string>): void => { words = all; };

/** A text of the catalogue, `studio-` left out of its name, with values in their places. */
export function say(key: string, values: Record<string, string | number> = {}): string {
  const text = words["studio-" + key] ?? words[key] ?? key;
  return text.replace(/\{(\w+)\}/g, (all, name: string) => name in values ? String(values[name]) : all);
}

type Attributes = Record<string, string | number | boolean | null | ((e: Event) => void)>;

/** An element with attributes, listeners (`onclick`), and contents. */
export function make<K extends keyof HTMLElementTagNameMap>(name: K, attributes: Attributes = {}, ...inside: (Node | string)[]): HTMLElementTagNameMap[K] {
  const e = document.createElement(name);
  for (const [k, v] of Object.entries(attributes)) {
    if (typeof v === "function") e.addEventListener(k.slice(2), v);
    else if (v === true) e.setAttribute(k, "");
    else if (v !== false && v !== null) e.setAttribute(k, String(v));
  }
  e.append(...inside);
  return e;
}

export const button = (key: string, act: () => void, attributes: Attributes = {}): HTMLButtonElement =>
  make("button", { type: "button", onclick: act, ...attributes }, say(key));

export function find<T extends Element = HTMLElement>(selector: string, from: ParentNode = document): T {
  const e = from.querySelector<T>(selector);
  if (!e) throw new Error(`the page has no ${selector}`);
  return e;
}

/** An attribute of an element; the same value is not set again. */
export function set(e: Element, name: string, value: string): void { if (e.getAttribute(name) !== value) e.setAttribute(name, value); }

/** Text of an element; the same text is not laid out again. */
export function write(e: Element, text: string): void { if (e.textContent !== text) e.textContent = text; }
