import { type ReactElement, useEffect, useRef, useState } from "react";
import { listGraphs, listVersions, readGraph, type StoredList, type StoredVersion } from "../net/graph_store";
import { problemText } from "../net/problem";
import { IconButton } from "../widgets/Button";
import { useCurrentSession } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";
import { GraphPicture } from "../widgets/GraphPicture";
import { agoText } from "./ago";
import { filesOf } from "./Files";

/** The graphs that the server keeps, with their pictures and versions. */
export function OpenStoredDialog(): ReactElement {
  const files = filesOf(useCurrentSession());
  const [query, setQuery] = useState("");
  const [list, setList] = useState<StoredList | null>(null);
  const [error, setError] = useState("");
  const [attempt, setAttempt] = useState(0);
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => {
    let isGone = false;
    setError("");
    void listGraphs(query).then((found) => {
      if (isGone) return;
      if ("value" in found) setList(found.value);
      else setError(problemText(found.problem));
    });
    return () => {
      isGone = true;
    };
  }, [query, attempt]);
  return (
    <Dialog title="Open from the server" className="stored-dialog" onClose={() => files.show(null)}>
      <input
        ref={field}
        className="text-field"
        type="search"
        aria-label="Find a graph"
        placeholder="Find by name or title"
        value={query}
        onChange={(event) => setQuery(event.currentTarget.value)}
      />
      {error && (
        <p className="dialog-error" role="alert">
          {error}{" "}
          <button type="button" className="button" onClick={() => setAttempt(attempt + 1)}>
            Try again
          </button>
        </p>
      )}
      {!error && list?.graphs.length === 0 && (
        <p className="empty">
          {query
            ? `No graph is called like “${query}”.`
            : "The server keeps no graphs yet. File, Save to the server keeps this one."}
        </p>
      )}
      <ul className="kept-list">
        {list?.graphs.map((graph) => (
          <Row
            key={graph.id}
            graph={graph}
            onDeleted={() => {
              // The row goes, and the focus with it.
              field.current?.focus();
              setAttempt((before) => before + 1);
            }}
          />
        ))}
      </ul>
      {list?.isMore && <p className="dialog-note">There are more; type a part of their names.</p>}
    </Dialog>
  );
}

function Row({ graph, onDeleted }: { graph: StoredVersion; onDeleted(): void }): ReactElement {
  const files = filesOf(useCurrentSession());
  const [isDeleting, setDeleting] = useState(false);
  const [error, setError] = useState("");
  const [versions, setVersions] = useState<StoredVersion[] | null>(null);
  const toggle = async (): Promise<void> => {
    if (versions) {
      setVersions(null);
      return;
    }
    const found = await listVersions(graph.id);
    if ("value" in found) setVersions(found.value);
    setError("value" in found ? "" : problemText(found.problem));
  };
  const remove = async (): Promise<void> => {
    const failed = await files.stored.remove(graph);
    setError(failed);
    setDeleting(false);
    if (!failed) onDeleted();
  };
  const title = graph.title || graph.id;
  return (
    <li aria-label={title}>
      <StoredPicture graph={graph} />
      <span className="kept-text">
        <strong>{title}</strong>
        <span>
          {graph.id} · version {graph.version} · {agoText(Date.now() - graph.created)}
        </span>
      </span>
      {graph.version > 1 && (
        <button type="button" className="button quiet" aria-expanded={versions !== null} onClick={() => void toggle()}>
          Versions
        </button>
      )}
      {isDeleting ? (
        <button
          type="button"
          className="button kept-delete"
          autoFocus
          onClick={() => void remove()}
          onBlur={() => setDeleting(false)}
        >
          Really delete {graph.id}
        </button>
      ) : (
        <IconButton
          label={`Delete ${graph.id}`}
          icon="trash"
          hint="Take it out of this list; addresses of its versions go on working"
          onClick={() => setDeleting(true)}
        />
      )}
      <button
        type="button"
        className="button primary"
        aria-label={`Open ${graph.id}`}
        onClick={() => void files.stored.open(graph.id)}
      >
        Open
      </button>
      {error && (
        <p className="dialog-error" role="alert">
          {error}
        </p>
      )}
      {versions && (
        <ul className="version-list" aria-label={`Versions of ${graph.id}`}>
          {versions.map(({ version, title: called, created }) => (
            <li key={version}>
              <span>
                Version {version} · {called || graph.id} · {agoText(Date.now() - created)}
              </span>
              <button
                type="button"
                className="button quiet"
                aria-label={`Open version ${version} of ${graph.id}`}
                onClick={() => void files.stored.open(`${graph.id}@${version}`)}
              >
                Open
              </button>
            </li>
          ))}
        </ul>
      )}
    </li>
  );
}

/** What one version of a stored graph looks like. */
export function StoredPicture({ graph: { id, version, tag } }: { graph: StoredVersion }): ReactElement {
  const read = async () => {
    const found = await readGraph(`${id}@${version}`);
    return "value" in found ? found.value.json : null;
  };
  return <GraphPicture id={`stored ${id} ${tag}`} read={read} />;
}
