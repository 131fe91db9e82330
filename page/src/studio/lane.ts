// At most one request of a kind at a time; the newest wins.

import { aborted } from "./api";

/** A request older than this is abandoned for a newer one, ms; a younger one is shown first, so that figures follow a drag. */
export const PATIENCE = 250;

export class Lane<T> {
  private next: { input: T } | null = null;
  private running: { abort: AbortController; since: number } | null = null;

  constructor(private readonly work: (input: T, signal: AbortSignal) => Promise<void>, private readonly failed: (e: unknown) => void) {}

  /** Called when nothing runs or waits any more. */
  idled: () => void = () => {};

  ask(input: T): void {
    this.next = { input };
    if (!this.running) void this.go();
    else if (performance.now() - this.running.since > PATIENCE) this.running.abort.abort();
    else this.later(this.running);
  }

  /** What runs now is abandoned if it is still running when its time is over and something newer waits. */
  private later(of: { abort: AbortController; since: number }): void {
    setTimeout(() => { if (this.running === of && this.next) of.abort.abort(); }, PATIENCE - (performance.now() - of.since));
  }

  /** Nothing more is wanted. */
  stop(): void {
    this.next = null;
    this.running?.abort.abort();
  }

  get idle(): boolean { return !this.running && !this.next; }

  private async go(): Promise<void> {
    while (this.next) {
      const { input } = this.next;
      this.next = null;
      const mine = this.running = { abort: new AbortController(), since: performance.now() };
      try {
        await this.work(input, mine.abort.signal);
      } catch (e) {
        if (!aborted(e)) this.failed(e);
      }
      this.running = null;
    }
    this.idled();
  }
}
