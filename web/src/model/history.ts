// Undo and redo: whole states, one step per gesture. States share what they have in common, so a step costs little.

export interface Step<State> {
  state: State;
  /** What led from this state to the next one, as a menu says it. */
  label: string;
}

const MOST_STEPS = 300;

export class History<State> {
  private past: Step<State>[] = [];
  private future: Step<State>[] = [];
  private gesture: string | undefined;

  /** Remembers the state before a change. A change of the gesture that is under way belongs to the same step. */
  record(before: State, label: string, gesture?: string): void {
    const isSame = gesture !== undefined && gesture === this.gesture;
    this.gesture = gesture;
    if (isSame) return;
    this.past.push({ state: before, label });
    if (this.past.length > MOST_STEPS) this.past.shift();
    this.future = [];
  }

  /** The gesture is over: the next change is a step of its own. */
  endGesture(): void {
    this.gesture = undefined;
  }

  /** The gesture that is under way did not happen: the state before it, and no step to redo. */
  cancel(gesture: string): State | undefined {
    if (gesture !== this.gesture) return undefined;
    this.gesture = undefined;
    return this.past.pop()?.state;
  }

  undo(present: State): State | undefined {
    return this.move(this.past, this.future, present);
  }

  redo(present: State): State | undefined {
    return this.move(this.future, this.past, present);
  }

  /** What undo would take back; undefined if there is nothing. */
  get undoLabel(): string | undefined {
    return this.past.at(-1)?.label;
  }

  get redoLabel(): string | undefined {
    return this.future.at(-1)?.label;
  }

  clear(): void {
    this.past = [];
    this.future = [];
    this.gesture = undefined;
  }

  private move(from: Step<State>[], to: Step<State>[], present: State): State | undefined {
    this.gesture = undefined;
    const step = from.pop();
    if (!step) return undefined;
    to.push({ state: present, label: step.label });
    return step.state;
  }
}
