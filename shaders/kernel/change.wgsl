#import table/change

// By how much a kernel's field changes within a ball, kernel units. Twin of src/kernel/change.ts, with series in place of differences
// that float32 has no digits for; the margins that rounding takes are put on by who asks (skeleton/spread.wgsl).

const MANY = 1e20;
// r² up to which second derivatives are asked, too, in parts of the core
const BENT_UP_TO = 6.0;

// q^(−n/2) for any q above 0; without branches where n is whole and at most 7
fn half_power(q: f32, n: f32) -> f32 {
  if (HAS_ANY_POWER) {
    return exp(-0.5 * n * log(q));
  }
  let i = 1.0 / q;
  let whole = u32(n);
  let root = select(1.0, sqrt(i), (whole & 1u) == 1u);
  return root * select(1.0, i, (whole & 2u) != 0u) * select(1.0, i * i, (whole & 4u) != 0u);
}

// The least and the most by which the field of points at r or farther is multiplied when the place moves by `by`.
fn power_factors(core: f32, n: f32, r: f32, by: f32) -> vec2f {
  let root = sqrt(by * by + 4.0 * core);
  // where the ratios are extreme, if that is farther than r
  let high = max(r, 0.5 * (root + by));
  let low = max(r, 0.5 * (root - by));
  let near = max(high - by, 0.0);
  let fall = core + low * low;
  let least = half_power((core + (low + by) * (low + by)) / max(fall, 1e-30), n);
  let ratio = (core + near * near) / (core + high * high);
  let most = half_power(max(ratio, 1e-5), n);
  return vec2f(select(0.0, least, fall > 1e-30), select(MANY, most, ratio > 1e-5));
}

// (1 − θ)^−n without the terms of its series before the `first`, which is 2 or 3; θ < 1. What is cut off of the series falls at least
// as fast as its last ratio.
fn power_rest(theta: f32, n: f32, first: u32) -> f32 {
  if (theta > 0.25) {
    let grown = half_power((1.0 - theta) * (1.0 - theta), n);
    let square = select(0.0, 0.5 * n * (n + 1.0) * theta * theta, first == 3u);
    return grown - 1.0 - n * theta - square;
  }
  // from the last of eight on
  let x = vec2f(theta, n * theta);
  let ratio = (x.y + 8.0 * x.x) / 9.0;
  var tail = 1.0 + ratio / (1.0 - ratio);
  tail = 1.0 + (x.y + 7.0 * x.x) / 8.0 * tail;
  tail = 1.0 + (x.y + 6.0 * x.x) / 7.0 * tail;
  tail = 1.0 + (x.y + 5.0 * x.x) / 6.0 * tail;
  tail = 1.0 + (x.y + 4.0 * x.x) / 5.0 * tail;
  tail = 1.0 + (x.y + 3.0 * x.x) / 4.0 * tail;
  let cube = (x.y + 2.0 * x.x) / 3.0 * tail;
  return 0.5 * (x.y + x.x) * x.y * (cube + select(0.0, 1.0, first == 2u));
}

const BENT_PIECES = 4u;

// What value and gradient leave out over a way of `by`, by second derivatives, in parts of the field at r; for r² up to BENT_UP_TO.
fn power_bent(core: f32, n: f32, r: f32, by: f32) -> f32 {
  var sum = 0.0;
  for (var i = 1u; i <= BENT_PIECES; i++) {
    let moved = by * f32(i) / f32(BENT_PIECES);
    let high = max(r, 0.5 * (sqrt(moved * moved + 4.0 * core) + moved));
    let grown = half_power((core + (high - moved) * (high - moved)) / (core + high * high), n);
    let left = max(r - moved, 0.0);
    sum += (f32(BENT_PIECES - i) + 0.5) * grown * power_steepest(core, left * left, n);
  }
  return sum * by * by / f32(BENT_PIECES * BENT_PIECES);
}

// The largest second derivative in any direction at that squared distance or farther, in parts of the kernel there.
fn power_steepest(core: f32, r2: f32, n: f32) -> f32 {
  let across = n / (core + r2);
  if (r2 * (n + 1.0) < core * (n + 3.0)) {
    return max(across, n * (n + 1.0) * (n + 1.0) / (4.0 * (n + 2.0) * core));
  }
  return across * max(1.0, ((n + 1.0) * r2 - core) / (core + r2));
}

// The most that first and second derivatives of the Gaussian come to over what is farther than `near`: of a point, a line, a plane.
fn gaussian_slopes(near: f32, dimension: u32) -> vec2f {
  let r2 = near * near;
  let f = exp(-r2);
  if (dimension == 0u) {
    let slope = select(2.0 * near * f, 0.857763885, r2 < 0.5);
    return vec2f(slope, select((4.0 * r2 - 2.0) * f, max(2.0 * f, 0.892520641), r2 < 1.5));
  }
  if (dimension == 1u) {
    let line = max(r2, 0.420422529);
    let bend = max(r2, 1.0);
    return vec2f(
      sqrt(1.0 + 12.5663706 * line) * exp(-line),
      3.5449077 * max(f, 2.0 * bend * exp(-bend)),
    );
  }
  let line = max(r2, 0.420422529);
  return vec2f(
    sqrt(3.14159265 * (1.0 + 12.5663706 * line)) * exp(-line),
    6.2831853 * max(1.0 + r2, 2.0 * r2) * f,
  );
}

// The same of the quartic.
fn quartic_slopes(near: f32, dimension: u32) -> vec2f {
  let r2 = near * near;
  let g2 = max(1.0 - r2, 0.0);
  if (dimension == 0u) {
    return vec2f(select(4.0 * near * g2, 1.5396007, r2 < 0.33333334), select(0.0, 8.0, g2 > 0.0));
  }
  if (dimension == 1u) {
    let g = sqrt(g2);
    let h = min(g2, 0.777327935);
    let slope = h * sqrt(h * (28.4444444 - 27.4444444 * h));
    return vec2f(slope, select(16.0 * g * r2, max(5.33333333 * g2 * g, 6.1584029), r2 < 0.66666667));
  }
  let h = min(g2, 0.8237404);
  let slope = h * h * sqrt(39.4784176 * (1.0 - h) + 1.13777778 * h);
  return vec2f(slope, 6.2831853 * select(4.0 * r2 * g2, 1.0, r2 < 0.5));
}
