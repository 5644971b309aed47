import { type KeyboardEvent, type PointerEvent, type ReactElement, useState } from "react";
import { moveIntoPlace } from "../model/parameter_groups";
import type { Parameter } from "../model/parameters";
import { useEditor } from "../widgets/context";
import { Icon } from "../widgets/Icon";

/** What a row of the form is held by to put it elsewhere among the others: by dragging, or with the arrow keys. */
export function ParameterGrip({ parameter: { name, label } }: { parameter: Parameter }): ReactElement {
  const editor = useEditor();
  const [isHeld, setIsHeld] = useState(false);
  const move = (place: number): void => {
    const count = editor.session.store.get().document?.parameters.length ?? 0;
    if (place < 0 || place >= count) return;
    editor.session.edit(`Move ${label}`, moveIntoPlace(name, place));
    editor.say(`${label} is now ${place + 1} of ${count}`);
  };
  const placeNow = (): number =>
    editor.session.store.get().document?.parameters.findIndex((parameter) => parameter.name === name) ?? 0;
  const follow = (event: PointerEvent<HTMLButtonElement>): void => {
    const list = event.currentTarget.closest(".parameter-rows");
    const { pointerId } = event;
    const end = new AbortController();
    const { signal } = end;
    setIsHeld(true);
    let place = placeNow();
    const others = [...(list?.querySelectorAll<HTMLElement>(".parameter") ?? [])].filter(
      (row) => row.dataset["parameter"] !== name,
    );
    // A line says where the row would go.
    const mark = (at: number | undefined): void => {
      others.forEach((row, index) => {
        const isHere = index === at ? "before" : at === others.length && index === at - 1 ? "after" : undefined;
        if (isHere) row.dataset["drop"] = isHere;
        else delete row.dataset["drop"];
      });
    };
    const onMove = (moved: globalThis.PointerEvent): void => {
      if (moved.pointerId !== pointerId) return;
      place = others.filter((row) => {
        const { top, height } = row.getBoundingClientRect();
        return top + height / 2 < moved.clientY;
      }).length;
      mark(place);
    };
    const onEnd = (ended: globalThis.PointerEvent): void => {
      if (ended.pointerId !== pointerId) return;
      end.abort();
      mark(undefined);
      setIsHeld(false);
      if (ended.type === "pointerup" && place !== placeNow()) move(place);
    };
    document.addEventListener("pointermove", onMove, { signal });
    document.addEventListener("pointerup", onEnd, { signal });
    document.addEventListener("pointercancel", onEnd, { signal });
  };
  const onKeyDown = (event: KeyboardEvent<HTMLElement>): void => {
    const step = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    move(placeNow() + step);
    const { currentTarget } = event;
    requestAnimationFrame(() => currentTarget.focus());
  };
  return (
    <button
      type="button"
      className="parameter-grip"
      aria-label={`Move ${label}`}
      title="Drag, or press the arrow keys, to put it elsewhere"
      data-held={isHeld}
      onPointerDown={follow}
      onKeyDown={onKeyDown}
    >
      <Icon name="grip" />
    </button>
  );
}
