/** Linear colors of distances: what agrees is light, what is farthest off is red. Apart from what needs three. */
export const DEVIATION_COLORS = [
  [0.72, 0.74, 0.78],
  [0.95, 0.62, 0.08],
  [0.6, 0.02, 0.02],
] as const;
