// The 3D view. Draws only when something changed; React never runs while it does.

import { Group, LineBasicMaterial, LineSegments, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { CameraPlace } from "../model/document";
import { Decoder, type DecodedModel } from "./decode";
import { studioOf } from "./dress";
import { frame, framingOf, placeCamera, samplePositions, type Framing } from "./framing";
import { turnByKey } from "./keys";
import { Materials, type ShadingMode } from "./materials";
import { cellSize, makeAxes, makeGrid, remove, type OverlayColors } from "./overlays";
import { isSoftwareRendering } from "./software";
import { wireGeometry } from "./wireframe";

export interface ViewSettings {
  mode: ShadingMode;
  grid: boolean;
  axes: boolean;
  light: boolean;
}

const HOME = new Vector3(-0.62, -0.5, -0.92);
const FIELD_OF_VIEW = 32;
const COLORS: Record<"dark" | "light", OverlayColors & { wire: string; soleWire: string }> = {
  dark: { grid: "#5a6374", axes: ["#ff7a6b", "#7ddb8c", "#4fb4ff"], wire: "#0d1017", soleWire: "#9db6ff" },
  light: { grid: "#8d97a8", axes: ["#d2402f", "#1f8f3e", "#1f74d0"], wire: "#1b2540", soleWire: "#3450a8" },
};

export class Viewer {
  readonly isSoftware: boolean;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 1000);
  private readonly controls: OrbitControls;
  private readonly materials = new Materials();
  private readonly decoder = new Decoder(this.materials);
  private readonly overlays = new Group();
  private readonly observer: ResizeObserver;
  private readonly wire = new LineBasicMaterial({ transparent: true });
  private model: DecodedModel | undefined;
  private wires: LineSegments[] = [];
  private grid: LineSegments | undefined;
  private axes: Group | undefined;
  private opening: CameraPlace | null = null;
  private radius = 1;
  private requested = 0;
  private settings: ViewSettings = { mode: "shaded", grid: true, axes: true, light: false };

  /**
   * Draws into a canvas of its own inside `container`; `smooth` also without a GPU, where it takes long. Throws if
   * WebGL 2 is not available.
   */
  constructor(
    private readonly container: HTMLElement,
    label: string,
    smooth: boolean,
  ) {
    this.isSoftware = isSoftwareRendering();
    this.renderer = new WebGLRenderer({
      antialias: smooth || !this.isSoftware,
      alpha: true,
      powerPreference: "high-performance",
    });
    this.renderer.setPixelRatio(smooth ? 2 : this.isSoftware ? 1 : Math.min(2, window.devicePixelRatio));
    this.renderer.setClearColor(0x000000, 0);
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", label);
    container.append(canvas);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.enableDamping = !this.isSoftware && !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.controls.dampingFactor = 0.12;
    this.controls.addEventListener("change", () => this.draw());
    canvas.addEventListener("keydown", (event) => this.onKey(event));
    // The graph's Z axis is the picture's up direction, as the export's root node turns it.
    this.overlays.rotation.x = -Math.PI / 2;
    this.scene.add(this.overlays);
    this.look(HOME, { target: new Vector3(), distance: 8, radius: 1 });
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(container);
    this.resize();
    this.rebuildOverlays();
  }

  decode(bytes: Uint8Array<ArrayBuffer>): Promise<DecodedModel> {
    return this.decoder.decode(bytes);
  }

  /** Replaces the shown model. */
  show(model: DecodedModel): void {
    this.clear();
    this.model = model;
    this.scene.add(model.scene);
    this.applyMode();
    this.draw();
  }

  /** Shows the first model of a document, and puts the camera where the document says. */
  open(model: DecodedModel, camera: CameraPlace | null): void {
    this.show(model);
    this.opening = camera;
    this.home();
  }

  clear(): void {
    this.dropWires();
    if (this.model) this.scene.remove(this.model.scene);
    this.model?.dispose();
    this.model = undefined;
    this.draw();
  }

  setSettings(settings: ViewSettings): void {
    const modeChanged = settings.mode !== this.settings.mode || settings.light !== this.settings.light;
    this.settings = settings;
    if (modeChanged) this.applyMode();
    this.rebuildOverlays();
    this.draw();
  }

  /** Frames the model from where the camera looks now. */
  frame(): void {
    this.frameAlong(this.camera.getWorldDirection(new Vector3()));
  }

  /** The view that the document opened with: its own camera's, else the model framed from the standard direction. */
  home(): void {
    if (!this.opening || !this.model) {
      this.frameAlong(HOME);
      return;
    }
    this.moveTo(...framingOf(this.opening, samplePositions(this.model.scene), this.camera.aspect));
  }

  async thumbnail(model: DecodedModel, width: number, height: number): Promise<string> {
    const scene = new Scene().add(model.scene);
    const camera = new PerspectiveCamera(FIELD_OF_VIEW, width / height, 0.01, 1000);
    const framing = frame(samplePositions(model.scene), HOME, camera);
    const picture = document.createElement("canvas");
    picture.width = width;
    picture.height = height;
    if (framing) {
      placeCamera(camera, HOME, framing);
      // Drawn twice as large and scaled down, which is smooth without multisampling.
      const ratio = this.renderer.getPixelRatio();
      this.renderer.setPixelRatio(1);
      this.renderer.setSize(2 * width, 2 * height, false);
      this.renderer.render(scene, camera);
      picture.getContext("2d")?.drawImage(this.renderer.domElement, 0, 0, width, height);
      this.renderer.setPixelRatio(ratio);
      this.resize();
      this.render();
    }
    const blob = await new Promise<Blob | null>((resolve) => picture.toBlob(resolve, "image/png"));
    return blob ? URL.createObjectURL(blob) : "";
  }

  dispose(): void {
    cancelAnimationFrame(this.requested);
    this.observer.disconnect();
    this.clear();
    remove(this.grid);
    remove(this.axes);
    this.controls.dispose();
    this.materials.dispose();
    this.wire.dispose();
    this.decoder.dispose();
    this.renderer.dispose();
    this.renderer.domElement.remove();
  }

  private draw(): void {
    if (this.requested) return;
    this.requested = requestAnimationFrame(() => {
      this.requested = 0;
      this.controls.update();
      this.render();
    });
  }

  private render(): void {
    this.renderer.render(this.scene, this.camera);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.container;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, true);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    // Setting the size clears the canvas; drawing at once avoids a blank frame.
    this.render();
  }

  private frameAlong(direction: Vector3): void {
    const framing = this.model && frame(samplePositions(this.model.scene), direction, this.camera);
    if (framing) this.moveTo(direction, framing);
  }

  private moveTo(direction: Vector3, framing: Framing): void {
    this.look(direction, framing);
    this.radius = framing.radius;
    this.rebuildOverlays();
    this.draw();
  }

  private look(direction: Vector3, framing: Framing): void {
    placeCamera(this.camera, direction, framing);
    this.controls.target.copy(framing.target);
    this.controls.minDistance = framing.radius * 0.02;
    this.controls.maxDistance = framing.radius * 60;
    this.controls.update();
  }

  private onKey(event: KeyboardEvent): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    if (!turnByKey(event, offset, this.camera.up)) return;
    event.preventDefault();
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
  }

  private applyMode(): void {
    this.dropWires();
    const { mode, light } = this.settings;
    const colors = COLORS[light ? "light" : "dark"];
    this.wire.color.set(mode === "wire" ? colors.soleWire : colors.wire);
    this.wire.opacity = mode === "wire" ? 0.75 : 0.42;
    for (const mesh of this.model?.meshes ?? []) {
      mesh.material = mode === "normals" ? this.materials.normals : (studioOf(mesh) ?? this.materials.normals);
      mesh.material.visible = mode !== "wire";
      if (mode !== "wire" && mode !== "shaded-wire") continue;
      const lines = new LineSegments(wireGeometry(mesh.geometry), this.wire);
      mesh.add(lines);
      this.wires.push(lines);
    }
  }

  private dropWires(): void {
    for (const lines of this.wires) {
      lines.removeFromParent();
      lines.geometry.dispose();
    }
    this.wires = [];
  }

  private rebuildOverlays(): void {
    remove(this.grid);
    remove(this.axes);
    const colors = COLORS[this.settings.light ? "light" : "dark"];
    const cell = cellSize(this.radius);
    this.grid = this.settings.grid ? makeGrid(cell, colors.grid) : undefined;
    this.axes = this.settings.axes ? makeAxes(2.5 * cell, colors.axes) : undefined;
    if (this.grid) this.overlays.add(this.grid);
    if (this.axes) this.overlays.add(this.axes);
  }
}
