import { type ReactElement, useEffect, useState } from "react";
import type { Json } from "../model/json";
import { useCurrentSession } from "./context";

interface GraphPictureProps {
  /** The same for the same graph. */
  id: string;
  /** Its document, asked for when its turn to be drawn has come. */
  read(): Promise<Json>;
}

/** What a graph that is not open looks like; an empty place until that is known, or where it makes nothing. */
export function GraphPicture({ id, read }: GraphPictureProps): ReactElement {
  const session = useCurrentSession();
  const [image, setImage] = useState("");
  // biome-ignore lint/correctness/useExhaustiveDependencies: the same graph is read once, whoever reads it.
  useEffect(() => {
    let isGone = false;
    void session.thumbnails.of(id, read).then((made) => isGone || setImage(made));
    return () => {
      isGone = true;
    };
  }, [session, id]);
  return <span className="graph-picture">{image && <img src={image} alt="" />}</span>;
}
