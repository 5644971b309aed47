// What is played, as files: a video, a sequence of pictures, or one model with an animation.

import { withAnimation } from "../model/animated_glb";
import { fileName } from "../model/format";
import { roundOf } from "../model/steps";
import { zipOf } from "../model/zip";
import { problemText } from "../net/problem";
import { sweepToGlb } from "../net/sweeps";
import { saveBlob } from "./download";
import type { Player } from "./player";
import type { PictureViewer } from "./state";

const BITS_PER_SECOND = 12_000_000;
const VIDEO_TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];

/** Plays one round and saves it as a WebM video, each step as long as its speed says. */
export async function recordVideo(player: Player): Promise<void> {
  const type = VIDEO_TYPES.find((one) => typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported(one));
  if (type === undefined) throw new Error("This browser records no video; a sequence of pictures works in any.");
  const { speed } = player.store.get();
  const canvas = document.createElement("canvas");
  const parts: Blob[] = [];
  let recorder: MediaRecorder | undefined;
  let stream: MediaStream | undefined;
  const record = async (viewer: PictureViewer): Promise<void> => {
    const still = viewer.still();
    if (!recorder) {
      // A canvas that changes its size would begin another video.
      [canvas.width, canvas.height] = [still.width, still.height];
      stream = canvas.captureStream();
      recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: BITS_PER_SECOND });
      recorder.ondataavailable = ({ data }) => parts.push(data);
      canvas.getContext("2d")?.drawImage(still, 0, 0);
      recorder.start();
    }
    canvas.getContext("2d")?.drawImage(still, 0, 0, canvas.width, canvas.height);
    await new Promise((done) => window.setTimeout(done, 1000 / speed));
  };
  try {
    await player.walk(record);
    await ended(recorder);
  } finally {
    // Also where it was stopped: a stream that nobody ends goes on taking pictures.
    for (const track of stream?.getTracks() ?? []) track.stop();
  }
  if (parts.length === 0) return;
  saveBlob(new Blob(parts, { type: "video/webm" }), `${nameOf(player)}.webm`);
}

/** Ends a recording and waits for its last part. */
async function ended(recorder: MediaRecorder | undefined): Promise<void> {
  if (!recorder || recorder.state === "inactive") return;
  await new Promise<void>((done) => {
    recorder.onstop = () => done();
    recorder.stop();
  });
}

/** Plays one round and saves a picture of each step, in one archive. */
export async function recordPictures(player: Player): Promise<void> {
  const files: { name: string; bytes: Uint8Array }[] = [];
  await player.walk(async (viewer) => {
    const blob = await new Promise<Blob | null>((done) => viewer.still().toBlob(done, "image/png"));
    if (!blob) throw new Error("The browser made no picture.");
    const number = String(files.length + 1).padStart(4, "0");
    files.push({ name: `${nameOf(player)}-${number}.png`, bytes: new Uint8Array(await blob.arrayBuffer()) });
  });
  saveBlob(new Blob([zipOf(files)], { type: "application/zip" }), `${nameOf(player)}.zip`);
}

/** Saves one GLB with a node for each step and an animation that shows them in turn, in full quality. */
export async function saveAnimation(player: Player, signal: AbortSignal): Promise<void> {
  const { parameter, values, mode, speed } = player.store.get();
  const body = player.session.drawnBody();
  if (parameter === null || body?.output === undefined) return;
  const { [parameter]: _, ...parameters } = body.parameters;
  const { graph, output } = body;
  const grid = { [parameter]: values };
  const answer = await sweepToGlb({ graph, parameters, grid, output, quality: "final" }, signal);
  if (answer.kind === "away") throw new Error("The server does not answer.");
  if (answer.kind === "problem") throw new Error(problemText(answer.problem));
  const bytes = withAnimation(answer.model, roundOf(values.length, mode), 1 / speed);
  saveBlob(new Blob([bytes], { type: "model/gltf-binary" }), `${nameOf(player)}.glb`);
}

function nameOf({ session, store }: Player): string {
  return fileName(`${session.store.get().document?.title ?? ""} ${store.get().parameter ?? ""}`);
}
