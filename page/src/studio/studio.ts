// The state of the page: one text, the machine that the server reads from it, and who must know of changes.

import * as api from "./api";
import { Refused, Unreachable } from "./api";
import { say } from "./dom";
import type { Editor } from "./editor";
import { Lane } from "./lane";
import type { Answer, Checked, Diagnostic, Edit, Machine, Parameter, Set, Start } from "./types";

type Listener = () => void;

/** Modes that take longer than this appear after the text, ms. */
const PATIENCE_FOR_MODES = 12;

/** A text after changes, which are in ascending order. */
function edited(text: string, edits: Edit[]): string {
  return [...edits].sort((a, b) => b.from - a.from).reduce((t, e) => t.slice(0, e.from) + e.insert + t.slice(e.to), text);
}

/** When what is drawn now is on the screen; at once where nothing is drawn, as of a page that is hidden. */
const painted = (): Promise<void> => new Promise(done => {
  const late = setTimeout(done, 50);
  requestAnimationFrame(() => setTimeout(() => { clearTimeout(late); done(); }));
});

export class Studio {
  editor!: Editor;
  machine: Machine | null = null;
  diagnostics: Diagnostic[] = [];
  /** Speed at which modes are shown, rad/s; the operating speed where none is chosen. */
  speed: number | null = null;
  reachable = true;
  /** The text that the editor is about to show, after a change whose figures are drawn first. */
  coming: string | null = null;
  /** Set by the page: requests the figures of the coming text. */
  onComing: () => void = () => {};
  /** The text whose modes are on their way already. */
  promised: string | null = null;
  /** Set by the page: another machine follows. */
  opened: () => void = () => {};
  /** Set by the page: shows an answer that came with a change. */
  quick: (a: Answer) => void = () => {};
  /** Set by the page: that answer is the one of the text. */
  quickFits: () => void = () => {};
  private readonly onText: Listener[] = [];
  private readonly onMachine: Listener[] = [];
  private readonly onStatus: Listener[] = [];
  private readonly checks: Lane<string>;
  private readonly edits: Lane<null>;
  /** Requested values that are not in the text yet, by path. */
  private readonly waiting = new Map<string, Set>();
  private sent: Set[] = [];
  /** Set by the page: values that the program refused, and why. */
  refused: (set: Set[], sentence: string) => void = () => {};
  private applying = false;
  private ended: { keep: boolean } | null = null;
  /** Last sentence about something that was not done. */
  notice = "";
  /** The text that it speaks of. */
  private noticed = "";

  constructor(readonly start: Start) {
    this.checks = new Lane((text, signal) => this.check(text, signal), e => this.failed(e));
    this.edits = new Lane((_, signal) => this.send(signal), e => { this.promised = null; this.failed(e); });
    this.edits.idled = () => this.finish();
  }

  /** Called after each change of the text. */
  whenText(f: Listener): void { this.onText.push(f); }
  /** Called after each check, when the machine was read or could not be. */
  whenMachine(f: Listener): void { this.onMachine.push(f); }
  /** Called when file, connection or notice changed. */
  whenStatus(f: Listener): void { this.onStatus.push(f); }

  get text(): string { return this.editor.text; }
  get file(): string { return this.editor.origin.file; }
  /** Text on disk. */
  get base(): string { return this.editor.origin.base; }
  /** The text that figures belong to. */
  get newest(): string { return this.coming ?? this.text; }
  get unsaved(): boolean { return this.text !== this.base; }
  get errors(): number { return this.diagnostics.filter(d => d.severity === "error").length; }

  parameter(path: string): Parameter | undefined { return this.machine?.parameters.find(p => p.path === path); }

  changed(): void {
    // its modes may take longer than the next wish
    if (this.applying) this.taken();
    // modes that arrived with a change are drawn before the next request
    if (this.applying) setTimeout(() => this.spread(), 0); else this.spread();
  }

  private spread(): void {
    if (this.notice && this.noticed !== this.text) this.notice = "";
    this.checks.ask(this.text);
    this.onText.forEach(f => f());
    this.status();
  }

  status(): void { this.onStatus.forEach(f => f()); }

  /** A sentence about the text of now; it goes with it. */
  tell(sentence: string): void {
    this.notice = sentence;
    this.noticed = this.text;
    this.status();
  }

  private async check(text: string, signal: AbortSignal): Promise<void> {
    const answer: Checked = await api.check(text, signal);
    this.answered();
    if (text !== this.text) return;
    this.diagnostics = answer.diagnostics;
    this.editor.marks(answer.diagnostics);
    // figures of the last machine that could be read stay while the text is wrong
    if (answer.machine) this.machine = answer.machine;
    this.onMachine.forEach(f => f());
    this.status();
  }

  /** Asks for values of parameters; of each the newest wins. */
  change(set: Set[]): void {
    for (const s of set) this.waiting.set(s.path, s);
    this.edits.ask(null);
  }

  /** Whether a value of this parameter is on its way. */
  waits(path: string): boolean { return this.waiting.has(path); }
  get unsent(): string[] { return [...this.waiting.keys()]; }

  /** Sends what waits; without a connection it goes on waiting. */
  private async send(signal: AbortSignal): Promise<void> {
    const set = this.sent = [...this.waiting.values()], text = this.text;
    if (!set.length) return;
    try {
      await this.set(set, signal);
    } catch (e) {
      if (e instanceof Refused) { this.taken(); this.refused(set, e.message); }
      throw e;
    }
    // its places were those of a text that was changed meanwhile
    if (text !== this.text && set.some(s => this.waiting.get(s.path) === s)) return this.edits.ask(null);
    this.taken();
  }

  /** What was sent is in the text, or will never be. */
  private taken(): void {
    for (const s of this.sent) if (this.waiting.get(s.path) === s) this.waiting.delete(s.path);
  }

  private async set(set: Set[], signal: AbortSignal): Promise<void> {
    const text = this.text, speed = this.speed;
    let edits: Edit[] | null = null, drawn = false, late = 0;
    const apply = () => {
      const now = edits;
      edits = null;
      clearTimeout(late);
      this.coming = null;
      if (!now || text !== this.text) return;
      this.applying = true;
      this.editor.apply(now);
      this.applying = false;
      if (drawn) this.quickFits(); else this.promised = this.text;
      if (this.notice) this.tell("");
    };
    try {
      // one trip for the new text and its modes; these are drawn in the next frame, and the text in the one after it
      await api.answer({ text, want: ["modes"], set, ...(speed !== null ? { speed } : {}) }, signal, a => {
        if (a.want === "edit" && a.edits) {
          this.answered();
          edits = a.edits;
          this.coming = edited(text, edits);
          late = window.setTimeout(apply, PATIENCE_FOR_MODES);
        } else if (edits || this.promised === this.text) {
          drawn = true;
          this.promised = null;
          clearTimeout(late);
          this.quick(a);
          if (edits) this.onComing(); else this.quickFits();
        } else if (a.error !== undefined) {
          this.tell(a.error);
          this.taken();
          this.refused(set, a.error);
        }
      });
      if (edits) await painted();
    } finally {
      apply();
    }
  }

  /** A drag begins: what follows becomes one step of undo. */
  begin(): void {
    this.ended = null;
    this.editor.end();
    this.editor.begin();
  }

  /** The drag ends when its last change is in the text. */
  end(keep = true): void {
    this.ended = { keep };
    if (!keep) { this.waiting.clear(); this.edits.stop(); }
    if (this.edits.idle) this.finish();
  }

  private finish(): void {
    if (!this.ended) return;
    const { keep } = this.ended;
    this.ended = null;
    this.editor.end(keep);
  }

  async open(what: "example" | "file", name: string): Promise<void> {
    try {
      const { file, text } = await api.open(what, name);
      this.waiting.clear();
      this.opened();
      this.editor.open(text, { file, base: what === "file" ? text : "" }, true);
      this.tell("");
    } catch (e) { this.failed(e); }
  }

  /** A name that is refused leaves the name of before. */
  async save(name = this.file, force = false): Promise<void> {
    const text = this.text;
    try {
      const { file } = await api.save(name, text, name === this.file ? this.base : "", force);
      this.answered();
      this.editor.saved({ file, base: text });
      this.tell(say("saved", { name: file }));
    } catch (e) {
      if (e instanceof Refused && e.status === 409) this.conflict(e.message, name);
      else this.failed(e);
    }
  }

  /** Set by the page: what to do about a file that changed on disk. */
  conflict: (sentence: string, file: string) => void = () => {};

  /** A request failed: the sentence of the server, or the connection is lost. */
  failed(e: unknown): void {
    if (e instanceof Unreachable) return this.lost();
    this.tell(e instanceof Error ? e.message : String(e));
  }

  private answered(): void {
    if (!this.reachable) { this.reachable = true; this.status(); }
  }

  /** Set by the page: the connection is there again. */
  returned: () => void = () => {};

  /** The server does not answer: tried again every second; then everything is asked anew. */
  private lost(): void {
    // what waits is named in the sentence
    if (!this.reachable) return this.status();
    this.reachable = false;
    this.status();
    const again = async () => {
      try {
        await api.start();
      } catch (e) {
        if (!(e instanceof Refused)) { setTimeout(() => void again(), 1000); return; }
      }
      this.reachable = true;
      this.changed();
      this.returned();
      // after the check of the text, so that values that wait come last
      if (this.waiting.size) this.edits.ask(null);
    };
    setTimeout(() => void again(), 1000);
  }
}
