import type { ReactElement } from "react";
import { unitText } from "../model/catalogue";
import { literalText } from "../model/format";
import type { Json } from "../model/json";
import { parameterValue } from "../model/parameters";
import { useCurrent } from "../widgets/context";

/** The parameter that drives an input, with its present value. */
export function DrivenBy({ name, label }: { name: string; label: string }): ReactElement {
  const value = useCurrent(({ document, values }) => {
    const parameter = document?.parameters.find((one) => one.name === name);
    if (!parameter) return "";
    const unit = typeof parameterValue(parameter, values) === "number" ? unitText(parameter.unit) : "";
    return literalText(parameterValue(parameter, values) as Json) + unit;
  });
  return (
    <span className="row-parameter" title={`Driven by the parameter “${label}”: ${value}`}>
      <span className="row-parameter-name">
        <span aria-hidden="true">◈</span> {label}
      </span>
      <span className="row-parameter-value">{value}</span>
    </span>
  );
}
