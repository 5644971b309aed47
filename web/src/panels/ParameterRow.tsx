import { type ReactElement, useId, useState } from "react";
import { clamp, type Parameter, type ParameterValue, parameterValue, sameValue } from "../model/parameters";
import { parameterErrors } from "../net/problem";
import { valuesOf } from "../session/paths";
import { IconButton } from "../widgets/Button";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { describedBy } from "../widgets/FieldError";
import { Icon } from "../widgets/Icon";
import { ValueField } from "../widgets/ValueField";
import { ParameterEditor } from "./ParameterEditor";
import { ParameterGrip } from "./ParameterGrip";

/** Label, field, reset button, description and error of one parameter. */
export function ParameterRow({ parameter }: { parameter: Parameter }): ReactElement {
  const session = useCurrentSession();
  const id = useId();
  const value = useCurrent((state) => parameterValue(parameter, valuesOf(state)));
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
  const described = describedBy(parameter.description && `${id}-about`, error && `${id}-error`);
  return (
    <div className="parameter" data-invalid={error !== ""} data-parameter={parameter.name}>
      <ParameterGrip parameter={parameter} />
      <label
        className="parameter-label"
        htmlFor={id}
        title={`${parameter.name}: double-click for the default`}
        onDoubleClick={reset}
        onPointerEnter={() => parameter.type === "number" && session.sensitivity.show(parameter.name)}
        onPointerLeave={() => session.sensitivity.hide()}
      >
        {parameter.label}
      </label>
      <ValueField
        key={resets}
        {...{ id, parameter, value, described }}
        label={parameter.label}
        partLabel={(letter) => `${parameter.label} ${letter}`}
        look="form"
        invalid={error !== ""}
        within={(next) => clamp(parameter, next)}
        onChange={set}
        onUnreadable={setUnreadable}
      />
      <IconButton
        className="reset"
        label={`Reset ${parameter.label}`}
        icon="reset"
        hint="Back to the default"
        disabled={!isChanged && !isUnreadable}
        onClick={reset}
      />
      <IconButton
        className="reset"
        label={`Settings of ${parameter.label}`}
        icon="pencil"
        hint="Label, range and default"
        expanded={isEditing}
        onClick={() => setIsEditing(!isEditing)}
      />
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
