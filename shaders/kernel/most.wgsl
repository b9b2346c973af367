#import kernel/change
#import lib/log
#import record/bound
#import table/change

// The largest field that a skel can have at a distance, of weight 1, kernel units. Twin of src/kernel/most.ts.

// in place of what float32 has no numbers for
const HUGE = 1e30;

fn kernel_at(bound: Bound, r2: f32) -> f32 {
  if (HAS_GAUSSIAN && bound.change == CHANGE_GAUSSIAN) {
    return exp(-r2);
  }
  if (HAS_QUARTIC && bound.change == CHANGE_QUARTIC) {
    let g2 = max(1.0 - r2, 0.0);
    return g2 * g2;
  }
  return min(half_power(max(bound.core + r2, 1e-30), bound.power), HUGE);
}

// of a line without ends
fn whole_line(bound: Bound, r2: f32) -> f32 {
  if (HAS_GAUSSIAN && bound.change == CHANGE_GAUSSIAN) {
    return 1.77245386 * exp(-r2);
  }
  if (HAS_QUARTIC && bound.change == CHANGE_QUARTIC) {
    let g2 = max(1.0 - r2, 0.0);
    return 1.06666667 * g2 * g2 * sqrt(g2);
  }
  if (HAS_INVERSE && bound.power == 1.0) {
    // of 1/r that has no limit: 2 asinh(l/2r)
    return 2.0 * arsinh(0.5 * bound.size * inverseSqrt(r2));
  }
  return bound.whole * half_power(bound.core + r2, bound.power - 1.0);
}

// of a plane without ends
fn whole_plane(bound: Bound, r2: f32) -> f32 {
  if (HAS_GAUSSIAN && bound.change == CHANGE_GAUSSIAN) {
    return 3.14159265 * exp(-r2);
  }
  if (HAS_QUARTIC && bound.change == CHANGE_QUARTIC) {
    let g2 = max(1.0 - r2, 0.0);
    return 1.04719755 * g2 * g2 * g2;
  }
  if (bound.power > 2.0) {
    return bound.whole * half_power(bound.core + r2, bound.power - 2.0);
  }
  if (bound.core > 0.0) {
    return HUGE;
  }
  // of 1/r and 1/r² over a disc
  let area = bound.size / bound.turns;
  if (bound.power == 1.0) {
    return 2.0 * area / (sqrt(r2 + area / 3.14159265) + sqrt(r2));
  }
  return 3.14159265 * log_1p(area / (3.14159265 * r2));
}

// with the skel's weight; HUGE where singular kernels are clamped
fn most_at(bound: Bound, distance: f32) -> f32 {
  if (distance < bound.least) {
    return HUGE;
  }
  let r2 = distance * distance;
  var most = bound.size * kernel_at(bound, r2);
  if (HAS_LINES && bound.dimension == 1u) {
    most = min(most, whole_line(bound, r2));
  } else if (HAS_PLATES && bound.dimension == 2u) {
    most = min(most, bound.turns * whole_plane(bound, r2));
  }
  return min(bound.most * most, HUGE);
}
