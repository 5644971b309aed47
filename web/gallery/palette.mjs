// The few colors that stand best for all of a picture: median cut.

/**
 * `most` colors or fewer for RGB `pixels`, three bytes each in rows of `width`, and for each pixel the index of its own.
 * One that covers much of the picture, as the ground does, keeps its exact value.
 */
export function paletteOf(pixels, width, most) {
  const counts = new Map();
  for (let at = 0; at < pixels.length; at += 3) {
    const color = pixels.readUIntBE(at, 3);
    counts.set(color, (counts.get(color) ?? 0) + 1);
  }
  const all = [...counts].map(([color, count]) => ({ parts: [color >> 16, (color >> 8) & 255, color & 255], count }));
  const boxes = [boxOf(all)];
  while (boxes.length < most) {
    const widest = boxes.reduce((best, box, at) => (box.spread > boxes[best].spread ? at : best), 0);
    if (boxes[widest].spread === 0) break;
    boxes.splice(widest, 1, ...halves(boxes[widest]));
  }
  const palette = boxes.map(({ mean }) => mean.map(Math.round));
  return { palette: Buffer.from(palette.flat()), indexes: diffused(pixels, width, palette) };
}

/** The index of the color for each pixel; what it lacks is made up by its neighbors (after Floyd and Steinberg). */
function diffused(pixels, width, palette) {
  const wanted = Float32Array.from(pixels);
  const indexes = Buffer.alloc(pixels.length / 3);
  const spread = [
    [1, 7 / 16],
    [width - 1, 3 / 16],
    [width, 5 / 16],
    [width + 1, 1 / 16],
  ];
  for (let at = 0; at < indexes.length; at++) {
    indexes[at] = nearest(palette, wanted, 3 * at);
    for (let part = 0; part < 3; part++) {
      const lack = wanted[3 * at + part] - palette[indexes[at]][part];
      for (const [step, share] of spread) wanted[3 * (at + step) + part] += share * lack;
    }
  }
  return indexes;
}

function nearest(palette, wanted, at) {
  let [best, least] = [0, Infinity];
  palette.forEach(([red, green, blue], index) => {
    const distance = (wanted[at] - red) ** 2 + (wanted[at + 1] - green) ** 2 + (wanted[at + 2] - blue) ** 2;
    if (distance < least) [best, least] = [index, distance];
  });
  return best;
}

/** Some colors with their mean, and the part and the amount in which they differ most. */
function boxOf(colors) {
  const total = colors.reduce((sum, { count }) => sum + count, 0);
  const mean = [0, 1, 2].map((part) => colors.reduce((sum, { parts, count }) => sum + parts[part] * count, 0) / total);
  const spreads = mean.map((middle, part) =>
    colors.reduce((sum, { parts, count }) => sum + count * (parts[part] - middle) ** 2, 0),
  );
  const spread = Math.max(...spreads);
  return { colors, mean, spread: colors.length > 1 ? spread : 0, part: spreads.indexOf(spread) };
}

function halves({ colors, mean, part }) {
  const low = colors.filter(({ parts }) => parts[part] <= mean[part]);
  const high = colors.filter(({ parts }) => parts[part] > mean[part]);
  return [boxOf(low), boxOf(high)];
}
