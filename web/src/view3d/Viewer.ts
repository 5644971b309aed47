// The 3D view. Draws only when something changed; React never runs while it does.

import { Scene, Vector3, type WebGLRenderer } from "three";
import type { CameraPlace } from "../model/document";
import type { ControlInfo } from "../session/state";
import { AmbientOcclusion } from "./ambient_occlusion";
import { makeRenderer } from "./canvas";
import { ControlGeometry } from "./control_geometry";
import { ControlMaterials } from "./control_materials";
import { type DecodedModel, Decoder } from "./decode";
import { inGraph, tidy } from "./drag";
import { type Framing, frame, framingOf, samplePositions } from "./framing";
import type { Gizmo } from "./gizmo_values";
import { type GizmoHost, GizmoLayer } from "./gizmos";
import { Ground } from "./ground";
import { HandleLayer } from "./handles";
import { HomeView } from "./home_view";
import { InView, MOST_SEEN, type OutOfView } from "./in_view";
import { Materials } from "./materials";
import { ModelLook } from "./model_look";
import { pointsInward } from "./orientation";
import { cellSize } from "./overlays";
import { onGround, pictureOf } from "./pictures";
import { Redraw } from "./redraw";
import { CameraRig, directionOf, type StandardView } from "./rig";
import { type Section, SectionPlane } from "./section";
import { ShownModels } from "./shown_models";
import { isSoftwareRendering } from "./software";
import type { ComparedHow } from "./split_view";
import { StudioLight } from "./studio_light";
import { drawingSize } from "./thick_lines";
import { PLAIN, type ViewerHost, type ViewSettings } from "./viewer_settings";

const HOME = new Vector3(-0.62, -0.5, -0.92);

export class Viewer {
  readonly isSoftware: boolean;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly rig: CameraRig;
  /** Light that is computed, where there is a graphics processor for it. */
  private readonly studio: StudioLight | undefined;
  private readonly occlusion: AmbientOcclusion | undefined;
  private readonly materials: Materials;
  private readonly controlMaterials = new ControlMaterials();
  private readonly decoder: Decoder;
  private readonly look: ModelLook;
  private readonly gizmos: GizmoLayer;
  private readonly handles: HandleLayer;
  private readonly section: SectionPlane;
  private readonly ground = new Ground();
  private readonly observer: ResizeObserver;
  private readonly inView = new InView();
  private outOfView: OutOfView = "";
  private readonly redraw: Redraw;
  private readonly models: ShownModels;
  private control: ControlGeometry | undefined;
  private readonly homeView: HomeView;
  private center = new Vector3();
  private radius = 1;
  private frames = 0;
  private settings = PLAIN;

  /**
   * Draws into a canvas of its own inside `container`; `smooth` also without a GPU, where it takes long. Throws if
   * WebGL 2 is not available.
   */
  constructor(
    private readonly container: HTMLElement,
    label: string,
    smooth: boolean,
    private readonly host: ViewerHost,
  ) {
    this.isSoftware = isSoftwareRendering();
    this.renderer = makeRenderer(container, label, smooth ? "fine" : this.isSoftware ? "plain" : "usual");
    this.studio = this.isSoftware || smooth ? undefined : new StudioLight(this.renderer);
    this.materials = new Materials(this.studio?.environment);
    this.occlusion = this.studio && new AmbientOcclusion(this.materials.planes);
    this.decoder = new Decoder(this.materials);
    this.look = new ModelLook(this.materials);
    this.models = new ShownModels(this.scene, this.look, host);
    const canvas = this.renderer.domElement;
    this.redraw = new Redraw(this.renderer, this.isSoftware && !smooth, (fine) => this.render(fine));
    const isDamped = !this.isSoftware && !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.rig = new CameraRig(canvas, isDamped, () => this.draw());
    this.homeView = new HomeView(this.rig);
    canvas.addEventListener("keydown", (event) => this.rig.onKey(event));
    this.section = new SectionPlane(this.materials, (section) => host.section(section));
    this.gizmos = new GizmoLayer(this.gizmoHost());
    this.handles = new HandleLayer(container, {
      canvas,
      ray: (x, y) => this.rig.ray((2 * x) / canvas.clientWidth - 1, 1 - (2 * y) / canvas.clientHeight),
      project: (place) => this.project(place),
    });
    this.scene.add(this.ground.group, this.section.group, this.gizmos.group);
    if (this.studio) this.scene.add(this.studio.group);
    this.rig.look(HOME, { target: new Vector3(), distance: 8, radius: 1 });
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(container);
    this.resize();
    this.ground.set(this.radius, this.settings);
  }

  decode(bytes: Uint8Array<ArrayBuffer>): Promise<DecodedModel> {
    return this.decoder.decode(bytes);
  }

  /** Replaces the shown model. */
  show(model: DecodedModel): void {
    this.models.show(model);
    const points = samplePositions(model.scene, MOST_SEEN);
    this.inView.setModel(points);
    this.studio?.place(points);
    this.materials.setInward(pointsInward(model.meshes.map((mesh) => mesh.geometry)));
    this.models.dress(this.settings);
    this.draw();
  }

  /** Shows the first model of a document, and puts the camera where the document says. */
  open(model: DecodedModel, camera: CameraPlace | null, place: CameraPlace | null = null): void {
    this.show(model);
    this.homeView.opening = camera;
    this.home();
    // It was found by hand in a view of this shape, so it is not stepped back from.
    if (place) this.moveTo(...framingOf(place, samplePositions(model.scene), Infinity));
  }

  get camera(): CameraPlace | null {
    return this.homeView.camera;
  }

  get pictureCamera(): CameraPlace | null {
    return this.homeView.pictureCamera;
  }

  /** Replaces the control geometry over the model. */
  showControl(model: DecodedModel | null, info: ControlInfo): void {
    this.control?.dispose();
    this.control = model ? new ControlGeometry(model, info, this.controlMaterials) : undefined;
    if (this.control) {
      this.control.group.visible = this.settings.control;
      this.scene.add(this.control.group);
    }
    this.draw();
  }

  /** Shows a model in the colors of its motion in place of the shown one; null brings that back. */
  showSensitivity(model: DecodedModel | null): void {
    this.models.showMotion(model);
    this.renderer.domElement.dataset["sensitivity"] = String(model !== null);
    this.draw();
  }

  showGizmos(gizmos: readonly Gizmo[]): void {
    this.gizmos.set(this.settings.control ? gizmos : []);
    this.setHandles();
    this.draw();
  }

  /** An evaluation is under way: the next picture is near. */
  setBusy(busy: boolean): void {
    this.redraw.setBusy(busy);
  }

  compare(other: DecodedModel | null, how: ComparedHow): void {
    this.models.compare(other);
    this.compareHow(how);
  }

  compareHow(how: ComparedHow): void {
    this.models.compareHow(how);
    this.models.dress(this.settings);
    this.setHandles();
    this.resize();
    this.placeForSplit();
    this.draw();
  }

  clear(): void {
    this.models.clear();
    // Where this document was seen from is no place for the next one.
    this.models.split.wholePlace = undefined;
    if (this.models.split.other) this.compare(null, "beside");
    this.control?.dispose();
    this.control = undefined;
    this.draw();
  }

  setSettings(settings: ViewSettings): void {
    const before = this.settings;
    this.settings = settings;
    this.rig.projection = settings.orthographic ? "orthographic" : "perspective";
    const changed = (...names: (keyof ViewSettings)[]): boolean =>
      names.some((name) => settings[name] !== before[name]);
    if (changed("mode", "light", "curvatureKind")) this.models.dress(settings);
    if (changed("light", "grid", "axes")) this.ground.set(this.radius, this.settings);
    if (changed("light", "section")) this.placeSection();
    if (this.control) this.control.group.visible = settings.control;
    if (changed("light")) this.controlMaterials.setLight(settings.light);
    if (!settings.control) this.gizmos.set([]);
    this.setHandles();
    this.draw();
  }

  /** A section through the middle that opens the model towards the eye. */
  sectionTowardsEye(): Section {
    const [x, y] = inGraph(this.rig.direction);
    const axis = Math.abs(x) > Math.abs(y) ? "x" : "y";
    const middle = inGraph(this.center)[axis === "x" ? 0 : 1];
    return { axis, offset: tidy(middle, this.radius / 10), flipped: (axis === "x" ? x : y) > 0 };
  }

  /** The range of a section along its axis. */
  get sectionReach(): { minimum: number; maximum: number } {
    return this.section.reach;
  }

  /** Brings the whole model into view, from where the camera looks now. */
  frameModel(): void {
    this.frameAlong(this.rig.direction);
  }

  /** Frames the control geometry of what is selected, else the model, from where the camera looks now. */
  frame(): void {
    const points = this.settings.control && this.control ? samplePositions(this.control.source) : [];
    const framing = frame(points, this.rig.direction, this.rig.perspective);
    if (!framing) {
      this.frameAlong(this.rig.direction);
      return;
    }
    const radius = Math.max(framing.radius, this.radius / 50);
    this.rig.look(this.rig.direction, { ...framing, radius });
    this.ground.set(radius, this.settings);
    this.draw();
  }

  standardView(view: StandardView): void {
    this.frameAlong(directionOf(view));
  }

  /** The view that the document opened with: its own camera's, else the model framed from the standard direction. */
  home(): void {
    const { opening } = this.homeView;
    const { model } = this.models;
    if (!opening || !model) this.frameAlong(HOME);
    else this.moveTo(...framingOf(opening, samplePositions(model.scene), this.rig.perspective.aspect));
    this.homeView.arrive();
  }

  /** From now on Home leads to where the camera stands now. Answers that place. */
  keepView(): CameraPlace {
    return this.homeView.keep();
  }

  thumbnail(model: DecodedModel, width: number, height: number, camera: CameraPlace | null): Promise<string> {
    const picture = pictureOf(this.renderer, model, camera ?? HOME, width, height);
    this.resize();
    return picture;
  }

  /** The picture as it is now, on its ground. */
  still(): HTMLCanvasElement {
    const style = getComputedStyle(this.container);
    const ground = [
      style.getPropertyValue("--view-top").trim(),
      style.getPropertyValue("--view-bottom").trim(),
    ] as const;
    // Drawn and read in the same task: the drawing is gone with the next frame.
    this.render(true);
    return onGround(this.renderer.domElement, ground);
  }

  dispose(): void {
    this.redraw.stop();
    this.observer.disconnect();
    this.clear();
    this.ground.clear();
    this.handles.dispose();
    this.gizmos.dispose();
    this.section.dispose();
    this.look.dispose();
    this.rig.dispose();
    this.materials.dispose();
    this.studio?.dispose();
    this.occlusion?.dispose();
    this.controlMaterials.dispose();
    this.decoder.dispose();
    this.renderer.dispose();
    this.renderer.domElement.remove();
  }

  private gizmoHost(): GizmoHost {
    const { host, rig } = this;
    return {
      direction: () => rig.direction,
      right: () => new Vector3(1, 0, 0).applyQuaternion(rig.perspective.quaternion),
      cell: () => cellSize(this.radius),
      pixelSize: (place) => rig.pixelSize(place, this.container.clientHeight),
      write: (gizmo, value, gesture) => host.write(gizmo, value, gesture),
      end: (gizmo, gesture, cancelled) => host.end(gizmo, gesture, cancelled),
    };
  }

  private setHandles(): void {
    // In half the view they would stand in the wrong place.
    if (this.models.split.isSplit) this.handles.set([]);
    else this.handles.set([...(this.settings.section ? [this.section.handle] : []), ...this.gizmos.handles]);
  }

  private placeSection(): void {
    this.section.set(this.settings.section, this.center, this.radius, this.settings.light);
  }

  private draw(): void {
    this.redraw.draw();
  }

  private render(fine = false): void {
    this.rig.update();
    this.gizmos.update();
    const { clientWidth, clientHeight } = this.container;
    this.redraw.begin(fine, clientWidth, clientHeight);
    this.models.render(this.renderer, this.rig.camera, clientWidth, clientHeight);
    const occluded = this.occlusion !== undefined && this.models.isPlain(this.settings);
    if (occluded) this.occlusion?.apply(this.renderer, this.scene, this.rig.camera, this.radius);
    this.handles.update();
    this.tellInView();
    // What tests watch: that nothing is drawn for nothing, that nothing is kept for nothing, and from where it is seen.
    const { geometries, textures } = this.renderer.info.memory;
    const eye = this.rig.perspective.position.toArray().map((value) => value.toPrecision(5));
    Object.assign(this.renderer.domElement.dataset, { frames: ++this.frames, geometries, textures, eye, occluded });
    this.redraw.drawn(fine);
  }

  /** Half a view shows less: the model is framed in it, and seen from where it was when the view is whole again. */
  private placeForSplit(): void {
    const { rig } = this;
    const { split, model } = this.models;
    if (split.isSplit && !split.wholePlace) {
      split.wholePlace = { position: inGraph(rig.perspective.position), target: inGraph(rig.target) };
      this.frameModel();
    } else if (!split.isSplit && split.wholePlace && model) {
      this.moveTo(...framingOf(split.wholePlace, samplePositions(model.scene), Infinity));
      split.wholePlace = undefined;
    }
  }

  private tellInView(): void {
    const how = this.models.model ? this.inView.look(this.rig.camera) : "";
    if (how === this.outOfView) return;
    this.outOfView = how;
    this.host.outOfView(how);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.container;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, true);
    drawingSize.value.set(clientWidth, clientHeight);
    this.rig.resize(clientWidth / (this.models.split.isSplit ? 2 : 1) / clientHeight);
    // Setting the size clears the canvas; drawing at once avoids a blank frame.
    this.render();
  }

  private project(place: Vector3): { x: number; y: number } | undefined {
    const { clientWidth, clientHeight } = this.container;
    const { x, y, z } = place.clone().project(this.rig.camera);
    return z > 1 ? undefined : { x: ((x + 1) * clientWidth) / 2, y: ((1 - y) * clientHeight) / 2 };
  }

  private frameAlong(direction: Vector3): void {
    const { model } = this.models;
    const framing = model && frame(samplePositions(model.scene), direction, this.rig.perspective);
    if (framing) this.moveTo(direction, framing);
  }

  private moveTo(direction: Vector3, framing: Framing): void {
    this.rig.look(direction, framing);
    this.inView.framed();
    this.radius = framing.radius;
    this.center.copy(framing.target);
    this.ground.set(this.radius, this.settings);
    this.placeSection();
    this.draw();
  }
}
