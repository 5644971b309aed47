// The studio around a model where there is a graphics processor: light from a room, one lamp, and the shadow below.

import {
  DirectionalLight,
  Group,
  Mesh,
  NeutralToneMapping,
  PCFShadowMap,
  PlaneGeometry,
  PMREMGenerator,
  ShadowMaterial,
  type Texture,
  Vector3,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from "three";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";

/** From above, a little from the left and the front. */
const LAMP = new Vector3(-0.35, 1, 0.3).normalize();
const LAMP_STRENGTH = 1.1;
const ROOM_BLUR = 0.04;
const SHADOW = 0.35;
const SHADOW_PIXELS = 1024;
const SHADOW_BLUR = 8;
/** Of the model's radius: how far the floor goes, and how far it lies below the lowest point. */
const FLOOR = 3;
const BELOW = 0.002;

export class StudioLight {
  readonly group = new Group();
  private readonly target: WebGLRenderTarget;
  private readonly lamp = new DirectionalLight(0xffffff, LAMP_STRENGTH);
  private readonly floor = new Mesh(
    new PlaneGeometry(1, 1),
    new ShadowMaterial({ opacity: SHADOW, depthWrite: false }),
  );

  constructor(renderer: WebGLRenderer) {
    // Keeps the colors of what is not glaring as they are.
    renderer.toneMapping = NeutralToneMapping;
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = PCFShadowMap;
    const generator = new PMREMGenerator(renderer);
    const room = new RoomEnvironment();
    this.target = generator.fromScene(room, ROOM_BLUR);
    room.dispose();
    generator.dispose();
    const { shadow } = this.lamp;
    this.lamp.castShadow = true;
    shadow.mapSize.set(SHADOW_PIXELS, SHADOW_PIXELS);
    shadow.radius = SHADOW_BLUR;
    this.floor.receiveShadow = true;
    this.floor.rotation.x = -Math.PI / 2;
    this.group.add(this.lamp, this.lamp.target, this.floor);
  }

  /** What surfaces mirror. */
  get environment(): Texture {
    return this.target.texture;
  }

  /** Puts lamp and floor where a model with these points stands. */
  place(points: readonly Vector3[]): void {
    this.group.visible = points.length > 0;
    if (points.length === 0) return;
    const [low, high] = [new Vector3(Infinity, Infinity, Infinity), new Vector3(-Infinity, -Infinity, -Infinity)];
    for (const point of points) {
      low.min(point);
      high.max(point);
    }
    const center = low.clone().add(high).divideScalar(2);
    const radius = Math.max(1e-6, high.distanceTo(low) / 2);
    this.floor.position.set(center.x, low.y - BELOW * radius, center.z);
    this.floor.scale.setScalar(2 * FLOOR * radius);
    this.lamp.target.position.copy(center);
    this.lamp.position.copy(center).addScaledVector(LAMP, 3 * radius);
    const { camera } = this.lamp.shadow;
    [camera.left, camera.right, camera.bottom, camera.top] = [-1.6, 1.6, -1.6, 1.6].map((one) => one * radius) as [
      number,
      number,
      number,
      number,
    ];
    [camera.near, camera.far] = [0.5 * radius, 8 * radius];
    camera.updateProjectionMatrix();
    this.lamp.shadow.normalBias = 0.01 * radius;
  }

  dispose(): void {
    this.target.dispose();
    this.lamp.dispose();
    this.floor.geometry.dispose();
    this.floor.material.dispose();
  }
}
