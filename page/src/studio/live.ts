// The connection that stays open: an answer over it does not take the time of a request of its own.

import type { Answer } from "./types";

/** The server does not answer at all. */
export class Unreachable extends Error {}

interface Waiting {
  /** Kinds of answers that have not come yet. */
  open: Set<string>;
  each: (a: Answer) => void;
  done: () => void;
  failed: (e: unknown) => void;
}

export class Live {
  private socket: WebSocket | null = null;
  private readonly waiting = new Map<number, Waiting>();

  constructor(private readonly address: string) {}

  get ready(): boolean { return this.socket?.readyState === WebSocket.OPEN; }

  /** Opens it; until then, and where that fails, answers come by requests. */
  open(): void {
    if (this.socket) return;
    const socket = this.socket = new WebSocket(this.address);
    socket.onmessage = e => { for (const line of String(e.data).split("\n")) this.take(JSON.parse(line) as Answer); };
    socket.onclose = () => {
      if (this.socket === socket) this.socket = null;
      const all = [...this.waiting.values()];
      this.waiting.clear();
      all.forEach(w => w.failed(new Unreachable("the connection was closed")));
    };
  }

  private take(a: Answer): void {
    const serial = a.serial ?? 0, w = this.waiting.get(serial);
    if (!w) return;
    w.open.delete(a.want);
    // a defect answers for all
    if (!a.want) w.open.clear();
    if (!w.open.size) this.waiting.delete(serial);
    try {
      w.each(a);
      if (!w.open.size) w.done();
    } catch (e) {
      this.waiting.delete(serial);
      w.failed(e);
    }
  }

  /** Answers to the body of a request, each handed over as soon as it is there. */
  answer(serial: number, lang: string, body: { want: string[] }, signal: AbortSignal, each: (a: Answer) => void): Promise<void> {
    return new Promise((done, failed) => {
      const cancel = () => {
        if (!this.waiting.delete(serial)) return;
        if (this.ready) this.socket!.send(JSON.stringify({ cancel: serial }));
        failed(new DOMException("cancelled", "AbortError"));
      };
      if (signal.aborted) return failed(new DOMException("cancelled", "AbortError"));
      signal.addEventListener("abort", cancel, { once: true });
      const over = <A extends unknown[]>(f: (...a: A) => void) => (...a: A) => { signal.removeEventListener("abort", cancel); f(...a); };
      this.waiting.set(serial, { open: new Set(body.want), each, done: over(done), failed: over(failed) });
      this.socket!.send(JSON.stringify({ answer: { serial, ...body }, lang: lang || undefined }));
    });
  }
}
