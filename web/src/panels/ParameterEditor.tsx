import { type ReactElement, useId } from "react";
import { changeParameter, removeParameter, usesOf } from "../model/edit_parameters";
import { evaluateExpression } from "../model/expression";
import { numberText, plural } from "../model/format";
import type { Json } from "../model/json";
import { groupOf, setGroup } from "../model/parameter_groups";
import { type Parameter, parameterValue } from "../model/parameters";
import { valuesOf } from "../session/paths";
import { useCurrent, useCurrentSession, useEditor } from "../widgets/context";
import { Icon } from "../widgets/Icon";
import { LineField } from "../widgets/LineField";

/** What the form shows of a parameter: its label, its range, its default; and the way to take it away. */
export function ParameterEditor({ parameter }: { parameter: Parameter }): ReactElement {
  const session = useCurrentSession();
  const editor = useEditor();
  const value = useCurrent((state) => parameterValue(parameter, valuesOf(state)));
  const uses = useCurrent((state) => (state.document ? usesOf(state.document, parameter.name) : 0));
  const { name } = parameter;
  const group = useCurrent((state) => (state.document ? groupOf(state.document, name) : ""));
  const set = (member: string, next: Json): undefined => {
    session.edit(`Change ${parameter.label}`, changeParameter(name, { [member]: next }), {
      gesture: `parameter ${name} ${member}`,
    });
  };
  const isNumber = parameter.type === "number" || parameter.type === "integer";
  const isDefault = JSON.stringify(value) === JSON.stringify(parameter.initial);
  return (
    <div className="parameter-editor" role="group" aria-label={`Settings of ${parameter.label}`}>
      <Line label="Label" text={parameter.label} onText={(text) => set("label", text || undefined)} />
      <Line label="Description" text={parameter.description} onText={(text) => set("description", text || undefined)} />
      <Line
        label="Group"
        text={group}
        onText={(text) => {
          session.edit(`Group ${parameter.label}`, setGroup(name, text));
          return undefined;
        }}
      />
      {isNumber && (
        <div className="parameter-range">
          <Bound label="From" value={parameter.minimum} onValue={(next) => set("min", next)} />
          <Bound label="To" value={parameter.maximum} onValue={(next) => set("max", next)} />
          <Bound label="Step" value={parameter.step} onValue={(next) => set("step", next)} />
        </div>
      )}
      <div className="parameter-actions">
        <button
          type="button"
          className="button quiet"
          disabled={isDefault}
          onClick={() =>
            session.edit(`Change the default of ${parameter.label}`, changeParameter(name, { default: value as Json }))
          }
        >
          Make this value the default
        </button>
        <button
          type="button"
          className="button quiet"
          title={`It drives ${plural(uses, "input")}; ${uses === 1 ? "it keeps" : "they keep"} the present value.`}
          onClick={() => {
            session.edit(`Remove ${parameter.label}`, removeParameter(name, value as Json));
            editor.say(`Removed the parameter ${parameter.label}`);
          }}
        >
          <Icon name="trash" />
          <span>Remove</span>
        </button>
      </div>
    </div>
  );
}

function Line(props: { label: string; text: string; onText(text: string): string | undefined }): ReactElement {
  const { label, text, onText } = props;
  const id = useId();
  return (
    <div className="parameter-line">
      <label htmlFor={id}>{label}</label>
      <LineField id={id} text={text} onText={(typed) => onText(typed.trim())} />
    </div>
  );
}

function Bound(props: { label: string; value?: number; onValue(value: number | undefined): void }): ReactElement {
  const { label, value, onValue } = props;
  return (
    <Line
      label={label}
      text={value === undefined ? "" : numberText(value, 6)}
      onText={(text) => {
        const next = evaluateExpression(text);
        if (text !== "" && next === undefined) return `“${text}” is not a number or a formula such as 2*pi/3.`;
        onValue(next);
        return undefined;
      }}
    />
  );
}
