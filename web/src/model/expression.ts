// Arithmetic in number fields: "2*pi/3", "1e-3", "-(4+0.5)^2", "sqrt(2)". Nothing else is understood.

import { splitNumbers } from "./numbers";

const CONSTANTS: Readonly<Record<string, number>> = { pi: Math.PI, tau: 2 * Math.PI, e: Math.E };

const FUNCTIONS: Readonly<Record<string, (x: number) => number>> = {
  sqrt: Math.sqrt,
  abs: Math.abs,
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  exp: Math.exp,
  log: Math.log,
};

const DEEPEST = 100;

/** The value of the formula, or undefined if it cannot be read or is not finite. Commas are read as in numbers.ts. */
export function evaluateExpression(text: string): number | undefined {
  const [part, ...more] = splitNumbers(text);
  return part === undefined || more.length > 0 ? undefined : evaluated(part);
}

function evaluated(text: string): number | undefined {
  const tokens = tokenize(text.trim().replaceAll("−", "-").replaceAll("×", "*"));
  if (!tokens || tokens.length === 0) return undefined;
  const reader = new Reader(tokens);
  const value = reader.sum(0);
  return value !== undefined && reader.done && Number.isFinite(value) ? value : undefined;
}

function tokenize(text: string): string[] | undefined {
  const pattern = /\s*(?:((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|([A-Za-z]+|π)|(\*\*|[-+*/^()%]))/y;
  const tokens: string[] = [];
  while (pattern.lastIndex < text.length) {
    const match = pattern.exec(text);
    if (!match) return undefined;
    tokens.push(match[1] ?? (match[2] === "π" ? "pi" : match[2]) ?? (match[3] === "**" ? "^" : match[3]) ?? "");
  }
  return tokens;
}

/** Recursive descent; every rule answers undefined where the text is not a formula. */
class Reader {
  private at = 0;
  constructor(private readonly tokens: readonly string[]) {}

  get done(): boolean {
    return this.at === this.tokens.length;
  }

  sum(depth: number): number | undefined {
    let value = this.product(depth);
    while (value !== undefined && (this.next === "+" || this.next === "-")) {
      const sign = this.take() === "+" ? 1 : -1;
      const right = this.product(depth);
      value = right === undefined ? undefined : value + sign * right;
    }
    return value;
  }

  private get next(): string | undefined {
    return this.tokens[this.at];
  }

  private take(): string | undefined {
    return this.tokens[this.at++];
  }

  private product(depth: number): number | undefined {
    let value = this.signed(depth);
    while (value !== undefined && (this.next === "*" || this.next === "/" || this.next === "%")) {
      const operation = this.take();
      const right = this.signed(depth);
      if (right === undefined) return undefined;
      value = operation === "*" ? value * right : operation === "/" ? value / right : value % right;
    }
    return value;
  }

  private signed(depth: number): number | undefined {
    let sign = 1;
    while (this.next === "+" || this.next === "-") if (this.take() === "-") sign = -sign;
    const value = this.power(depth);
    return value === undefined ? undefined : sign * value;
  }

  private power(depth: number): number | undefined {
    if (depth > DEEPEST) return undefined;
    const base = this.atom(depth);
    if (base === undefined || this.next !== "^") return base;
    this.take();
    const exponent = this.signed(depth + 1);
    return exponent === undefined ? undefined : base ** exponent;
  }

  private atom(depth: number): number | undefined {
    const token = this.take();
    if (token === undefined) return undefined;
    if (token === "(") return this.closed(depth);
    if (/^[\d.]/.test(token)) return Number(token);
    const name = token.toLowerCase();
    if (Object.hasOwn(FUNCTIONS, name)) {
      if (this.take() !== "(") return undefined;
      const value = this.closed(depth);
      return value === undefined ? undefined : FUNCTIONS[name]?.(value);
    }
    return Object.hasOwn(CONSTANTS, name) ? CONSTANTS[name] : undefined;
  }

  private closed(depth: number): number | undefined {
    if (depth > DEEPEST) return undefined;
    const value = this.sum(depth + 1);
    return this.take() === ")" ? value : undefined;
  }
}
