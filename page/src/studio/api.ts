// Requests to the server beside the page.

import { Live, Unreachable } from "./live";
import type { Answer, Checked, Free, Listed, MotionKind, Range, Reached, Set, Start, Want } from "./types";

/** An answer that refuses: the sentence of the server, with its status. */
export class Refused extends Error {
  constructor(message: string, readonly status: number) { super(message); }
}

export { Unreachable };

export const aborted = (e: unknown): boolean => e instanceof DOMException && e.name === "AbortError";

let language = "";
let serial = 0;

export const speak = (code: string): void => { language = code; };
export const spoken = (): string => language;

/** Address of the report of a run. */
export const reportOf = (id: string): string => address(`runs/${encodeURIComponent(id)}/report`);

let connection: Live | null = null;
const live = (): Live => connection ??= new Live(new URL("./api/live", location.href.replace(/^http/, "ws")).href.replace(/\?.*$/, ""));

function address(path: string): string {
  return `./api/${path}${language ? (path.includes("?") ? "&" : "?") + "lang=" + language : ""}`;
}

async function request(path: string, body: unknown, signal: AbortSignal | null): Promise<Response> {
  const init: RequestInit = { signal, cache: "no-store" };
  if (body !== undefined) {
    init.method = "POST";
    init.headers = { "Content-Type": "application/json" };
    init.body = JSON.stringify(body);
  }
  let answer: Response;
  try {
    answer = await fetch(address(path), init);
  } catch (e) {
    throw aborted(e) ? e : new Unreachable(String(e));
  }
  if (!answer.ok) {
    const text = await answer.text();
    let sentence = text;
    try { sentence = (JSON.parse(text) as { error: string }).error || text; } catch { /* the answer is plain text */ }
    throw new Refused(sentence || answer.statusText, answer.status);
  }
  return answer;
}

const json = async <T>(path: string, body?: unknown, signal: AbortSignal | null = null): Promise<T> => {
  const answer = await request(path, body, signal);
  return await answer.json() as T;
};

export const start = (): Promise<Start> => json("start");
/** What the page begins with in the language that the program was started in. */
export async function startOwn(): Promise<Start> {
  const chosen = language;
  language = "";
  const answer = start();
  language = chosen;
  return answer;
}
export const open = (what: "example" | "file", name: string): Promise<{ file: string; text: string }> =>
  json(`open?${what}=${encodeURIComponent(name)}`);
export const save = (file: string, text: string, base: string, force: boolean): Promise<{ file: string }> =>
  json("save", { file, text, base, force });
export const check = (text: string, signal: AbortSignal): Promise<Checked> => json("check", { serial: ++serial, text }, signal);
export const ranges = (text: string, signal: AbortSignal): Promise<{ ranges: Range[] }> => json("ranges", { serial: ++serial, text }, signal);
export const reach = (text: string, target: { what: string; which: unknown; to: number }, free: Free[], signal: AbortSignal): Promise<Reached> =>
  json("reach", { serial: ++serial, text, target, free }, signal);
export const runs = (): Promise<{ runs: Listed[] }> => json("runs");
export const run = (text: string, study: string, file: string): Promise<{ id: string }> => json("runs", { text, study, file });
export const steer = (id: string, what: "pause" | "resume" | "cancel"): Promise<unknown> => json(`runs/${encodeURIComponent(id)}/${what}`, {});

export async function share(text: string, pins: { name: string; text: string }[]): Promise<Blob> {
  return (await request("share", { text, pins }, null)).blob();
}

/** Answers of several kinds, each handed over as soon as its line is there. */
export async function answer(body: { text: string; want: (Want | "motion")[]; speed?: number; set?: Set[]; motion?: MotionKind }, signal: AbortSignal, each: (a: Answer) => void): Promise<void> {
  if (live().ready) return live().answer(++serial, language, body, signal, each);
  live().open();
  const response = await request("answer", { serial: ++serial, ...body }, signal);
  const reader = response.body?.getReader();
  if (!reader) return;
  const decoder = new TextDecoder(), open = new Set<string>(body.want);
  let kept = "";
  while (open.size) {
    let part: ReadableStreamReadResult<Uint8Array>;
    try {
      part = await reader.read();
    } catch (e) {
      throw aborted(e) ? e : new Unreachable(String(e));
    }
    kept += part.done ? decoder.decode() : decoder.decode(part.value, { stream: true });
    const lines = kept.split("\n");
    kept = part.done ? "" : lines.pop() ?? "";
    for (const line of lines) {
      if (!line.trim()) continue;
      const a = JSON.parse(line) as Answer;
      open.delete(a.want);
      each(a);
    }
    if (part.done) return;
  }
  // all is there: the end of the stream is not waited for, but read, so that the connection can be used again
  reader.read().catch(() => { /* nothing follows */ });
}
