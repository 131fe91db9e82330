// The machine file as text: colours, completion, errors at their place, undo.

import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab, invertedEffects, isolateHistory, redo, redoDepth, undo, undoDepth } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, bracketMatching, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { Diagnostic as Mark, lintGutter, lintKeymap, nextDiagnostic, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { Annotation, EditorState, StateEffect, StateField, Transaction } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { complete } from "./completion";
import { say } from "./dom";
import type { Completion, Diagnostic, Edit } from "./types";

/** A text that comes from elsewhere: it is no change of the user. */
const opened = Annotation.define<boolean>();

/** The file of the text, and what stands on the disk. */
export interface Origin { file: string; base: string }

/** The file changes with the text, also when that is undone: a text is never saved into the file of another. */
const from = StateEffect.define<Origin>();
const origin = StateField.define<Origin>({
  create: () => ({ file: "", base: "" }),
  update: (o, t) => t.effects.reduce((o, e) => e.is(from) ? e.value : o, o),
});
const undone = invertedEffects.of(t => t.effects.some(e => e.is(from)) && t.docChanged ? [from.of(t.startState.field(origin))] : []);

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--soft)", fontStyle: "italic" },
  { tag: tags.string, color: "var(--text-string)" },
  { tag: [tags.number, tags.bool, tags.atom], color: "var(--text-number)" },
  { tag: tags.propertyName, color: "var(--ink)" },
  { tag: [tags.keyword, tags.heading, tags.typeName], color: "var(--accent)", fontWeight: "600" },
]);

const look = EditorView.theme({
  "&": { height: "100%", fontSize: "13px", backgroundColor: "var(--paper)", color: "var(--ink)" },
  ".cm-scroller": { fontFamily: "ui-monospace, 'DejaVu Sans Mono', 'Liberation Mono', monospace", lineHeight: "1.5" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--soft)", border: "none" },
  ".cm-activeLine": { backgroundColor: "var(--active)" },
  ".cm-content": { caretColor: "var(--ink)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  "&.cm-focused": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
  ".cm-selectionBackground, &.cm-focused .cm-selectionBackground": { backgroundColor: "var(--selected) !important" },
  ".cm-selectionMatch": { backgroundColor: "var(--active)" },
  ".cm-tooltip": { backgroundColor: "var(--panel)", color: "var(--ink)", border: "1px solid var(--line)", borderRadius: "5px" },
  ".cm-tooltip-autocomplete ul li[aria-selected]": { backgroundColor: "var(--accent)", color: "var(--paper)" },
  ".cm-completionInfo": { maxWidth: "24rem", whiteSpace: "pre-line" },
  ".cm-panels": { backgroundColor: "var(--panel)", color: "var(--ink)" },
  ".cm-diagnostic": { fontFamily: "system-ui, sans-serif", whiteSpace: "pre-line" },
  ".cm-changed": { backgroundColor: "var(--active)" },
});

export class Editor {
  readonly view: EditorView;
  private marked = false;
  /** The last change came from the keys: only then something is offered. */
  private typed = false;
  /** A drag goes on, and has changed the text. */
  private drag: { changed: boolean } | null = null;

  constructor(host: HTMLElement, completion: () => Completion, private readonly changed: () => void, save: () => void) {
    // styles of the editor come as adopted sheets of a shadow root: the page allows no style elements
    const root = host.attachShadow({ mode: "open" });
    this.view = new EditorView({
      root,
      parent: root,
      state: EditorState.create({
        extensions: [
          lineNumbers(), history(), origin, undone, drawSelection(), highlightActiveLine(), bracketMatching(), closeBrackets(), highlightSelectionMatches(),
          StreamLanguage.define(toml), syntaxHighlighting(colours), look, lintGutter(),
          autocompletion({ override: [c => this.typed || c.explicit ? complete(c, completion()) : null] }),
          keymap.of([
            { key: "Mod-s", run: () => { save(); return true; } },
            { key: "F8", run: nextDiagnostic },
            { key: "Mod-z", run: () => { this.undo(); return true; } },
            ...closeBracketsKeymap, ...completionKeymap, ...searchKeymap, ...historyKeymap, ...lintKeymap, ...defaultKeymap,
            indentWithTab,
          ]),
          EditorView.contentAttributes.of({ "aria-label": say("text"), "data-testid": "text" }),
          EditorView.updateListener.of(u => { if (u.docChanged) this.changed(); }),
          EditorView.inputHandler.of(() => { this.typed = true; return false; }),
        ],
      }),
    });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(":host { display: block; height: 100%; } .cm-editor { height: 100%; }");
    root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet];
  }

  get text(): string { return this.view.state.doc.toString(); }
  get undos(): number { return undoDepth(this.view.state); }
  get redos(): number { return redoDepth(this.view.state); }
  get origin(): Origin { return this.view.state.field(origin); }

  /** In the middle of a drag what that has changed so far; what follows is a step of its own. */
  undo(): void {
    undo(this.view);
    if (!this.drag?.changed) return;
    this.drag.changed = false;
    this.apart();
  }
  redo(): void { redo(this.view); }
  focus(): void { this.view.focus(); }

  /** Another file: the whole text, as one step that can be undone when `keep`. */
  open(text: string, of: Origin, keep: boolean): void {
    const whole = { from: 0, to: this.view.state.doc.length, insert: text };
    const notes = [opened.of(true), isolateHistory.of("full"), Transaction.addToHistory.of(keep)];
    this.view.dispatch({ changes: whole, effects: from.of(of), selection: { anchor: 0 }, annotations: notes, scrollIntoView: true });
  }

  /** The text was saved. */
  saved(as: Origin): void { this.view.dispatch({ effects: from.of(as), annotations: Transaction.addToHistory.of(false) }); }

  /** Changes of the text; during a drag they become one step when it ends. */
  apply(edits: Edit[]): void {
    const length = this.view.state.doc.length;
    if (!edits.length || edits.some(e => e.from > e.to || e.to > length)) return;
    const changes = this.view.state.changes(edits), first = edits[0].from, { from, to } = this.view.viewport;
    // a place that is in sight needs no scrolling, which would cost a layout
    const effects = first < from || first > to ? [EditorView.scrollIntoView(changes.mapPos(first), { y: "center" })] : [];
    // the history joins what is composed to the step before it, however much time has passed
    const joined = this.drag?.changed === true;
    this.typed = false;
    this.view.dispatch({ changes, effects, userEvent: joined ? "input.type.compose" : "input.drag", annotations: joined ? [] : isolateHistory.of("before") });
    if (this.drag) this.drag.changed = true;
    else this.apart();
  }

  /** What comes next is a step of its own. */
  private apart(): void { this.view.dispatch({ annotations: isolateHistory.of("full") }); }

  begin(): void { this.drag ??= { changed: false }; }

  /** All that a drag changed is one step of undo; `keep` false takes it back. */
  end(keep = true): void {
    const drag = this.drag;
    this.drag = null;
    if (!drag?.changed) return;
    if (!keep) undo(this.view);
    this.apart();
  }

  marks(all: Diagnostic[]): void {
    if (!all.length && !this.marked) return;
    this.marked = all.length > 0;
    const end = this.view.state.doc.length;
    const marks = all.map((d): Mark => {
      const from = Math.min(d.from, end), to = Math.min(Math.max(d.to, d.from), end);
      return {
        from, to, severity: d.severity === "error" ? "error" : d.severity === "warning" ? "warning" : "info",
        message: d.help ? `${d.message}\n${d.help}` : d.message, source: d.code,
      };
    });
    this.view.dispatch(setDiagnostics(this.view.state, marks));
  }

  /** Puts the cursor at a place and shows it. */
  goto(at: number): void {
    const anchor = Math.min(at, this.view.state.doc.length);
    this.view.dispatch({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: "center" }) });
    this.view.focus();
  }
}
