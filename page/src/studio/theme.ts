// Dark and light: as the system has it, or as chosen here.

const KEPT = "laval-theme";
export type Theme = "system" | "light" | "dark";
const THEMES: Theme[] = ["system", "light", "dark"];

/** Rules of the style sheets that hold on dark screens. */
function rules(): CSSMediaRule[] {
  const all = [...document.styleSheets].flatMap(s => [...s.cssRules]);
  return all.filter((r): r is CSSMediaRule => r instanceof CSSMediaRule && r.media.mediaText.includes("prefers-color-scheme: dark"));
}

let dark: { rule: CSSMediaRule; media: string }[] | null = null;

export function apply(theme: Theme): void {
  dark ??= rules().map(rule => ({ rule, media: rule.media.mediaText }));
  for (const { rule, media } of dark) rule.media.mediaText = theme === "system" ? media : theme === "dark" ? "all" : "not all";
  document.documentElement.style.colorScheme = theme === "system" ? "light dark" : theme;
  document.documentElement.dataset.theme = theme;
  try { localStorage.setItem(KEPT, theme); } catch { /* the choice holds for this page */ }
}

export function kept(): Theme {
  try { return THEMES.find(t => t === localStorage.getItem(KEPT)) ?? "system"; } catch { return "system"; }
}

export const next = (t: Theme): Theme => THEMES[(THEMES.indexOf(t) + 1) % THEMES.length];
