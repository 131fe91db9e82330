// Names under which a machine can be saved: files of the folder that end in .toml.

/** The name as it is sent, with `.toml` where it has no extension; null where it cannot be one. */
export function filename(written: string): string | null {
  const name = written.trim(), parts = name.split("/"), last = parts[parts.length - 1];
  if (!name || /[\\:\u0000-\u001f\u007f]/.test(name) || parts.some(p => !p.trim() || p === "." || p === "..")) return null;
  const dot = last.lastIndexOf(".");
  if (dot < 0) return `${name}.toml`;
  return dot > 0 && last.slice(dot) === ".toml" ? name : null;
}
