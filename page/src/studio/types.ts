// What the server answers. Places in texts are UTF-16 code units; values are in SI units.

export interface Named { name: string; title: string }

export interface Key { name: string; doc: string; unit?: string; values?: string[]; default?: string; required?: boolean }
export interface Kind { kind: string; doc: string; keys: Key[] }
/** `values` of keys are as a file writes them, with their quotation marks. */
export interface Completion { machine: { keys: Key[] }; parts: Kind[]; studies: Kind[]; blocks?: Record<string, { several: boolean; kinds: Kind[] }> }

export interface Start {
  file: string;
  text: string;
  folder_files: string[];
  version: string;
  language: string;
  languages: { code: string; name: string }[];
  words: Record<string, string>;
  decimal?: string;
  lengths?: string;
  examples: Named[];
  completion: Completion;
}

export interface Diagnostic { severity: string; code: string; message: string; help?: string | null; from: number; to: number }

export interface Parameter {
  path: string;
  label: string;
  doc: string;
  value: number;
  unit: string;
  /** The value as the file writes it, and its place there; null where it is a default. */
  shown: string;
  from: number | null;
  to: number | null;
  /** Range of the slider. */
  low: number;
  high: number;
  /** Unit of `shown`. */
  display_unit?: string;
}

export interface Handle { path: string; label: string; x: number; y: number; axis: "x" | "y"; scale: number; value: number }

export interface Solid {
  name: string;
  body: string | null;
  kind: string;
  /** Closed half section, position along the axis and radius, m. */
  outline: [number, number][];
  at: [number, number];
}

export interface Scene { axis: "vertical" | "horizontal"; solids: Solid[] }

export interface Study { name: string; kind: string; quick: boolean }

export interface Machine {
  name: string;
  speed: number | null;
  parameters: Parameter[];
  studies: Study[];
  drawing: { svg: string; handles: Handle[] } | null;
  scene: Scene | null;
}

export interface Checked { serial: number; diagnostics: Diagnostic[]; machine: Machine | null }

export interface Edit { from: number; to: number; insert: string }
export type Set = { path: string; value: number } | { path: string; written: string };

type Complex = [number, number];
export interface Station { body: string; z: number; x: Complex; y: Complex }
/** Displacements of stations at times, m; of a periodic motion the last frame is the first. */
export interface Frames { times: number[]; closed: boolean; paths: { body: string; z: number; x: number[]; y: number[] }[] }
export interface Shape {
  name: string;
  frequency: number;
  growth: number;
  whirl: string;
  stations: Station[];
  /** In place of complex amplitudes. */
  frames?: Frames;
  /** Largest displacement, m, and as text with its body. */
  size?: number;
  largest?: string;
  stability?: string;
  /** Turns of the rotor from the first to the last frame. */
  turns?: number;
}
export interface MotionKind { kind: "forced" | "nonlinear" | "transient"; study?: string }

/** What can be pulled in a figure. */
export interface Target {
  what: string;
  which: unknown;
  label: string;
  panel: number;
  x: number | null;
  y: number | null;
  along: "x" | "y";
  /** Axis units in one SI unit. */
  factor: number;
}

export const WANTS = ["page", "modes", "campbell", "stability", "forced", "nonlinear"] as const;
export type Want = typeof WANTS[number];

export interface Answer {
  want: Want | "motion" | "edit";
  serial?: number;
  ms?: number;
  html?: string;
  findings?: string[];
  shapes?: Shape[];
  /** With `speed`: motions to be played at that speed, rad/s. */
  motions?: Shape[];
  speed?: number;
  targets?: Target[];
  edits?: Edit[];
  error?: string;
}

/** The values of a parameter with which the file describes a machine, within the range of its slider. */
export interface Range { path: string; low: number; high: number }
export interface Free { path: string; low: number; high: number }
export interface Reached {
  edits: Edit[];
  reached: boolean;
  from: number;
  to: number;
  moved: { path: string; from: number; to: number; share: number; at_bound: boolean }[];
  impossible: { sentence: string; bounds: string[] } | null;
  /** Each parameter alone: its value, and the result there. */
  trade: { path: string; value: number; target: number; reached: boolean }[];
  /** Results on the way, and the change of the parameters that each takes, as share of their ranges. */
  curve?: [number, number][];
}

export interface Progress { state: string; done: number; total: number; error?: string; report?: boolean }
export interface Listed extends Progress { id: string; study: string }
