import type { ReactElement } from "react";
import { sameValues } from "../model/parameters";
import { addVariant, removeVariant, renameVariant, type Variant, variantDocument, variantsOf } from "../model/variants";
import { comparisonOf } from "../session/comparison";
import { IconButton } from "../widgets/Button";
import { useCurrent, useCurrentSession, useWholeParameters } from "../widgets/context";
import { GraphPicture } from "../widgets/GraphPicture";
import { Icon } from "../widgets/Icon";
import { ContactSheetButton } from "./ContactSheet";
import { PlayButton } from "./PlayerBar";

/** Sets of the form's values that were kept, with their pictures: one press brings a set back. */
export function Variants(): ReactElement | null {
  const session = useCurrentSession();
  const open = useCurrent((state) => state.document);
  const values = useCurrent((state) => state.values);
  const isEmpty = useWholeParameters().length === 0;
  if (!open || isEmpty) return null;
  const variants = variantsOf(open);
  return (
    <section className="variants" aria-label="Variants">
      {variants.length > 0 && (
        <ul>
          {variants.map((variant, place) => (
            // Two may have one name, and the same values.
            // biome-ignore lint/suspicious/noArrayIndexKey: a variant is its place in the list.
            <li key={place} aria-label={variant.name}>
              <Card variant={variant} place={place} isChosen={sameValues(variant.values, values)} />
            </li>
          ))}
        </ul>
      )}
      <div className="variant-actions">
        <button
          type="button"
          className="button quiet"
          title="Keep these values, to come back to them"
          onClick={() => session.edit("Keep a variant", addVariant(values))}
        >
          <Icon name="add" />
          <span>Keep as a variant</span>
        </button>
        <ContactSheetButton />
        <PlayButton />
      </div>
    </section>
  );
}

interface CardProps {
  variant: Variant;
  place: number;
  isChosen: boolean;
}

function Card({ variant, place, isChosen }: CardProps): ReactElement | null {
  const session = useCurrentSession();
  const comparison = comparisonOf(session);
  const open = useCurrent((state) => state.document);
  if (!open) return null;
  const json = variantDocument(open, variant);
  const key = JSON.stringify([open.json["nodes"], open.json["groups"], open.json["parameters"], variant.values]);
  return (
    <>
      <button
        type="button"
        className="variant"
        aria-pressed={isChosen}
        aria-label={`Use ${variant.name}`}
        onClick={() => session.takeValues(variant.values, `Use ${variant.name}`)}
      >
        <GraphPicture id={`variant ${key}`} read={() => Promise.resolve(json)} />
      </button>
      <input
        className="variant-name"
        aria-label={`Name of ${variant.name}`}
        defaultValue={variant.name}
        key={variant.name}
        spellCheck={false}
        onBlur={(event) => {
          const field = event.currentTarget;
          const name = field.value.trim();
          // Without a name it keeps the one that it has.
          field.value = name || variant.name;
          session.edit("Rename a variant", renameVariant(place, name));
        }}
        onKeyDown={(event) => {
          if (event.key === "Escape") event.currentTarget.value = variant.name;
          if (event.key === "Enter" || event.key === "Escape") event.currentTarget.blur();
        }}
      />
      <IconButton
        className="reset variant-compare"
        label={`Compare with ${variant.name}`}
        icon="compare"
        hint="Look at the present values and these together"
        onClick={() => void comparison.open(variant.name, variant.values)}
      />
      <IconButton
        className="reset"
        label={`Delete ${variant.name}`}
        icon="close"
        onClick={() => session.edit("Delete a variant", removeVariant(place))}
      />
    </>
  );
}
