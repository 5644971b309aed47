import { Fragment, type ReactElement } from "react";
import { groupedParameters } from "../model/parameter_groups";
import { valuesOf } from "../session/paths";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { Icon } from "../widgets/Icon";
import { ParameterRow } from "./ParameterRow";
import { PlayerBar } from "./PlayerBar";
import { Variants } from "./Variants";

/** A row per graph parameter. Changing one evaluates the graph again. */
export function Controls(): ReactElement {
  const session = useCurrentSession();
  const open = useCurrent((state) => state.document);
  const isChanged = useCurrent((state) => Object.keys(valuesOf(state)).length > 0);
  if (!open) return <p className="empty">No graph is open.</p>;
  return (
    <div className="controls">
      {open.description && <p className="controls-description">{open.description}</p>}
      {open.parameters.length === 0 && (
        <p className="empty">This {open.inside.length > 0 ? "group has no inputs" : "graph has no parameters"}.</p>
      )}
      <div className="parameter-rows" key={open.title}>
        {groupedParameters(open).map(({ title, parameters }, at) => (
          <Fragment key={parameters[0]?.name}>
            {title ? <h3 className="parameter-group">{title}</h3> : at > 0 && <hr className="parameter-rest" />}
            {parameters.map((parameter) =>
              parameter.isWireOnly ? null : <ParameterRow key={parameter.name} parameter={parameter} />,
            )}
          </Fragment>
        ))}
      </div>
      <PlayerBar />
      <Variants />
      {isChanged && (
        <button type="button" className="button quiet" onClick={() => session.resetParameters()}>
          <Icon name="reset" />
          <span>Reset all</span>
        </button>
      )}
    </div>
  );
}
