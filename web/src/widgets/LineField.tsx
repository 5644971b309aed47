import { type ReactElement, useId, useState } from "react";
import { describedBy, FieldError } from "./FieldError";

interface LineFieldProps {
  id: string;
  label?: string;
  text: string;
  placeholder?: string;
  invalid?: boolean;
  described?: string;
  /** One of the stops inside a node: Tab reaches it only from there. */
  isStop?: boolean;
  /** Takes what was typed, or answers the sentence that says why not: then it stays in the field. */
  onText(text: string): string | undefined;
}

/** A line of text that counts when it is left or Enter is pressed. */
export function LineField(props: LineFieldProps): ReactElement {
  const { id, label, text, placeholder, invalid = false, described, isStop, onText } = props;
  const errorId = useId();
  const [typed, setTyped] = useState<string | null>(null);
  const [error, setError] = useState("");
  const [textFor, setTextFor] = useState(text);
  const forget = (): void => {
    setTyped(null);
    setError("");
  };
  // A text that comes from elsewhere, as from undo, replaces what is being typed.
  if (textFor !== text) {
    setTextFor(text);
    forget();
  }
  const commit = (): void => {
    if (typed === null) return;
    const refusal = typed === text ? undefined : onText(typed);
    if (typeof refusal === "string") setError(refusal);
    else forget();
  };
  return (
    <span className="line-field nodrag nokey">
      <input
        id={id}
        type="text"
        className="text-field"
        autoComplete="off"
        spellCheck={false}
        placeholder={placeholder}
        aria-label={label}
        aria-invalid={invalid || error !== "" || undefined}
        aria-describedby={describedBy(described, error !== "" && errorId)}
        tabIndex={isStop ? -1 : undefined}
        data-stop={isStop || undefined}
        data-typing={typed !== null}
        value={typed ?? text}
        onChange={(event) => setTyped(event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={(event) => {
          if (event.key === "Enter") commit();
          if (event.key === "Escape") forget();
        }}
      />
      <FieldError id={errorId} text={error} />
    </span>
  );
}
