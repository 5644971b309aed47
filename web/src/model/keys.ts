// Keys by name, whatever keyboard sends them.

/** What of a keyboard's event tells the key. */
export interface KeyPress {
  key: string;
  /** The key's place, named after what stands there on an American keyboard. */
  code?: string;
}

/**
 * The name of a key as the tables of keys write it: "A", "?", "Space", "ArrowLeft". On a keyboard of another script a
 * letter has the name of its place; a Latin letter means itself, wherever it is.
 */
export function keyName({ key, code = "" }: KeyPress): string {
  if (key === " ") return "Space";
  const place = /^Key([A-Z])$/.exec(code)?.[1];
  if (place !== undefined && /\p{L}/u.test(key) && !/\p{Script=Latin}/u.test(key)) return place;
  return key.length === 1 ? key.toUpperCase() : key;
}

/** The digit of a key in the row above the letters, where digits are typed with Shift or in another script. */
export function digitOf({ code = "" }: KeyPress): string | undefined {
  return /^Digit(\d)$/.exec(code)?.[1];
}
