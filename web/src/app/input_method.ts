// Input methods, as those for Chinese, Japanese and Korean, use Enter, Escape and the arrows for themselves while they
// put a word together.

const PROCESSED_BY_INPUT_METHOD = 229;

/** Lets nothing of the page hear keys that belong to an input method. To be called before anything listens. */
export function leaveKeysToInputMethods(): void {
  window.addEventListener(
    "keydown",
    (event) => {
      // Safari tells of the last key of a word after it is finished, by its old number only.
      if (event.isComposing || event.keyCode === PROCESSED_BY_INPUT_METHOD) event.stopImmediatePropagation();
    },
    { capture: true },
  );
}
