// Which nodes are drawn: of a large graph those in sight, as long as they are few.

import type { Viewport } from "@xyflow/react";
import { type RefObject, useCallback, useState } from "react";
import type { Box } from "../model/ui";
import { useEditor } from "../widgets/context";

/** Nodes out of sight are left out from this number on; below it, bringing them back costs more than it saves. */
const LEFT_OUT_FROM = 150;
/** Where this share of the nodes is in sight, all are drawn: else each movement brings some and takes others away. */
const DRAWN_FROM = 0.6;
/** Below this share the others are left out again. */
const LEFT_OUT_BELOW = 0.3;

/** The share of boxes that a pane of the given size shows a part of. */
export function shareInSight(
  boxes: readonly Box[],
  { x, y, zoom }: Viewport,
  pane: { width: number; height: number },
): number {
  const seen = boxes.filter((box) => {
    const [left, top] = [x + zoom * box.x, y + zoom * box.y];
    return left < pane.width && top < pane.height && left + zoom * box.width > 0 && top + zoom * box.height > 0;
  });
  return boxes.length > 0 ? seen.length / boxes.length : 0;
}

interface InSight {
  /** Whether nodes out of sight are left out. */
  isCut: boolean;
  /** To be told where the canvas comes to rest. */
  noteRest(event: unknown, viewport: Viewport): void;
}

/** `count`: of all nodes. */
export function useInSight(element: RefObject<HTMLElement | null>, count: number): InSight {
  const editor = useEditor();
  const isLarge = count > LEFT_OUT_FROM;
  const [isMost, setMost] = useState(false);
  const noteRest = useCallback(
    (_event: unknown, viewport: Viewport) => {
      const pane = element.current;
      // Of a small graph nothing is said: much may be added to it before the canvas rests again.
      if (!isLarge || !pane || !editor.canvas) {
        setMost(false);
        return;
      }
      const { clientWidth: width, clientHeight: height } = pane;
      const share = shareInSight([...editor.canvas.boxes().values()], viewport, { width, height });
      setMost((wasMost) => share >= (wasMost ? LEFT_OUT_BELOW : DRAWN_FROM));
    },
    [editor, element, isLarge],
  );
  return { isCut: isLarge && !isMost, noteRest };
}
