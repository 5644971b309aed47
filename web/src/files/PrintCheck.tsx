import { type ReactElement, useEffect, useState } from "react";
import { lengthText, numberText, plural } from "../model/format";
import { evaluate } from "../net/api";
import { problemText } from "../net/problem";
import type { PartReport } from "../net/report";
import type { Answer, Effort, EvaluateBody } from "../net/requests";
import { verdict } from "./print_verdict";

/** The server counts no more places where a part meets itself. */
const MOST_CONTACTS = 1000;

interface PrintCheckProps {
  /** What is exported; another one is another check. */
  body: EvaluateBody;
  effort: Effort;
}

interface Asked extends PrintCheckProps {
  answer?: Answer;
}

/** Asks the server on demand whether the parts of the model can be printed, and tells what it found. */
export function PrintCheck({ body, effort }: PrintCheckProps): ReactElement {
  const [last, setLast] = useState<Asked | null>(null);
  // What was found is true of what was looked at only.
  const asked = last?.body === body && last.effort === effort ? last : null;

  useEffect(() => {
    if (!asked || asked.answer) return undefined;
    const request = new AbortController();
    evaluate({ ...asked.body, parts: true }, asked.effort, request.signal).then(
      (answer) => setLast({ ...asked, answer }),
      () => undefined,
    );
    return () => request.abort();
  }, [asked]);

  return (
    <section className="print-check" aria-label="Check for printing">
      {asked?.answer ? (
        <Found answer={asked.answer} />
      ) : (
        <button type="button" className="button" disabled={asked !== null} onClick={() => setLast({ body, effort })}>
          {asked ? "Checking…" : "Check for printing"}
        </button>
      )}
    </section>
  );
}

function Found({ answer }: { answer: Answer }): ReactElement {
  if (answer.kind === "away") return <p role="status">The server does not answer.</p>;
  if (answer.kind === "problem") return <p role="status">{problemText(answer.problem)}</p>;
  const meshes = answer.report.parts.filter(({ isMesh }) => isMesh);
  return (
    <>
      <p role="status">{verdict(meshes)}</p>
      {meshes.length > 0 && (
        <div className="print-parts">
          <table>
            <thead>
              <tr>
                <th scope="col">Part</th>
                <th scope="col">Surface</th>
                <th scope="col">Pieces</th>
                <th scope="col">Meets itself</th>
                <th scope="col">Thinnest wall</th>
                <th scope="col">Volume</th>
              </tr>
            </thead>
            <tbody>
              {meshes.map((part) => (
                <tr key={part.name}>
                  <th scope="row">{part.name}</th>
                  <td data-tone={part.isWatertight ? "ok" : "error"}>{surfaceText(part)}</td>
                  <td>{part.pieces}</td>
                  <td data-tone={part.contacts === 0 ? "ok" : "error"}>{contactText(part)}</td>
                  <td>{part.leastThickness > 0 ? lengthText(part.leastThickness) : "–"}</td>
                  <td>{part.isWatertight ? `${numberText(Math.abs(part.volume))}\u202fm³` : "–"}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </>
  );
}

function surfaceText({ isWatertight, borders }: PartReport): string {
  return isWatertight ? "closed" : `open, ${plural(borders, "border")}`;
}

function contactText({ contacts }: PartReport): string {
  return contacts === 0 ? "nowhere" : `${plural(contacts, "place")}${contacts < MOST_CONTACTS ? "" : " or more"}`;
}
