import assert from "node:assert/strict";
import { test } from "node:test";
import { BufferGeometry, Float32BufferAttribute } from "three";
import { curvatureColors, curvatureRange, estimateCurvature, smoothed } from "../src/view3d/curvature";
import { pointsInward } from "../src/view3d/orientation";

/** A surface over a grid of two parameters, with its normals. */
function surface(at: (u: number, v: number) => { place: number[]; normal: number[] }, size = 40) {
  const [positions, normals, indices]: number[][] = [[], [], []];
  for (let row = 0; row <= size; row++) {
    for (let column = 0; column <= size; column++) {
      const { place, normal } = at(column / size, row / size);
      positions?.push(...place);
      normals?.push(...normal);
      if (row === size || column === size) continue;
      const first = row * (size + 1) + column;
      indices?.push(first, first + 1, first + size + 1, first + 1, first + size + 2, first + size + 1);
    }
  }
  return { positions: positions ?? [], normals: normals ?? [], indices: indices ?? [] };
}

const middle = (values: Float32Array): number => [...values].sort((a, b) => a - b)[values.length >> 1] ?? NaN;

test("a ball of radius 2 has curvatures 1/4 and 1/2", () => {
  const { positions, normals, indices } = surface((u, v) => {
    const [a, b] = [1 + u, 0.8 + v];
    const normal = [Math.cos(a) * Math.sin(b), Math.sin(a) * Math.sin(b), Math.cos(b)];
    return { place: normal.map((x) => 2 * x), normal };
  });
  for (const value of estimateCurvature("gauss", positions, normals, indices)) assert.ok(Math.abs(value - 0.25) < 2e-3);
  for (const value of estimateCurvature("mean", positions, normals, indices)) assert.ok(Math.abs(value - 0.5) < 2e-3);
});

test("a saddle is negative, a cylinder and a plane are flat", () => {
  const saddle = surface((u, v) => {
    const [x, y] = [u - 0.5, v - 0.5];
    const length = Math.hypot(y, x, 1);
    return { place: [x, y, x * y], normal: [-y / length, -x / length, 1 / length] };
  });
  assert.ok(middle(estimateCurvature("gauss", saddle.positions, saddle.normals, saddle.indices)) < -0.5);
  const cylinder = surface((u, v) => {
    const normal = [Math.cos(3 * u), Math.sin(3 * u), 0];
    return { place: [normal[0] ?? 0, normal[1] ?? 0, v], normal };
  });
  assert.ok(
    Math.abs(middle(estimateCurvature("gauss", cylinder.positions, cylinder.normals, cylinder.indices))) < 1e-6,
  );
  assert.ok(
    Math.abs(middle(estimateCurvature("mean", cylinder.positions, cylinder.normals, cylinder.indices)) - 0.5) < 1e-3,
  );
});

test("smoothing takes noise out and leaves what is constant", () => {
  const { positions, indices } = surface((u, v) => ({ place: [u, v, 0], normal: [0, 0, 1] }), 80);
  const constant = smoothed(new Float32Array(positions.length / 3).fill(-1), indices);
  assert.ok(constant.every((value) => Math.abs(value + 1) < 1e-5));
  const noise = new Float32Array(positions.length / 3).map((_, at) => -1 + Math.sin(at * 12.9898) * 0.5);
  const worst = smoothed(noise, indices).reduce((most, value) => Math.max(most, Math.abs(value + 1)), 0);
  assert.ok(worst < 0.12, `${worst}`);
});

test("triangles without area count for nothing", () => {
  const flat = estimateCurvature("gauss", [0, 0, 0, 1, 0, 0, 2, 0, 0], [0, 0, 1, 0, 0, 1, 0, 0, 1], [0, 1, 2, 0, 0, 0]);
  assert.deepEqual([...flat], [0, 0, 0]);
});

test("the palette ends where 95 of 100 values lie, and is white at zero", () => {
  assert.equal(curvatureRange([Array.from({ length: 100 }, (_, at) => (at < 97 ? -1 : 1000))]), 1);
  assert.equal(curvatureRange([]), 1e-6);
  const [negative, zero, positive, wrong] = [-5, 0, 5, NaN].map((value) => [...curvatureColors([value], 1)]);
  assert.ok((negative?.[2] ?? 0) > (negative?.[0] ?? 0), "blue");
  assert.ok((positive?.[0] ?? 0) > (positive?.[2] ?? 0), "orange");
  assert.ok(zero?.every((part) => part === zero[0]) && wrong?.join() === zero.join());
});

test("which side of a surface is outside does not depend on its front", () => {
  const bowl = surface((u, v) => {
    const [a, b] = [6 * u, 0.3 + v];
    const normal = [Math.cos(a) * Math.sin(b), Math.sin(a) * Math.sin(b), Math.cos(b)];
    return { place: normal, normal };
  });
  const geometry = (normals: number[]): BufferGeometry =>
    new BufferGeometry()
      .setAttribute("position", new Float32BufferAttribute(bowl.positions, 3))
      .setAttribute("normal", new Float32BufferAttribute(normals, 3));
  assert.equal(pointsInward([geometry(bowl.normals)]), false);
  assert.equal(pointsInward([geometry(bowl.normals.map((part) => -part))]), true);
  assert.equal(pointsInward([]), false);
});
