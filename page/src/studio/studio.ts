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
  file = "";
  /** Text on disk. */
  base = "";
  /** Speed at which modes are shown, rad/s; the operating speed where none is chosen. */
  speed: number | null = null;
  reachable = true;
  /** The text that the editor is about to show, after a change whose figures are drawn first. */
  coming: string | null = null;
  /** Set by the page: figures of the coming text can be asked for. */
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
  private readonly edits: Lane<Set[]>;
  private applying = false;
  private ended: { keep: boolean } | null = null;
  /** Last sentence about something that was not done. */
  notice = "";

  constructor(readonly start: Start) {
    this.checks = new Lane((text, signal) => this.check(text, signal), e => this.failed(e));
    this.edits = new Lane((set, signal) => this.set(set, signal), e => { this.promised = null; this.failed(e); });
    this.edits.idled = () => this.finish();
  }

  /** Called after each change of the text. */
  whenText(f: Listener): void { this.onText.push(f); }
  /** Called after each check, when the machine was read or could not be. */
  whenMachine(f: Listener): void { this.onMachine.push(f); }
  /** Called when file, connection or notice changed. */
  whenStatus(f: Listener): void { this.onStatus.push(f); }

  get text(): string { return this.editor.text; }
  /** The text that figures belong to. */
  get newest(): string { return this.coming ?? this.text; }
  get unsaved(): boolean { return this.text !== this.base; }
  get errors(): number { return this.diagnostics.filter(d => d.severity === "error").length; }

  parameter(path: string): Parameter | undefined { return this.machine?.parameters.find(p => p.path === path); }

  changed(): void {
    // modes that arrived with a change are drawn before the next request
    if (this.applying) setTimeout(() => this.spread(), 0); else this.spread();
  }

  private spread(): void {
    this.checks.ask(this.text);
    this.onText.forEach(f => f());
    this.status();
  }

  status(): void { this.onStatus.forEach(f => f()); }

  tell(sentence: string): void { this.notice = sentence; this.status(); }

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

  /** Asks for values of parameters; the newest wins. */
  change(set: Set[]): void { this.edits.ask(set); }

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
          if (edits) this.onComing();
          this.quick(a);
          if (!edits) this.quickFits();
        } else if (a.error !== undefined) this.tell(a.error);
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
    if (!keep) this.edits.stop();
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
      this.file = file;
      this.base = what === "file" ? text : "";
      this.opened();
      this.editor.open(text, true);
      this.tell("");
    } catch (e) { this.failed(e); }
  }

  async save(force = false): Promise<void> {
    const text = this.text;
    try {
      const { file } = await api.save(this.file, text, this.base, force);
      this.answered();
      this.file = file;
      this.base = text;
      this.tell(say("saved", { name: file }));
    } catch (e) {
      if (e instanceof Refused && e.status === 409) this.conflict(e.message);
      else this.failed(e);
    }
  }

  /** Set by the page: what to do about a file that changed on disk. */
  conflict: (sentence: string) => void = () => {};

  /** A request failed: the sentence of the server, or the connection is lost. */
  failed(e: unknown): void {
    if (e instanceof Unreachable) return this.lost();
    this.tell(e instanceof Error ? e.message : String(e));
  }

  private answered(): void {
    if (!this.reachable) { this.reachable = true; this.status(); }
  }

  /** The server does not answer: tried again every second; then everything is asked anew. */
  private lost(): void {
    if (!this.reachable) return;
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
    };
    setTimeout(() => void again(), 1000);
  }
}
