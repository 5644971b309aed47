import { type ReactElement, useMemo, useState } from "react";
import { WireCheck } from "../model/check";
import { disconnect } from "../model/edit_wires";
import { matchText } from "../model/search";
import type { Position } from "../model/ui";
import { type SocketPlace, socketKey } from "../session/editor";
import { type Choice, Chooser } from "../widgets/Chooser";
import { useCurrent, useEditor } from "../widgets/context";
import { Mark } from "../widgets/Mark";
import { Popup } from "../widgets/Popup";
import { between, draw, wiringFrom } from "./wiring";

interface EndChoice extends Choice {
  place?: SocketPlace;
  run?(): void;
}

/** Connecting without a pointer: every socket that the given one can be joined to, and what else can be done with it. */
export function ConnectList({ start }: { start: SocketPlace & { screen: Position } }): ReactElement | null {
  const editor = useEditor();
  const view = useCurrent((state) => state.view);
  const document = useCurrent((state) => state.document);
  const [text, setText] = useState("");
  const choices = useMemo<EndChoice[]>(() => {
    const { refusals } = wiringFrom(editor, start);
    const side = start.side === "output" ? "input" : "output";
    const present = (view?.wires ?? []).filter((wire) =>
      start.side === "input"
        ? wire.to === start.node && wire.input === start.name
        : wire.from === start.node && wire.output === start.name,
    );
    const found: EndChoice[] = [];
    for (const node of view?.nodes ?? []) {
      for (const row of side === "input" ? node.rows : node.outputs) {
        const place: SocketPlace = { node: node.id, side, name: row.name };
        if (refusals.has(socketKey(place)) || node.id === start.node) continue;
        if (!matchText(`${node.title} ${node.id} ${row.name} ${row.title}`, text)) continue;
        found.push({
          place,
          key: socketKey(place).replace(/[^\w-]/g, "_"),
          content: (
            <>
              <Mark type={row.type} />
              <span className="chooser-title">{node.title}</span>
              <span className="chooser-socket">{row.title}</span>
              <span className="chooser-family">{node.id}</span>
            </>
          ),
        });
      }
    }
    const more: EndChoice[] = present.map((wire) => {
      const other = start.side === "input" ? `${wire.from}` : `${wire.input} of ${wire.to}`;
      return {
        key: `off-${wire.id}`.replace(/[^\w-]/g, "_"),
        content: <span className="chooser-title">Disconnect {other}</span>,
        run: () => {
          editor.session.edit("Disconnect", disconnect(wire));
          editor.say(`Disconnected ${wire.input} of ${wire.to}`);
        },
      };
    });
    more.push({
      key: "new",
      content: <span className="chooser-title">New node…</span>,
      run: () => openSearchFrom(editor, start),
    });
    const shown = more.filter((item) => item.key === "new" || matchText("disconnect", text));
    const headed = shown.map((item, index) => (index === 0 && found.length > 0 ? { ...item, heading: "More" } : item));
    return [...found, ...headed];
  }, [editor, view, start, text]);
  const close = (): void => editor.store.set({ connecting: null });
  if (!document) return null;
  const from = view?.byId.get(start.node);
  const rows = start.side === "output" ? from?.outputs : from?.rows;
  const socket = rows?.find(({ name }) => name === start.name)?.title ?? start.name;
  const label = `Connect ${socket} of ${from?.title ?? start.node}`;
  return (
    <Popup screen={start.screen} label={label} className="node-search" onClose={close}>
      <Chooser
        label={label}
        placeholder={start.side === "output" ? "Connect to…" : "Connect from…"}
        choices={choices}
        text={text}
        onText={setText}
        empty="No socket takes this wire."
        onChoose={(item) => {
          close();
          if (item.run) item.run();
          if (item.place) {
            draw(editor, between(start, item.place));
            editor.canvas?.focusSocket(start);
          }
        }}
      />
    </Popup>
  );
}

/** The search for a node at the end of a wire from this socket. */
export function openSearchFrom(editor: ReturnType<typeof useEditor>, start: SocketPlace & { screen: Position }): void {
  const { document, catalogue, view } = editor.session.store.get();
  const box = editor.canvas?.boxes().get(start.node);
  if (!document || !catalogue || !view || !box || !editor.canvas) return;
  const types =
    start.side === "output"
      ? new WireCheck(document, catalogue).types.possible(start.node, start.name)
      : (view.byId.get(start.node)?.rows.find((row) => row.name === start.name)?.types ?? []);
  const place = { x: start.side === "output" ? box.x + box.width + 60 : box.x - 60, y: box.y + 46 };
  const { node, side, name } = start;
  editor.openSearch({ screen: start.screen, place, loose: { node, side, name, types } });
}
