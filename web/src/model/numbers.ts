// Commas in typed numbers, the same wherever one or several are typed. A semicolon separates, and beside semicolons a comma
// is a decimal comma (1,5; 2,5). Without semicolons a single comma between two digits is one too (1,5), and any other
// comma separates (1,2,3).

const DECIMAL_COMMA = /(?<![\w.,])(\d*),(\d+)(?![\d.,])/g;

/** The parts of a text that each should be a number or a formula, with decimal points. */
export function splitNumbers(text: string): string[] {
  const parts = text.split(";");
  if (parts.length > 1) return parts.map(withPoints);
  const isOne = text.indexOf(",") === text.lastIndexOf(",");
  return isOne ? withPoints(text).split(",") : text.split(",");
}

function withPoints(text: string): string {
  return text.replace(DECIMAL_COMMA, "$1.$2");
}
