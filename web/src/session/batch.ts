// The model of one variant of a batch, wherever it is by now.

import { evaluate } from "../net/api";
import type { EvaluateBody } from "../net/requests";
import { fetchArtifact, type SweepLine } from "../net/sweeps";

export const DRAFT = { quality: "draft", triangles: 20_000 } as const;

/** The bytes, or why there are none. `body` evaluates the same once more. Rejects only after `signal`. */
export async function modelOf(
  line: SweepLine,
  body: EvaluateBody,
  signal: AbortSignal,
): Promise<{ bytes: Uint8Array<ArrayBuffer> } | { error: string }> {
  if (line.error) return { error: line.error };
  const kept = line.sha256 ? await fetchArtifact(line.sha256, signal) : undefined;
  if (kept) return { bytes: kept };
  // The server has forgotten it already.
  const answer = await evaluate(body, DRAFT, signal);
  return answer.kind === "model" ? { bytes: answer.model } : { error: "The model did not come." };
}
