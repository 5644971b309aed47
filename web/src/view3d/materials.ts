// Shading that looks like a lit studio and costs one texture read, so that it also runs without a GPU.

import {
  Color,
  DataTexture,
  DoubleSide,
  LinearFilter,
  LineBasicMaterial,
  type LineBasicMaterialParameters,
  type Material,
  MeshMatcapMaterial,
  MeshNormalMaterial,
  MeshStandardMaterial,
  type Plane,
  PointsMaterial,
  RGBAFormat,
  SRGBColorSpace,
  type Texture,
  UnsignedByteType,
  Vector3,
  Vector4,
  type WebGLProgramParametersWithUniforms,
} from "three";

const MATCAP_SIZE = 128;
/** Less than the whole: the lamp adds to it, and white shall not glare. */
const ROOM_STRENGTH = 0.6;
const DEFAULT_COLOR = new Color("#7f9df0");
/** The same where light is computed: a neutral one shows it best. */
const DEFAULT_PHYSICAL_COLOR = new Color("#c9ced6");

/** Pushes surfaces back a little, so that lines drawn on them are whole. */
const BEHIND_LINES = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };

interface Light {
  direction: Vector3;
  strength: number;
  wrap: number;
}

// Seen from the camera: x right, y up, z towards the eye.
const KEY: Light = { direction: new Vector3(-0.45, 0.75, 0.65).normalize(), strength: 0.74, wrap: 0.12 };
const FILL: Light = { direction: new Vector3(0.8, -0.1, 0.5).normalize(), strength: 0.13, wrap: 0.3 };
const AMBIENT = 0.13;
const RIM = 0.3;
const SHININESS = 110;
const SHINE = 0.28;

/** Light on a ball: RGB is the diffuse light, alpha the highlight, which the shader adds uncolored. */
function studioMatcap(): DataTexture {
  const data = new Uint8Array(4 * MATCAP_SIZE * MATCAP_SIZE);
  const normal = new Vector3();
  const half = KEY.direction
    .clone()
    .add(new Vector3(0, 0, 1))
    .normalize();
  for (let row = 0; row < MATCAP_SIZE; row++) {
    for (let column = 0; column < MATCAP_SIZE; column++) {
      const x = (2 * (column + 0.5)) / MATCAP_SIZE - 1;
      const y = (2 * (row + 0.5)) / MATCAP_SIZE - 1;
      const reach = Math.min(1, Math.hypot(x, y));
      normal.set(x, y, Math.sqrt(1 - reach * reach)).normalize();
      const edge = (1 - normal.z) ** 3;
      const light = AMBIENT + lightOf(KEY, normal) + lightOf(FILL, normal) + RIM * edge * Math.max(0, normal.y + 0.5);
      const at = 4 * (row * MATCAP_SIZE + column);
      // Slightly warm in the light, slightly cool in the shade.
      data[at] = byte(light * (0.97 + 0.04 * light));
      data[at + 1] = byte(light * 0.985);
      data[at + 2] = byte(light * (1.06 - 0.06 * light));
      data[at + 3] = Math.round(255 * SHINE * Math.max(0, normal.dot(half)) ** SHININESS);
    }
  }
  const texture = new DataTexture(data, MATCAP_SIZE, MATCAP_SIZE, RGBAFormat, UnsignedByteType);
  texture.colorSpace = SRGBColorSpace;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

function lightOf(light: Light, normal: Vector3): number {
  return light.strength * Math.max(0, (normal.dot(light.direction) + light.wrap) / (1 + light.wrap));
}

/** Linear light to an sRGB byte. */
function byte(linear: number): number {
  const value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
  return Math.round(255 * Math.min(1, Math.max(0, value)));
}

const MOST_KEPT = 512;
/** In pixels. */
const POINT_SIZE = 5;

/** What a model says about the look of one of its parts. */
export interface Style {
  /** Linear red, green, blue and alpha. */
  color: readonly [number, number, number, number];
  translucent: boolean;
  vertexColors: boolean;
  /** How the surface takes light, where that is computed. */
  metalness: number;
  roughness: number;
}

/**
 * Makes and shares the materials of one viewer. They outlive the models: a shader whose last material goes is compiled
 * again for the next model, which takes longer than drawing it.
 */
export class Materials {
  readonly normals = new MeshNormalMaterial({ side: DoubleSide, ...BEHIND_LINES });
  /** Surfaces in the colors of their attribute "paint". */
  readonly painted: Material;
  /** The planes that every surface is cut by; the same list for ever, so that filling it is enough. */
  readonly planes: Plane[] = [];
  private readonly matcap = studioMatcap();
  private readonly kept = new Map<string, Material>();
  private readonly back = { value: new Vector4(0, 0, 0, 0) };
  private readonly inward = { value: false };

  /** With an `environment` to mirror, surfaces are lit as their materials say; without, by a drawing of light. */
  constructor(private readonly environment: Texture | null = null) {
    this.normals.clippingPlanes = this.planes;
    this.painted = this.makeStudio(
      { color: [1, 1, 1, 1], translucent: false, vertexColors: false, metalness: 0, roughness: 1 },
      new Color(1, 1, 1),
      true,
    );
    this.painted.clippingPlanes = this.planes;
  }

  /** The studio look of a model's own color, opacity and vertex colors. White stands for no color of its own. */
  studio(style: Style): Material {
    const [red, green, blue] = style.color;
    const isPlain = red === 1 && green === 1 && blue === 1 && !style.vertexColors;
    const usual = this.environment ? DEFAULT_PHYSICAL_COLOR : DEFAULT_COLOR;
    const color = isPlain ? usual : new Color(red, green, blue);
    return this.shared("faces", style, () =>
      this.environment ? this.makePhysical(style, color, this.environment) : this.makeStudio(style, color),
    );
  }

  points(style: Style): Material {
    return this.shared("points", style, () => {
      return new PointsMaterial({ ...plain(style), size: POINT_SIZE, sizeAttenuation: false });
    });
  }

  lines(style: Style): Material {
    return this.shared("lines", style, () => new LineBasicMaterial(plain(style)));
  }

  /** Whether fronts are inside: a section shows the other side flat then. */
  setInward(inward: boolean): void {
    this.inward.value = inward;
  }

  /** Draws the insides of surfaces flat in a color, as long as a section is shown; null as their own. */
  setFlatBacks(color: Color | null): void {
    if (color) this.back.value.set(color.r, color.g, color.b, 1);
    else this.back.value.w = 0;
  }

  /** Surfaces are compiled anew when the number of planes changes. */
  setPlanes(planes: readonly Plane[]): void {
    this.planes.splice(0, this.planes.length, ...planes);
  }

  dispose(): void {
    for (const material of this.kept.values()) material.dispose();
    this.matcap.dispose();
    this.normals.dispose();
    this.painted.dispose();
  }

  private shared(kind: string, style: Style, make: () => Material): Material {
    const finish = this.environment ? `${style.metalness} ${style.roughness}` : "";
    const key = `${kind} ${style.color.join()} ${style.translucent} ${style.vertexColors} ${finish}`;
    const found = this.kept.get(key);
    if (found) return found;
    if (this.kept.size >= MOST_KEPT) {
      for (const old of this.kept.values()) old.dispose();
      this.kept.clear();
    }
    const material = make();
    material.clippingPlanes = this.planes;
    this.kept.set(key, material);
    return material;
  }

  private makePhysical(style: Style, color: Color, environment: Texture): MeshStandardMaterial {
    const material = new MeshStandardMaterial({
      ...{ color, envMap: environment, metalness: style.metalness, roughness: style.roughness },
      envMapIntensity: ROOM_STRENGTH,
      ...{ vertexColors: style.vertexColors, side: DoubleSide, opacity: style.color[3] },
      ...{ transparent: style.translucent, depthWrite: !style.translucent, ...BEHIND_LINES },
    });
    material.onBeforeCompile = (shader) => {
      shader.uniforms["flatBack"] = this.back;
      shader.uniforms["inward"] = this.inward;
      shader.fragmentShader = shader.fragmentShader
        .replace("#define STANDARD", "#define STANDARD\nuniform vec4 flatBack; uniform bool inward;")
        .replace(
          "#include <color_fragment>",
          `#include <color_fragment>
          if (!gl_FrontFacing) diffuseColor.rgb *= 0.86;`,
        )
        .replace(
          "#include <opaque_fragment>",
          `#include <opaque_fragment>
          if (gl_FrontFacing == inward) gl_FragColor.rgb = mix(gl_FragColor.rgb, flatBack.rgb, 0.85 * flatBack.a);`,
        );
    };
    return material;
  }

  private makeStudio(style: Style, color: Color, isPainted = false): MeshMatcapMaterial {
    const material = new MeshMatcapMaterial({
      matcap: this.matcap,
      color,
      vertexColors: style.vertexColors,
      side: DoubleSide,
      opacity: style.color[3],
      transparent: style.translucent,
      depthWrite: !style.translucent,
      ...BEHIND_LINES,
    });
    // The renderer keeps programs by the text of the function below, which is the same for both.
    material.customProgramCacheKey = () => String(isPainted);
    material.onBeforeCompile = (shader) => {
      shader.uniforms["flatBack"] = this.back;
      shader.uniforms["inward"] = this.inward;
      if (isPainted) paint(shader);
      shader.fragmentShader = shader.fragmentShader
        .replace("#define MATCAP", "#define MATCAP\nuniform vec4 flatBack; uniform bool inward;")
        .replace(
          "#include <color_fragment>",
          // The back of a surface is deeper in color and a little darker, so that the two sides are told apart. It is
          // never dull: which side of an open surface is the front is chance. At the outline a triangle may face away
          // while its smooth normal does not; taking it for the back would draw dots of the other shade.
          `#include <color_fragment>
          bool isBack = !gl_FrontFacing && dot(normalize(vNormal), normalize(vViewPosition)) < 0.0;
          if (isBack) diffuseColor.rgb *= ${isPainted ? "0.9" : "0.78 * mix(vec3(1.0), diffuseColor.rgb + 0.25, 0.65)"};`,
        )
        .replace("#include <normal_fragment_begin>", "vec3 normal = isBack ? -normalize(vNormal) : normalize(vNormal);")
        .replace(
          "vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;",
          `vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb * 1.2 + vec3(matcapColor.a);
          if (isBack != inward) outgoingLight = mix(outgoingLight, flatBack.rgb, 0.85 * flatBack.a);`,
        );
    };
    return material;
  }
}

/** Takes the color from the attribute "paint". */
function paint(shader: WebGLProgramParametersWithUniforms): void {
  shader.vertexShader = shader.vertexShader
    .replace("#define MATCAP", "#define MATCAP\nattribute vec3 paint; varying vec3 vPaint;")
    .replace("#include <begin_vertex>", "#include <begin_vertex>\nvPaint = paint;");
  shader.fragmentShader = shader.fragmentShader
    .replace("#define MATCAP", "#define MATCAP\nvarying vec3 vPaint;")
    .replace("#include <color_fragment>", "#include <color_fragment>\ndiffuseColor.rgb *= vPaint;");
}

function plain({ color, translucent, vertexColors }: Style): LineBasicMaterialParameters {
  return { color: new Color(color[0], color[1], color[2]), opacity: color[3], transparent: translucent, vertexColors };
}
