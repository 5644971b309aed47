// Six documents like the built-in examples. The stand-in does not evaluate graphs: geometry.mjs knows each by its id.

const from = (name) => ({ from: name });
const by = (name) => ({ parameter: name });
const number = (label, value, min, max, step, more = {}) => ({
  type: "number",
  default: value,
  min,
  max,
  step,
  label,
  ...more,
});

function example(id, figure, title, description, parameters, nodes) {
  return { id, figure, title, description, graph: { format: 1, meta: { title, description }, parameters, nodes } };
}

const out = (name) => ({ type: "export", inputs: { model: from(name) } });
const skin = (name) => ({ type: "surface", inputs: { shape: from(name), segments: 128 } });

export const examples = [
  example(
    "fig02_circle_family",
    "2",
    "Circle family",
    "One circle boosted by growing amounts sweeps a surface.",
    { reach: number("Reach", 2.2, 0, 4, 0.01), tilt: number("Tilt", 35, 0, 90, 1, { unit: "deg" }) },
    {
      ring: { type: "circle", inputs: { center: [0.6, 0, 0], radius: 0.5 } },
      tau: { type: "point_pair", inputs: { position: [0, 0, 0], direction: [0.3, 0, 1] } },
      k: { type: "range", inputs: { from: 0, to: by("reach"), count: 96 } },
      boosted: { type: "boost", inputs: { shape: from("ring"), generator: from("tau"), amount: from("k") } },
      skin: skin("boosted"),
      out: out("skin"),
    },
  ),
  example(
    "fig04_boosted_ring",
    "4",
    "Boosted ring",
    "A ring boosted along its axis runs on a horn torus.",
    {
      reach: number("Reach", 1.6, 0, 4, 0.01, { description: "How far the ring travels along its orbit." }),
      height: number("Generator height", 1.5, 0.5, 3, 0.01, { unit: "m" }),
      bands: { type: "integer", default: 96, min: 8, max: 256, step: 1, label: "Bands" },
      tint: { type: "color", default: "#e8a53c", label: "Color" },
    },
    {
      ring: { type: "circle", inputs: { radius: 1 } },
      tau: { type: "point_pair", inputs: { position: [0, 0, 1.5], direction: [0, 0, 1] } },
      k: { type: "range", inputs: { from: 0, to: by("reach"), count: by("bands") } },
      boosted: { type: "boost", inputs: { shape: from("ring"), generator: from("tau"), amount: from("k") } },
      skin: skin("boosted"),
      tinted: { type: "color", inputs: { mesh: from("skin"), color: by("tint") } },
      out: out("tinted"),
    },
  ),
  example(
    "fig05_twisted_ring",
    "5",
    "Twisted ring",
    "A tilted ring is boosted while it turns about an axis and slides along it: a relative of Dini's surface.",
    {
      reach: number("Reach", 1.9, 0, 4, 0.01, { description: "How far the ring is boosted towards the generator." }),
      turn: number("Turn", 540, 0, 1080, 1, { unit: "deg", description: "Angle of the whole twist about the axis." }),
      slide: number("Slide", 0.9, -2, 2, 0.01, { unit: "m" }),
      center: { type: "vector", default: [0.45, 0, 0], label: "Ring center" },
      rule: { type: "choice", default: "exact", choices: ["exact", "paper"], label: "Rule" },
      closed: { type: "boolean", default: false, label: "Closed" },
    },
    {
      ring: { type: "circle", inputs: { center: by("center"), normal: [0.35, 0, 1], radius: 1 } },
      tau: { type: "point_pair", inputs: { position: [0, 0, 1.5], direction: [0, 0, 1] } },
      axis: { type: "line", inputs: { direction: [0, 0, 1] } },
      k: { type: "range", inputs: { from: 0, to: by("reach"), count: 192, axis: "k", closed: by("closed") } },
      angle: { type: "range", inputs: { from: 0, to: by("turn"), count: 192, axis: "k" } },
      boosted: {
        type: "boost",
        inputs: { shape: from("ring"), generator: from("tau"), amount: from("k"), rule: by("rule") },
      },
      twisted: {
        type: "twist",
        inputs: { shape: from("boosted"), axis: from("axis"), angle: from("angle"), slide: by("slide") },
      },
      skin: skin("twisted"),
      out: out("skin"),
    },
  ),
  example(
    "fig06_hopf_fibers",
    "6",
    "Hopf fibers",
    "Linked circles, no two of which meet, as tubes.",
    {
      fibers: { type: "integer", default: 18, min: 3, max: 60, step: 1, label: "Fibers" },
      thickness: number("Thickness", 0.045, 0.01, 0.12, 0.005, { unit: "m" }),
    },
    {
      ring: { type: "circle", inputs: { radius: 1 } },
      k: { type: "range", inputs: { from: 0, to: 1, count: by("fibers"), closed: true } },
      fibers: { type: "hopf", inputs: { circle: from("ring"), amount: from("k"), method: "paper" } },
      tubes: { type: "tube", inputs: { shape: from("fibers"), radius: by("thickness") } },
      out: out("tubes"),
    },
  ),
  example(
    "fig11_patch",
    "11",
    "Four-corner patch",
    "A flat patch boosted by a blend of four point pairs, one at each corner.",
    { bend: number("Bend", 0.8, -2, 2, 0.01), lift: number("Lift", 0.6, -1, 1, 0.01) },
    {
      patch: { type: "grid", inputs: { u_vector: [1.2, 0, 0], v_vector: [0, 1.2, 0], count_u: 96, count_v: 96 } },
      a: { type: "point_pair", inputs: { position: [-1, -1, 0], direction: [0, 0, 1] } },
      b: { type: "point_pair", inputs: { position: [1, -1, 0], direction: [0, 0, -1] } },
      c: { type: "point_pair", inputs: { position: [-1, 1, 0], direction: [0, 0, -1] } },
      d: { type: "point_pair", inputs: { position: [1, 1, 0], direction: [0, 0, 1] } },
      blend: {
        type: "interpolate",
        inputs: { a: from("a"), b: from("b"), c: from("c"), d: from("d"), u: from("patch.u"), v: from("patch.v") },
      },
      bent: { type: "boost", inputs: { shape: from("patch.points"), generator: from("blend"), amount: by("bend") } },
      skin: { type: "surface", inputs: { shape: from("bent") } },
      out: out("skin"),
    },
  ),
  example(
    "fig12_warped_sphere",
    "12",
    "Warped sphere",
    "Three point pairs pull at a sphere.",
    { strength: number("Strength", 0.22, 0, 0.6, 0.005), softening: number("Softening", 0.25, 0.05, 2, 0.01) },
    {
      ball: { type: "sphere_mesh", inputs: { radius: 1, segments: 160 } },
      one: { type: "point_pair", inputs: { position: [1.3, 0, 0.3], direction: [0, 0, 1] } },
      two: { type: "point_pair", inputs: { position: [-0.7, 1.1, 0], direction: [1, 0, 0] } },
      three: { type: "point_pair", inputs: { position: [-0.6, -1, 0.4], direction: [0, 1, 0.6] } },
      warped: {
        type: "warp",
        inputs: {
          shape: from("ball"),
          generators: [from("one"), from("two"), from("three")],
          strength: by("strength"),
          softening: by("softening"),
        },
      },
      out: out("warped"),
    },
  ),
];
