import { useId, useState, type ReactElement } from "react";
import { useCurrent, useCurrentSession } from "../app/context";
import { Icon } from "../app/icons";
import { sameValue, valueOf, type Parameter, type ParameterValue } from "../model/parameters";
import { parameterErrors } from "../net/problem";
import { NumberField } from "./NumberField";
import { ParameterEditor } from "./ParameterEditor";
import { ChoiceField, ColorField, SwitchField, TextField, VectorField } from "./fields";

export interface FieldProps {
  id: string;
  parameter: Parameter;
  value: ParameterValue;
  invalid: boolean;
  /** Ids of what describes the field: its description and its error. */
  describedBy?: string;
  onChange(value: ParameterValue, moving: boolean): void;
  /** Whether a text that is no value stands in the field; it is not sent. */
  onUnreadable(isUnreadable: boolean): void;
}

/** Label, field, reset button, description and error of one parameter. */
export function ParameterRow({ parameter }: { parameter: Parameter }): ReactElement {
  const session = useCurrentSession();
  const id = useId();
  const value = useCurrent((state) => valueOf(parameter, state.values));
  const problem = useCurrent((state) => state.problem);
  const [isUnreadable, setUnreadable] = useState(false);
  const [resets, setResets] = useState(0);
  const [isEditing, setIsEditing] = useState(false);
  const error = parameterErrors(problem, parameter.name)[0]?.detail ?? "";
  const isChanged = !sameValue(value, parameter.initial);
  const set = (next: ParameterValue, moving: boolean): void => {
    session.setParameter(parameter, next, moving);
  };
  const reset = (): void => {
    // Also drops a text in the field that never became a value.
    setResets(resets + 1);
    setUnreadable(false);
    set(parameter.initial, true);
  };
  const described = [parameter.description && `${id}-about`, error && `${id}-error`].filter(Boolean).join(" ");
  const field: FieldProps = {
    id,
    parameter,
    value,
    invalid: error !== "",
    describedBy: described || undefined,
    onChange: set,
    onUnreadable: setUnreadable,
  };
  return (
    <div className="parameter" data-invalid={error !== ""} data-parameter={parameter.name}>
      <label
        className="parameter-label"
        htmlFor={id}
        title={`${parameter.name}: double-click for the default`}
        onDoubleClick={reset}
      >
        {parameter.label}
      </label>
      <Field key={resets} {...field} />
      <button
        type="button"
        className="reset"
        aria-label={`Reset ${parameter.label}`}
        title="Back to the default"
        disabled={!isChanged && !isUnreadable}
        onClick={reset}
      >
        <Icon name="reset" />
      </button>
      <button
        type="button"
        className="reset"
        aria-label={`Settings of ${parameter.label}`}
        title="Label, range and default"
        aria-expanded={isEditing}
        onClick={() => setIsEditing(!isEditing)}
      >
        <Icon name="pencil" />
      </button>
      {error && (
        <p className="parameter-error" id={`${id}-error`} role="alert">
          <Icon name="alert" />
          <span>{error}</span>
        </p>
      )}
      {parameter.description && (
        <p className="parameter-about" id={`${id}-about`}>
          {parameter.description}
        </p>
      )}
      {isEditing && <ParameterEditor parameter={parameter} />}
    </div>
  );
}

function Field(props: FieldProps): ReactElement {
  switch (props.parameter.type) {
    case "number":
    case "integer":
      return <NumberField {...props} />;
    case "boolean":
      return <SwitchField {...props} />;
    case "choice":
      return <ChoiceField {...props} />;
    case "vector":
      return <VectorField {...props} />;
    case "color":
      return <ColorField {...props} />;
    default:
      return <TextField {...props} />;
  }
}
