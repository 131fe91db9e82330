// The language of the page: that of the address, that chosen on the page, or that of the program.

import * as api from "./api";
import type { Start } from "./types";

const KEPT = "laval-language";

/** A choice holds for programs that were started in the language of then: another `--lang` is a newer wish. */
interface Choice { chosen: string; own: string }

const asked = (): string | null => new URLSearchParams(location.search).get("lang");

function kept(): Choice | null {
  try {
    const found = JSON.parse(localStorage.getItem(KEPT) ?? "null") as Partial<Choice> | null;
    return found && found.chosen && found.own ? { chosen: found.chosen, own: found.own } : null;
  } catch {
    // what an older page kept names no program
    return null;
  }
}

/** Asks the program what there is to show, in the language of the page. */
export async function begin(): Promise<Start> {
  const address = asked(), choice = kept();
  if (address !== null || !choice) {
    api.speak(address ?? "");
    return api.start();
  }
  const own = await api.startOwn();
  if (own.language !== choice.own) try { localStorage.removeItem(KEPT); } catch { /* it is compared again */ }
  if (own.language !== choice.own || own.language === choice.chosen) return own;
  api.speak(choice.chosen);
  return api.start();
}

/** Keeps a choice; gives the search part of the address under which the page is laid anew. */
export async function choose(code: string): Promise<string> {
  const own = (await api.startOwn()).language;
  try {
    localStorage.setItem(KEPT, JSON.stringify({ chosen: code, own } satisfies Choice));
    return "";
  } catch {
    return `?lang=${code}`;
  }
}
