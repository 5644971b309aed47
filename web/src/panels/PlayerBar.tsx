import { type ReactElement, useEffect, useRef, useState } from "react";
import { numberText } from "../model/format";
import type { Parameter } from "../model/parameters";
import { isPlayable, MOST_STEPS, type PlayMode } from "../model/steps";
import { type Player, playerOf, Stopped } from "../session/player";
import { recordPictures, recordVideo, saveAnimation } from "../session/recording";
import { IconButton } from "../widgets/Button";
import { useCurrent, useCurrentSession, useWholeParameters } from "../widgets/context";
import { useStore } from "../widgets/hooks";
import { Icon } from "../widgets/Icon";
import { Segments } from "../widgets/Segments";
import { SliderBar } from "../widgets/SliderBar";

const MODES: readonly { id: PlayMode; title: string; hint: string }[] = [
  { id: "loop", title: "Loop", hint: "From the end back to the beginning" },
  { id: "swing", title: "Back and forth", hint: "To the end, and the same way back" },
  { id: "once", title: "Once", hint: "To the end, and stop" },
];
const SPEEDS = [2, 6, 12, 24, 30, 60];
const COUNTS = [12, 24, 48, 96, MOST_STEPS];
const USUAL_COUNT = 48;

/** The button that opens the player; nothing where no parameter can be played. */
export function PlayButton(): ReactElement | null {
  const player = playerOf(useCurrentSession());
  const isOpen = useStore(player.store, ({ parameter }) => parameter !== null);
  const first = useWholeParameters().find(isPlayable)?.name;
  const canDraw = useCurrent(({ drawn }) => drawn !== null);
  if (first === undefined || isOpen || !canDraw) return null;
  return (
    <button
      type="button"
      className="button quiet"
      title="Show the model while a parameter goes through its range"
      onClick={() => {
        player.open(first, USUAL_COUNT);
        player.play();
      }}
    >
      <Icon name="play" />
      <span>Play a parameter</span>
    </button>
  );
}

/** What plays a parameter: which one, how, how quickly; and what can be made of it. Nothing while it is closed. */
export function PlayerBar(): ReactElement | null {
  const player = playerOf(useCurrentSession());
  const { parameter, values, mode, speed, isPlaying, step, ready, missing, error } = useStore(
    player.store,
    (state) => state,
  );
  const parameters = useWholeParameters();
  if (parameter === null) return null;
  const choices = parameters.filter(isPlayable);
  const current = choices.find(({ name }) => name === parameter);
  return (
    <section className="player" aria-label="Player">
      <div className="player-row">
        <button
          type="button"
          className="button primary"
          aria-label={isPlaying ? "Pause" : "Play"}
          onClick={() => (isPlaying ? player.pause() : player.play())}
        >
          <Icon name={isPlaying ? "pause" : "play"} />
        </button>
        <Choice
          label="Parameter to play"
          value={parameter}
          options={choices.map(({ name, label }) => ({ value: name, title: label }))}
          onChoose={(name) => player.open(name, values.length)}
        />
        <Track player={player} current={current} />
        <IconButton label="Close the player" icon="close" onClick={() => player.close(true)} />
      </div>
      <div className="player-row">
        <Segments label="Play" options={MODES} chosen={mode} onChoose={(next) => player.set({ mode: next })} />
        <Choice
          label="Speed"
          value={String(speed)}
          options={SPEEDS.map((one) => ({ value: String(one), title: `${one} a second` }))}
          onChoose={(next) => player.set({ speed: Number(next) })}
        />
        <Choice
          label="Steps"
          value={String(values.length)}
          options={[...new Set([...COUNTS, values.length])]
            .sort((a, b) => a - b)
            .map((one) => ({ value: String(one), title: `${one} steps` }))}
          onChoose={(next) => player.open(parameter, Number(next))}
        />
      </div>
      <Recording player={player} isReady={ready > 0 && ready + missing === values.length} />
      <p className="player-state" role="status" data-tone={error ? "error" : undefined}>
        {error ||
          (ready + missing < values.length
            ? `${ready} of ${values.length} steps are here`
            : stepText(step, values, current))}
      </p>
    </section>
  );
}

function stepText(step: number, values: readonly number[], parameter: Parameter | undefined): string {
  const value = values[step];
  const all = `${values.length} steps`;
  return value === undefined ? all : `${parameter?.label ?? ""} ${numberText(value)}, step ${step + 1} of ${all}`;
}

/** The steps as a slider; moving it shows the step. */
function Track({ player, current }: { player: Player; current: Parameter | undefined }): ReactElement {
  const { values, step } = useStore(player.store, (state) => state);
  return (
    <span className="player-track">
      <SliderBar
        label={`Step of ${current?.label ?? "the player"}`}
        text={stepText(step, values, current)}
        minimum={0}
        maximum={Math.max(1, values.length - 1)}
        step={1}
        value={Math.max(0, step)}
        onMove={(next) => void player.show(Math.min(values.length - 1, Math.max(0, Math.round(next))))}
      />
    </span>
  );
}

function Recording({ player, isReady }: { player: Player; isReady: boolean }): ReactElement {
  const [doing, setDoing] = useState("");
  const [error, setError] = useState("");
  const request = useRef(new AbortController());
  useEffect(() => () => request.current.abort(), []);
  const run = (what: string, work: () => Promise<void>): void => {
    setDoing(what);
    setError("");
    work()
      .catch((reason: unknown) => {
        if (!request.current.signal.aborted && !(reason instanceof Stopped))
          setError(reason instanceof Error ? reason.message : String(reason));
      })
      .finally(() => setDoing(""));
  };
  const isBusy = doing !== "" || !isReady;
  return (
    <div className="player-row">
      <button
        type="button"
        className="button"
        disabled={isBusy}
        onClick={() => run("video", () => recordVideo(player))}
      >
        <Icon name="record" />
        <span>Video (WebM)</span>
      </button>
      <button
        type="button"
        className="button"
        disabled={isBusy}
        onClick={() => run("pictures", () => recordPictures(player))}
      >
        <Icon name="camera" />
        <span>Pictures (PNG)</span>
      </button>
      <button
        type="button"
        className="button"
        disabled={isBusy}
        title="One model with a node for each step, and an animation that shows them in turn"
        onClick={() => run("model", () => saveAnimation(player, request.current.signal))}
      >
        <Icon name="download" />
        <span>Animated GLB</span>
      </button>
      {doing !== "" && <span className="muted">{doing === "model" ? "Making…" : "Recording…"}</span>}
      {error && (
        <span className="player-error" role="alert">
          {error}
        </span>
      )}
    </div>
  );
}

interface ChoiceProps {
  label: string;
  value: string;
  options: readonly { value: string; title: string }[];
  onChoose(value: string): void;
}

function Choice({ label, value, options, onChoose }: ChoiceProps): ReactElement {
  return (
    <select
      className="select"
      aria-label={label}
      value={value}
      onChange={(event) => onChoose(event.currentTarget.value)}
    >
      {options.map((option) => (
        <option key={option.value} value={option.value}>
          {option.title}
        </option>
      ))}
    </select>
  );
}
