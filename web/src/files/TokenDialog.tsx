import { type FormEvent, type ReactElement, useId, useState } from "react";
import { access, giveToken } from "../net/access";
import { useStore } from "../widgets/hooks";

/** Asks for the token of the server, over everything else: nothing works without. */
export function TokenDialog(): ReactElement | null {
  const isWanted = useStore(access, (state) => state.isWanted);
  const isWrong = useStore(access, (state) => state.isWrong);
  const [text, setText] = useState("");
  const id = useId();
  if (!isWanted) return null;
  const submit = (event: FormEvent): void => {
    event.preventDefault();
    const token = text.trim();
    if (token === "") return;
    setText("");
    giveToken(token);
  };
  return (
    <div className="token-place">
      <form className="dialog token-dialog" aria-labelledby={`${id}-title`} onSubmit={submit}>
        <h2 id={`${id}-title`}>This server asks for its token</h2>
        <p>Whoever runs it has the token. It is kept in this tab, until that is closed.</p>
        <label htmlFor={id}>Token</label>
        <input
          id={id}
          autoFocus
          type="password"
          autoComplete="off"
          spellCheck={false}
          className="text-field"
          aria-invalid={isWrong || undefined}
          aria-describedby={isWrong ? `${id}-error` : undefined}
          value={text}
          onChange={(event) => setText(event.currentTarget.value)}
        />
        {isWrong && (
          <p className="dialog-error" id={`${id}-error`} role="alert">
            That was not the token of this server.
          </p>
        )}
        <button type="submit" className="button primary" disabled={text.trim() === ""}>
          Continue
        </button>
      </form>
    </div>
  );
}
