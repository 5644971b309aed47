import { type ReactElement, useEffect, useMemo, useState } from "react";
import type { Catalogue } from "../model/catalogue";
import { type GraphDocument, lookedAt } from "../model/document";
import { byteText, fileName, grouped, lengthText } from "../model/format";
import { fileOutput } from "../model/graph";
import { wholeCatalogue } from "../model/group_cards";
import { asParameter, fieldValue, withinHard } from "../model/inputs";
import { isNumber, type Json } from "../model/json";
import { documentWithValues } from "../model/saved_values";
import { evaluate } from "../net/api";
import { problemText } from "../net/problem";
import type { Report } from "../net/report";
import type { Answer, Effort, Quality } from "../net/requests";
import { saveBlob } from "../session/download";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";
import { OVERDUE_MILLISECONDS, useLasting } from "../widgets/hooks";
import { ValueField } from "../widgets/ValueField";
import { documentText } from "./document_text";
import { type ExportOption, exportOptions, withOptions } from "./export_options";
import { filesOf } from "./Files";
import { withGraph } from "./glb_graph";
import { BITS, errorName, type Measured, PrecisionField } from "./PrecisionField";
import { PrintCheck } from "./PrintCheck";

const GRAPH = "json";
/** The format that this page puts the graph into. */
const HOLDS_GRAPH = "glb";
const PAUSE_MILLISECONDS = 250;
const DRAFT_TRIANGLES = 20_000;

/** The model as a file: its settings, and what they make of it, before it is taken. */
export function ExportDialog(): ReactElement {
  const session = useCurrentSession();
  const files = filesOf(session);
  const open = useCurrent((state) => state.document);
  const scoped = useCurrent((state) => state.catalogue);
  const document = open && lookedAt(open, []);
  const catalogue = useMemo(() => scoped && open && wholeCatalogue(scoped, open), [scoped, open]);
  const values = useCurrent((state) => state.values);
  const formats = catalogue?.formats ?? [];
  const [chosen, setChosen] = useState<string | null>(null);
  const [quality, setQuality] = useState<Quality>("final");
  const [changes, setChanges] = useState<Record<string, Json>>({});
  const [withDocument, setWithDocument] = useState(true);
  const [answer, setAnswer] = useState<Answer | null>(null);
  /** What the last answer told of how exact it is, by what the report calls it. */
  const [measured, setMeasured] = useState<Readonly<Record<string, Measured>>>({});
  const [attempt, setAttempt] = useState(0);
  const isOverdue = useLasting(answer === null, OVERDUE_MILLISECONDS);
  // Nothing chosen is the usual format, and GRAPH none of a model.
  const format = chosen === GRAPH ? undefined : (formats.find(({ name }) => name === chosen) ?? formats[0]);
  const formatName = format?.name;
  const output = document && catalogue ? fileOutput(document, catalogue) : undefined;

  const asked = useMemo(() => {
    if (!document || output === undefined || formatName === undefined) return null;
    const graph = withOptions(document, output, changes);
    const effort: Effort = { quality, triangles: DRAFT_TRIANGLES, format: formatName };
    return { body: { graph, parameters: values, output }, effort };
  }, [document, values, output, quality, changes, formatName]);

  useEffect(() => {
    if (!document || !asked) return undefined;
    const request = new AbortController();
    setAnswer(null);
    const timer = window.setTimeout(() => {
      evaluate(asked.body, asked.effort, request.signal).then(
        (found) => {
          setAnswer(found);
          if (found.kind === "model") setMeasured(measuredIn(found.report, document, catalogue, changes));
        },
        () => undefined,
      );
    }, PAUSE_MILLISECONDS);
    return () => {
      window.clearTimeout(timer);
      request.abort();
    };
  }, [asked, document, catalogue, changes, attempt]);

  const name = `${fileName(document?.title ?? "")}${format?.extension ?? ".json"}`;
  const model = answer?.kind === "model" ? answer.model : undefined;
  const holdsGraph = formatName === HOLDS_GRAPH;
  const file =
    model && document && withDocument && holdsGraph ? withGraph(model, documentWithValues(document, values)) : model;
  const download = (): void => {
    if (format && file) saveBlob(new Blob([file], { type: format.mediaType }), name);
    if (!format && document) {
      saveBlob(new Blob([documentText(documentWithValues(document, values))], { type: "application/json" }), name);
    }
    files.show(null);
  };
  const isReady = format ? file !== undefined : document !== null;
  return (
    <Dialog
      title="Export"
      onClose={() => files.show(null)}
      actions={
        <button type="button" className="button primary" disabled={!isReady} onClick={download}>
          Download {name}
        </button>
      }
    >
      <div className="export-rows">
        <label htmlFor="export-format">Format</label>
        <select
          id="export-format"
          className="select"
          value={formatName ?? GRAPH}
          title={format?.description}
          onChange={(event) => setChosen(event.currentTarget.value)}
        >
          {formats.map(({ name: each, extension }) => (
            <option key={each} value={each}>
              Model, {each.toUpperCase()} ({extension})
            </option>
          ))}
          <option value={GRAPH}>Graph (.json)</option>
        </select>
        {format && (
          <>
            <label htmlFor="export-quality">Quality</label>
            <select
              id="export-quality"
              className="select"
              value={quality}
              onChange={(event) => setQuality(event.currentTarget.value === "draft" ? "draft" : "final")}
            >
              <option value="final">Final</option>
              <option value="draft">Draft, about {grouped(DRAFT_TRIANGLES)} triangles</option>
            </select>
            {document &&
              catalogue &&
              exportOptions(document, catalogue).map((option) => (
                <OptionField
                  key={option.input.name}
                  option={option}
                  value={changes[option.input.name] ?? option.value}
                  measured={measured[errorName(option.input)]}
                  onChange={(value) => setChanges({ ...changes, [option.input.name]: value })}
                />
              ))}
          </>
        )}
        {holdsGraph && (
          <>
            <label htmlFor="export-graph" title="The file can be opened here again, dropped on this page">
              Graph inside
            </label>
            <input
              id="export-graph"
              type="checkbox"
              className="checkbox"
              checked={withDocument}
              onChange={(event) => setWithDocument(event.currentTarget.checked)}
            />
          </>
        )}
      </div>
      {format && (
        <p className="export-result" role="status" data-tone={answer?.kind === "problem" ? "error" : "ok"}>
          {isOverdue ? "No answer yet." : resultText(output, answer, file?.byteLength ?? 0)}
          {(isOverdue || answer?.kind === "away") && (
            <button type="button" className="button" onClick={() => setAttempt(attempt + 1)}>
              Try again
            </button>
          )}
        </p>
      )}
      {asked && answer?.kind === "model" && <PrintCheck body={asked.body} effort={asked.effort} />}
    </Dialog>
  );
}

function resultText(output: string | undefined, answer: Answer | null, bytes: number): string {
  if (output === undefined) return "No node of this graph makes a file.";
  if (answer === null) return "Measuring…";
  if (answer.kind === "away") return "The server does not answer.";
  if (answer.kind === "problem") return problemText(answer.problem);
  const { report } = answer;
  const off = report.errors.get("position");
  const parts = [byteText(bytes), `${grouped(report.triangles)} triangles`];
  if (off !== undefined) parts.push(`no point off by more than ${lengthText(off)}`);
  return parts.join(" · ");
}

/** How exact the answer is, and with how many bits. */
function measuredIn(
  { errors }: Report,
  document: GraphDocument,
  catalogue: Catalogue | null,
  changes: Readonly<Record<string, Json>>,
): Record<string, Measured> {
  const found: Record<string, Measured> = {};
  for (const { input, value } of catalogue ? exportOptions(document, catalogue) : []) {
    const bits = changes[input.name] ?? value;
    const error = errors.get(errorName(input));
    if (input.unit === BITS && isNumber(bits) && error !== undefined) found[errorName(input)] = { bits, error };
  }
  return found;
}

interface OptionFieldProps {
  option: ExportOption;
  value: Json;
  measured?: Measured;
  onChange(value: Json): void;
}

function OptionField({ option: { input, kind }, value, measured, onChange }: OptionFieldProps): ReactElement {
  const id = `export-${input.name}`;
  const parameter = asParameter(input, kind);
  if (input.unit === BITS && isNumber(value)) {
    return (
      <>
        <label htmlFor={id} title={input.description}>
          {parameter.label}
        </label>
        <PrecisionField {...{ id, input, value, measured, onChange }} />
      </>
    );
  }
  return (
    <>
      <label htmlFor={id} title={input.description}>
        {parameter.label}
      </label>
      <ValueField
        {...{ id, parameter }}
        label={parameter.label}
        partLabel={(letter) => `${parameter.label} ${letter}`}
        value={fieldValue(parameter, value)}
        look="form"
        within={(next) => withinHard(input, next)}
        onChange={(next) => onChange(next as Json)}
      />
    </>
  );
}
