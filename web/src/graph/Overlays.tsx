import { type CSSProperties, type ReactElement, useEffect, useState } from "react";
import { createPortal } from "react-dom";
import type { Editor, Inspected } from "../session/editor";
import { useEditing } from "../widgets/context";
import { PointMenu } from "../widgets/Menu";
import { ConnectList } from "./ConnectList";
import { FindNode } from "./FindNode";
import { MENU_LABELS, menuItems } from "./menu_items";
import { NodeSearch } from "./NodeSearch";

const NOTICE_MILLISECONDS = { said: 2200, refused: 4500 };
/** What is longer than a short sentence takes longer to read. */
const MILLISECONDS_A_LETTER = 60;
const SHORT_LETTERS = 40;

/** What opens over the canvas: the search, menus, lists, and what is said about a socket or an action. */
export function Overlays({ editor }: { editor: Editor }): ReactElement {
  const search = useEditing((state) => state.search);
  const menu = useEditing((state) => state.menu);
  const connecting = useEditing((state) => state.connecting);
  const finding = useEditing((state) => state.finding);
  const inspected = useEditing((state) => state.inspected);
  return (
    <>
      <Notice editor={editor} />
      {createPortal(
        <>
          {search && <NodeSearch search={search} />}
          {menu && (
            <PointMenu
              key={`${menu.screen.x} ${menu.screen.y}`}
              label={MENU_LABELS[menu.target.kind]}
              items={menuItems(editor, menu)}
              screen={menu.screen}
              onClose={() => editor.store.set({ menu: null })}
            />
          )}
          {connecting && <ConnectList start={connecting} />}
          {finding && <FindNode />}
          {inspected && <SocketTip inspected={inspected} />}
        </>,
        document.body,
      )}
    </>
  );
}

/** What was done or refused last: heard by screen readers, and seen for a moment. */
function Notice({ editor }: { editor: Editor }): ReactElement {
  const notice = useEditing((state) => state.notice);
  const [gone, setGone] = useState(0);
  useEffect(() => {
    if (!notice) return undefined;
    const more = MILLISECONDS_A_LETTER * Math.max(0, notice.text.length - SHORT_LETTERS);
    const timer = window.setTimeout(() => setGone(notice.count), NOTICE_MILLISECONDS[notice.tone] + more);
    return () => window.clearTimeout(timer);
  }, [notice, editor]);
  const isShown = notice !== null && notice.count !== gone;
  return (
    <div className="notice" role="status" aria-label="Last action" data-tone={notice?.tone} data-shown={isShown}>
      {notice?.text}
    </div>
  );
}

function SocketTip({ inspected }: { inspected: Inspected }): ReactElement {
  const { screen, side, title, description, lines } = inspected;
  const isLeft = side === "input";
  const style: CSSProperties = {
    left: isLeft ? undefined : Math.min(screen.x + 14, window.innerWidth - 300),
    right: isLeft ? Math.max(8, window.innerWidth - screen.x + 14) : undefined,
    top: Math.max(8, screen.y - 10),
  };
  return (
    <div className="socket-tip" role="tooltip" style={style}>
      <strong>{title}</strong>
      {description && <span>{description}</span>}
      {lines.map((line) => (
        <code key={line}>{line}</code>
      ))}
    </div>
  );
}
