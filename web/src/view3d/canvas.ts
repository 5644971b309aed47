// The canvas of the view and what draws on it.

import { WebGLRenderer } from "three";

/**
 * A renderer with a canvas that can have the focus. `quality` is "plain" where WebGL runs on the processor, where smooth
 * edges and small pixels take long. Throws if WebGL 2 is not available.
 */
export function makeRenderer(
  container: HTMLElement,
  label: string,
  quality: "fine" | "plain" | "usual",
): WebGLRenderer {
  const antialias = quality !== "plain";
  const renderer = new WebGLRenderer({ antialias, alpha: true, powerPreference: "high-performance" });
  const ratios = { fine: 2, plain: 1, usual: Math.min(2, window.devicePixelRatio) };
  renderer.setPixelRatio(ratios[quality]);
  renderer.setClearColor(0x000000, 0);
  renderer.localClippingEnabled = true;
  const canvas = renderer.domElement;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", label);
  container.append(canvas);
  return renderer;
}
