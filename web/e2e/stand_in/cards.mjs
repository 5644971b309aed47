// A catalogue like the server's, in a compact notation: "name: types = default unit".
// Only for developing and testing the page without the server; it is never shipped.

const TYPES = [
  ["number", "number", "#C1D7D0", "dot"],
  ["integer", "number", "#C1D7D0", "dot"],
  ["boolean", "number", "#C1D7D0", "dot"],
  ["choice", "number", "#C1D7D0", "dot"],
  ["text", "number", "#C1D7D0", "dot"],
  ["color", "number", "#C1D7D0", "dot"],
  ["vector", "vector", "#2FC2FF", "circle"],
  ["point", "point", "#F2FF71", "circle"],
  ["circle", "round", "#F3AF20", "ring"],
  ["sphere", "round", "#F3AF20", "circle"],
  ["generator", "versor", "#9F68B4", "diamond"],
  ["mesh", "mesh", "#7F61FF", "square"],
  ["asset", "mesh", "#7F61FF", "outline"],
];

const ANY = "point|circle|generator|mesh";

const CARDS = [
  [
    "circle",
    "Circle",
    "elements",
    "A circle from its center, normal and radius.",
    "",
    "center:point=[0,0,0] normal:vector=[0,0,1] radius:number=1:m",
    "circle:circle",
  ],
  [
    "line",
    "Line",
    "elements",
    "A line through a point along a direction.",
    "",
    "point:point=[0,0,0] direction:vector=[0,0,1]",
    "circle:circle",
  ],
  [
    "point_pair",
    "Point pair",
    "elements",
    "A position with a direction: the generator of a boost.",
    "Boosted Surfaces, eq. 1",
    "position:point=[0,0,0] direction:vector=[0,0,1] split:number=0",
    "generator:generator",
  ],
  [
    "range",
    "Range",
    "numbers",
    "Evenly spaced numbers along an axis.",
    "",
    "from:number=0 to:number=1 count:integer=16 closed:boolean=false axis:text",
    "values:number",
  ],
  [
    "grid",
    "Grid",
    "sampling",
    "Points of a flat patch over two axes.",
    "",
    "center:point=[0,0,0] u_vector:vector=[1,0,0] v_vector:vector=[0,1,0] count_u:integer=24 count_v:integer=24",
    "points:point u:number v:number",
  ],
  [
    "boost",
    "Boost",
    "transforms",
    "Bends a shape towards the orbits of a generator.",
    "Boosted Surfaces, eqs. 2, 5",
    `shape!:${ANY} generator!:generator amount:number=1 rule:choice="exact"`,
    `shape:${ANY}@shape`,
  ],
  [
    "twist",
    "Twist",
    "transforms",
    "Turns a shape about a line while sliding it along.",
    "Boosted Surfaces, eq. 11",
    `shape!:${ANY} axis!:circle angle:number=0:deg slide:number=0:m`,
    `shape:${ANY}@shape`,
  ],
  [
    "hopf",
    "Hopf fiber",
    "transforms",
    "The linked circle that belongs to an amount.",
    "Boosted Surfaces, eqs. 9-12",
    'circle!:circle amount:number=0 method:choice="paper"',
    "circle:circle",
  ],
  [
    "interpolate",
    "Interpolate",
    "generators",
    "Blends two or four generators.",
    "Boosted Surfaces, eq. 15",
    "a!:generator b!:generator c:generator d:generator u:number=0 v:number=0",
    "generator:generator",
  ],
  [
    "list",
    "List",
    "numbers",
    "Values put together along one axis.",
    "",
    "items*:generator axis:text",
    "items:generator",
  ],
  [
    "sphere_mesh",
    "Sphere mesh",
    "meshes",
    "A sphere as a mesh.",
    "",
    "center:point=[0,0,0] radius:number=1:m segments:integer=64",
    "mesh:mesh",
  ],
  [
    "warp",
    "Warp",
    "fields",
    "Moves a shape by a weighted sum of generators.",
    "Boosted Surfaces, eqs. 13, 16",
    `shape!:${ANY} generators*!:generator strength:number=1 power:number=2 softening:number=0 rule:choice="exact" method:choice="sum_generators"`,
    `shape:${ANY}@shape`,
  ],
  [
    "tube",
    "Tube",
    "surfaces",
    "A tube around curves.",
    "",
    "shape!:circle radius:number=0.02:m segments:integer=96 sides:integer=12",
    "mesh:mesh",
  ],
  [
    "surface",
    "Surface",
    "surfaces",
    "The surface swept by circles, or by points over two axes.",
    "",
    'shape!:circle|point segments:integer=96 at_infinity:choice="clip" clip_radius:number=100:m',
    "mesh:mesh",
  ],
  ["color", "Color", "meshes", "Gives a mesh a color.", "", 'mesh!:mesh color:color="#7f9df0"', "mesh:mesh"],
  [
    "export",
    "Export",
    "answers",
    "A glTF file of models.",
    "",
    "model*!:mesh|point|circle position_bits:integer=14 normal_bits:integer=10 speed:integer=7 normals:boolean=true",
    "asset:asset",
  ],
];

function readPort(text) {
  const [, name, marks, types, rest] = /^(\w+)([*!]*):([\w|]+)(.*)$/.exec(text);
  const [, literal, unit] = /^=(.*?)(?::(\w+))?$/.exec(rest) ?? [];
  const [, sameAs] = /^@(\w+)$/.exec(rest) ?? [];
  return { name, types: types.split("|"), marks, literal, unit: unit ?? "", sameAs };
}

export const catalogue = {
  engine: "0.0.0-stand-in",
  types: TYPES.map(([name, family, color, shape]) => ({
    name,
    family,
    color,
    shape,
    doc: `A ${name}.`,
    literal_only: family === "number" && name !== "number",
  })),
  families: [
    "numbers",
    "elements",
    "generators",
    "transforms",
    "fields",
    "sampling",
    "surfaces",
    "meshes",
    "answers",
  ].map((name) => ({
    name,
    title: name[0].toUpperCase() + name.slice(1),
  })),
  nodes: CARDS.map(([id, title, family, doc, source, inputs, outputs]) => ({
    id,
    title,
    family,
    doc,
    source,
    version: 1,
    inputs: inputs
      .split(" ")
      .map(readPort)
      .map(({ name, types, marks, literal, unit }) => ({
        name,
        types,
        doc: "",
        required: marks.includes("!"),
        several: marks.includes("*"),
        ...(literal === undefined ? {} : { default: JSON.parse(literal) }),
        unit,
      })),
    outputs: outputs
      .split(" ")
      .map(readPort)
      .map(({ name, types, sameAs }) => ({ name, types, doc: "", ...(sameAs ? { same_as: sameAs } : {}) })),
  })),
};
