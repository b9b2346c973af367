#import kernel/change

// What a field surely is ahead of a point, along a ray. Twin of src/skeleton/ahead.ts and src/field/rayAhead.ts, without the bounds that hold
// anywhere (src/kernel/smooth.ts) and the balls that know of no surface (src/field/rayBalls.ts): shorter steps, and a surface is never passed.

// How far the value keeps its sign, how fast it changes at most, and as far as both hold; mm along the ray.
struct Sight {
  clear: f32,
  slope: f32,
  known: f32,
}

// Σ|F|/M², least M, bound on second derivatives, n of (core + r²)^(−n/2)
struct Ahead {
  loose: f32,
  width: f32,
  bend: f32,
  power: f32,
}

// θ up to which the bound is used
const MOST_THETA = 0.9;
const LEAST_THETA = 1e-3;
// how often the distance is bettered
const BETTERINGS = 2u;

// what value and slope leave out over t, for each square mm of it
fn looseness(ahead: Ahead, t: f32) -> f32 {
  if (ahead.loose == 0.0) {
    return 0.5 * ahead.bend;
  }
  return 0.5 * ahead.bend + ahead.loose * change_over_square(t / ahead.width, ahead.power);
}

// ((1 − θ)⁻ⁿ − 1 − nθ)/θ²
fn change_over_square(theta: f32, n: f32) -> f32 {
  if (n == 4.0) {
    // what is left when 1 + 4θ is multiplied out
    let left = 1.0 - theta;
    let square = left * left;
    return (10.0 - theta * (20.0 - theta * (15.0 - 4.0 * theta))) / (square * square);
  }
  let at = max(theta, LEAST_THETA);
  return power_rest(at, n, 2u) / (at * at);
}

// `curve`: half the second derivative of what is known exactly
fn sight_of(value: f32, slope: f32, curve: f32, ahead: Ahead, reach: f32) -> Sight {
  let known = min(reach, MOST_THETA * ahead.width);
  let depth = abs(value);
  let way = select(1.0, -1.0, value > 0.0);
  var high = known;
  let most = looseness(ahead, high);
  var low = min(ray_root(depth, way * slope, way * curve + most), high);
  for (var i = 0u; i < BETTERINGS && low < high; i++) {
    let middle = sqrt(low * high);
    let reached = ray_root(depth, way * slope, way * curve + looseness(ahead, middle));
    if (reached >= middle) {
      low = middle;
    } else {
      high = middle;
      low = max(low, reached);
    }
  }
  return Sight(low, abs(slope) + (abs(curve) + most) * 2.0 * known, known);
}

// The least t > 0 with slope t + bend t² = depth, which is reached nowhere before.
fn ray_root(depth: f32, slope: f32, bend: f32) -> f32 {
  let under = slope * slope + 4.0 * bend * depth;
  let sum = slope + sqrt(max(under, 0.0));
  return select(1e30, 2.0 * depth / sum, under >= 0.0 && sum > 0.0);
}
