import * as RadixDialog from "@radix-ui/react-dialog";
import { type FormEvent, type ReactElement, useId, useState } from "react";
import { type AccessState, access, giveToken } from "../net/access";
import { useStore } from "../widgets/hooks";

/** Asks for the token of the server, over everything else: nothing works without. */
export function TokenDialog(): ReactElement | null {
  const isWanted = useStore(access, (state) => state.isWanted);
  return isWanted ? <Asking /> : null;
}

function Asking(): ReactElement {
  const state = useStore(access, (one) => one);
  const [text, setText] = useState("");
  // Read before the field takes the focus.
  const [before] = useState(() => document.activeElement);
  const id = useId();
  const problem = problemOf(state);
  const submit = (event: FormEvent): void => {
    event.preventDefault();
    const token = text.trim();
    if (token === "") return;
    setText("");
    giveToken(token);
  };
  return (
    // A dialog as the others are: one that is open already would keep the focus from it otherwise.
    <RadixDialog.Root open>
      <RadixDialog.Portal>
        <div className="token-shade" />
        <RadixDialog.Content
          className="dialog token-dialog"
          aria-describedby={undefined}
          onEscapeKeyDown={(event) => event.preventDefault()}
          onInteractOutside={(event) => event.preventDefault()}
          onCloseAutoFocus={(event) => {
            event.preventDefault();
            if (before instanceof HTMLElement) before.focus();
          }}
        >
          <form onSubmit={submit}>
            <RadixDialog.Title>This server asks for its token</RadixDialog.Title>
            <p>Whoever runs it has the token. It is kept in this tab, until that is closed.</p>
            <label htmlFor={id}>Token</label>
            <input
              id={id}
              autoFocus
              type="password"
              autoComplete="off"
              spellCheck={false}
              className="text-field"
              aria-invalid={problem ? true : undefined}
              aria-describedby={problem ? `${id}-error` : undefined}
              value={text}
              onChange={(event) => setText(event.currentTarget.value)}
            />
            {problem && (
              <p className="dialog-error" id={`${id}-error`} role="alert">
                {problem}
              </p>
            )}
            <button type="submit" className="button primary" disabled={text.trim() === ""}>
              Continue
            </button>
          </form>
        </RadixDialog.Content>
      </RadixDialog.Portal>
    </RadixDialog.Root>
  );
}

function problemOf({ isWrong, isLocked }: AccessState): string {
  if (isLocked) return "Too many wrong tokens came from here. The right one is still taken.";
  return isWrong ? "That was not the token of this server." : "";
}
