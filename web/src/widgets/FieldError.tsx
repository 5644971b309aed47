import type { ReactElement } from "react";

/** One sentence at a field about what was typed there. */
export function FieldError({ id, text }: { id: string; text: string }): ReactElement | null {
  if (text === "") return null;
  return (
    <span className="field-error" id={id} role="alert">
      {text}
    </span>
  );
}

/** The ids of what describes a field, as its attribute takes them. */
export function describedBy(...ids: (string | false | undefined)[]): string | undefined {
  return ids.filter(Boolean).join(" ") || undefined;
}
