// Darkening where surfaces are near to each other, which light from all around reaches less. Only where a graphics
// processor draws: a drawing of the depth of the model, a sum over what stands around each pixel, and a smoothed product
// with the picture.

import {
  type Camera,
  CustomBlending,
  DepthTexture,
  DoubleSide,
  GLSL3,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  NearestFilter,
  NoBlending,
  OneFactor,
  OrthographicCamera,
  type Plane,
  PlaneGeometry,
  RawShaderMaterial,
  Scene,
  type ShaderMaterialParameters,
  SrcColorFactor,
  Vector2,
  type WebGLRenderer,
  WebGLRenderTarget,
  ZeroFactor,
} from "three";

/** Of the model's diameter: how far what stands around counts. */
const REACH = 0.02;
const STRENGTH = 0.6;
/** Meshes on it take part; what is seen through, and what is no surface of the model, does not. */
export const OCCLUDING_LAYER = 1;

const CORNERS = `
in vec3 position;
in vec2 uv;
out vec2 place;
void main() { place = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }`;

const SHADE = `
precision highp float;
uniform sampler2D depths;
uniform mat4 projection;
uniform mat4 unprojection;
uniform vec2 size;
uniform float reach;
in vec2 place;
out vec4 shade;
const int SAMPLES = 20;
const float BIAS = 0.12;
vec3 positionAt(vec2 uv) {
  vec4 seen = unprojection * (vec4(uv, texture(depths, uv).r, 1.0) * 2.0 - 1.0);
  return seen.xyz / seen.w;
}
void main() {
  shade = vec4(1.0);
  if (texture(depths, place).r >= 1.0) return;
  vec3 here = positionAt(place);
  vec2 pixel = 1.0 / size;
  // Of both neighbors the one nearer in depth: at an edge the other lies on another surface.
  vec3 right = positionAt(place + vec2(pixel.x, 0.0)) - here, left = here - positionAt(place - vec2(pixel.x, 0.0));
  vec3 up = positionAt(place + vec2(0.0, pixel.y)) - here, down = here - positionAt(place - vec2(0.0, pixel.y));
  vec3 across = abs(right.z) < abs(left.z) ? right : left;
  vec3 along = abs(up.z) < abs(down.z) ? up : down;
  vec3 normal = normalize(cross(across, along));
  vec4 clip = projection * vec4(here, 1.0);
  vec2 radius = 0.5 * reach * vec2(projection[0][0], projection[1][1]) / clip.w;
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  float sum = 0.0;
  for (int at = 0; at < SAMPLES; at++) {
    float share = (float(at) + 0.5) / float(SAMPLES);
    float angle = turn + 2.3999632 * float(at);
    vec2 uv = place + sqrt(share) * radius * vec2(cos(angle), sin(angle));
    if (texture(depths, uv).r >= 1.0) continue;
    vec3 way = positionAt(uv) - here;
    float distance = length(way);
    if (distance <= 0.0) continue;
    float near = max(0.0, 1.0 - (distance * distance) / (reach * reach));
    sum += near * max(0.0, dot(normal, way) / distance - BIAS);
  }
  shade = vec4(vec3(clamp(1.0 - 2.0 * sum / float(SAMPLES), 0.0, 1.0)), 1.0);
}`;

const SMOOTH = `
precision highp float;
uniform sampler2D shades;
uniform vec2 size;
uniform float strength;
in vec2 place;
out vec4 color;
void main() {
  float sum = 0.0;
  for (int x = -2; x < 2; x++) {
    for (int y = -2; y < 2; y++) sum += texture(shades, place + (vec2(x, y) + 0.5) / size).r;
  }
  color = vec4(vec3(1.0 - strength * (1.0 - sum / 16.0)), 1.0);
}`;

export class AmbientOcclusion {
  private readonly depths = new WebGLRenderTarget(1, 1, { depthTexture: new DepthTexture(1, 1) });
  private readonly shades = new WebGLRenderTarget(1, 1, { minFilter: NearestFilter, magFilter: NearestFilter });
  private readonly flat = new MeshBasicMaterial({ side: DoubleSide, colorWrite: false });
  private readonly size = new Vector2();
  private readonly unprojection = new Matrix4();
  private readonly shade = pass(SHADE, {
    blending: NoBlending,
    uniforms: {
      depths: { value: this.depths.depthTexture },
      projection: { value: new Matrix4() },
      unprojection: { value: this.unprojection },
      size: { value: this.size },
      reach: { value: 1 },
    },
  });
  private readonly smooth = pass(SMOOTH, {
    transparent: true,
    blending: CustomBlending,
    blendSrc: ZeroFactor,
    blendDst: SrcColorFactor,
    // How much of the page shows through stays as it is.
    blendSrcAlpha: ZeroFactor,
    blendDstAlpha: OneFactor,
    uniforms: {
      shades: { value: this.shades.texture },
      size: { value: this.size },
      strength: { value: STRENGTH },
    },
  });
  private readonly screen = new Mesh(new PlaneGeometry(2, 2), this.shade);
  private readonly stage = new Scene().add(this.screen);
  private readonly eye = new OrthographicCamera(-1, 1, 1, -1, 0, 1);

  /** `planes` cut what is drawn. */
  constructor(planes: Plane[]) {
    this.flat.clippingPlanes = planes;
    this.screen.frustumCulled = false;
  }

  /** Darkens what was just drawn of a scene, for a model of this radius. */
  apply(renderer: WebGLRenderer, scene: Scene, camera: Camera, radius: number): void {
    const { width, height } = renderer.getDrawingBufferSize(this.size);
    if (this.depths.width !== width || this.depths.height !== height) {
      this.depths.setSize(width, height);
      this.shades.setSize(width, height);
    }
    const { layers } = camera;
    const { mask } = layers;
    const { overrideMaterial } = scene;
    layers.set(OCCLUDING_LAYER);
    scene.overrideMaterial = this.flat;
    renderer.setRenderTarget(this.depths);
    renderer.render(scene, camera);
    layers.mask = mask;
    scene.overrideMaterial = overrideMaterial;
    const { uniforms } = this.shade;
    uniforms["projection"] = { value: camera.projectionMatrix };
    uniforms["reach"] = { value: 2 * REACH * radius };
    this.unprojection.copy(camera.projectionMatrixInverse);
    this.screen.material = this.shade;
    renderer.setRenderTarget(this.shades);
    renderer.render(this.stage, this.eye);
    renderer.setRenderTarget(null);
    this.screen.material = this.smooth;
    renderer.autoClear = false;
    renderer.render(this.stage, this.eye);
    renderer.autoClear = true;
  }

  dispose(): void {
    this.depths.depthTexture?.dispose();
    this.depths.dispose();
    this.shades.dispose();
    this.flat.dispose();
    this.shade.dispose();
    this.smooth.dispose();
    this.screen.geometry.dispose();
  }
}

function pass(fragmentShader: string, parameters: ShaderMaterialParameters): RawShaderMaterial {
  return new RawShaderMaterial({
    ...{ glslVersion: GLSL3, vertexShader: CORNERS, fragmentShader, depthTest: false, depthWrite: false },
    ...parameters,
  });
}
