import { useEffect, useState, type ReactElement } from "react";
import { useCurrent, useCurrentSession } from "../app/context";
import { saveBlob } from "../app/download";
import { byteText, fileName, grouped } from "../model/format";
import { fileOutput } from "../model/graph";
import type { Json } from "../model/json";
import { documentWithValues } from "../model/saved_values";
import { evaluate, type Answer, type Quality } from "../net/api";
import { problemText } from "../net/problem";
import { Dialog } from "./Dialog";
import { documentText } from "./document_text";
import { exportOptions, withOptions, type ExportOption } from "./export_options";
import { filesOf } from "./Files";
import { withGraph } from "./glb_graph";

const PAUSE_MILLISECONDS = 250;
const DRAFT_TRIANGLES = 20_000;

/** The model as a file: its settings, and what they make of it, before it is taken. */
export function ExportDialog(): ReactElement {
  const session = useCurrentSession();
  const files = filesOf(session);
  const document = useCurrent((state) => state.document);
  const catalogue = useCurrent((state) => state.catalogue);
  const values = useCurrent((state) => state.values);
  const [format, setFormat] = useState<"glb" | "json">("glb");
  const [quality, setQuality] = useState<Quality>("final");
  const [changes, setChanges] = useState<Record<string, Json>>({});
  const [withDocument, setWithDocument] = useState(true);
  const [answer, setAnswer] = useState<Answer | null>(null);
  const output = document && catalogue ? fileOutput(document, catalogue) : undefined;

  useEffect(() => {
    if (!document || output === undefined) return undefined;
    const request = new AbortController();
    setAnswer(null);
    const timer = window.setTimeout(() => {
      const graph = withOptions(document, output, changes);
      evaluate({ graph, parameters: values, output }, { quality, triangles: DRAFT_TRIANGLES }, request.signal).then(
        setAnswer,
        () => undefined,
      );
    }, PAUSE_MILLISECONDS);
    return () => {
      window.clearTimeout(timer);
      request.abort();
    };
  }, [document, values, output, quality, changes]);

  const name = `${fileName(document?.title ?? "")}.${format}`;
  const model = answer?.kind === "model" ? answer.model : undefined;
  const file = model && document && withDocument ? withGraph(model, documentWithValues(document, values)) : model;
  const download = (): void => {
    if (format === "glb" && file) saveBlob(new Blob([file], { type: "model/gltf-binary" }), name);
    if (format === "json" && document) {
      saveBlob(new Blob([documentText(documentWithValues(document, values))], { type: "application/json" }), name);
    }
    files.show(null);
  };
  const isReady = format === "json" ? document !== null : file !== undefined;
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
          value={format}
          onChange={(event) => setFormat(event.currentTarget.value === "json" ? "json" : "glb")}
        >
          <option value="glb">Model, glTF binary with Draco (.glb)</option>
          <option value="json">Graph (.json)</option>
        </select>
        {format === "glb" && (
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
                  onChange={(value) => setChanges({ ...changes, [option.input.name]: value })}
                />
              ))}
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
      {format === "glb" && (
        <p className="export-result" role="status" data-tone={answer?.kind === "problem" ? "error" : "ok"}>
          {resultText(output, answer, file?.byteLength ?? 0)}
        </p>
      )}
    </Dialog>
  );
}

function resultText(output: string | undefined, answer: Answer | null, bytes: number): string {
  if (output === undefined) return "No node of this graph makes a file.";
  if (answer === null) return "Measuring…";
  if (answer.kind === "away") return "The server does not answer.";
  if (answer.kind === "problem") return problemText(answer.problem);
  const { report } = answer;
  const parts = [byteText(bytes), `${grouped(report.triangles)} triangles`];
  if (report.positionError !== undefined) parts.push(`no point off by more than ${lengthText(report.positionError)}`);
  return parts.join(" · ");
}

/** Meters in the unit that suits: "0.12 mm". */
function lengthText(meters: number): string {
  const [factor, unit] = meters < 1e-3 ? [1e6, "µm"] : meters < 1 ? [1e3, "mm"] : [1, "m"];
  return `${Number((meters * Number(factor)).toPrecision(2))}\u202f${unit}`;
}

interface OptionFieldProps {
  option: ExportOption;
  value: Json;
  onChange(value: Json): void;
}

function OptionField({ option: { input }, value, onChange }: OptionFieldProps): ReactElement {
  const id = `export-${input.name}`;
  const title = input.name.replaceAll("_", " ");
  return (
    <>
      <label htmlFor={id} title={input.doc}>
        {title.charAt(0).toUpperCase() + title.slice(1)}
      </label>
      {input.types.includes("boolean") ? (
        <input
          id={id}
          type="checkbox"
          className="checkbox"
          checked={value === true}
          onChange={(event) => onChange(event.currentTarget.checked)}
        />
      ) : input.choices.length > 0 ? (
        <select id={id} className="select" value={String(value)} onChange={(event) => onChange(event.currentTarget.value)}>
          {input.choices.map((choice) => (
            <option key={choice}>{choice}</option>
          ))}
        </select>
      ) : (
        <span className="export-number">
          <input
            id={id}
            type="range"
            min={input.softMinimum ?? input.minimum ?? 0}
            max={input.softMaximum ?? input.maximum ?? 100}
            step={input.types.includes("integer") ? 1 : (input.step ?? "any")}
            value={Number(value)}
            onChange={(event) => onChange(Number(event.currentTarget.value))}
          />
          <output htmlFor={id}>{String(value)}</output>
        </span>
      )}
    </>
  );
}
