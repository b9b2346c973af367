#import field/smoothUnion
#import operation
#import program
#import record/step
#import table/numbers

// What a tree may be within a cube, from its leaves on: twin of src/field/nearSet.ts, two operands at a time. Sums that cannot matter
// under a hard union are noted, one bit each.

// beyond it smooth unions of many bodies stay
const MOST = 1e30;
// of values
const RANGE_ROUNDING = 1e-6;

struct Range {
  low: f32,
  high: f32,
  error: f32,
  // sums from here on
  first: u32,
  // whether it may be left out as a whole: a blend whose parts are far away may be larger than it was
  is_free: bool,
}

var<private> dropped_low: u32;
var<private> dropped_high: u32;
// sums that count inside out in the result so far
var<private> flipped: u32;

// `met`: sums so far
fn joined_range(step: Step, early: Range, late: Range, met: u32) -> Range {
  let is_swapped = step.swapped == 1u;
  var a = late;
  var b = early;
  if (!is_swapped) {
    a = early;
    b = late;
  }
  let early_sums = sums_between(early.first, late.first);
  let late_sums = sums_between(late.first, met);
  let a_sums = select(early_sums, late_sums, is_swapped);
  let b_sums = select(late_sums, early_sums, is_swapped);
  let x = turned_range(a, step.outer);
  let y = turned_range(b, step.sign);
  var error = stretch_of(step) * (a.error + b.error);
  if (step.operation == HARD_UNION) {
    error = max(a.error, b.error);
    if (y.y < x.x && b.is_free) {
      drop_sums(b_sums, step.sign < 0.0);
      error = a.error;
    } else if (x.y < y.x && a.is_free) {
      drop_sums(a_sums, step.outer < 0.0);
      error = b.error;
    }
  }
  if (step.outer * step.sign < 0.0) {
    flipped ^= b_sums;
  }
  let united = step.outer * operation_range(step, x, y);
  let ends = select(united, united.yx, step.outer < 0.0);
  let low = clamp(ends.x - RANGE_ROUNDING * abs(ends.x), -MOST, MOST);
  let high = clamp(ends.y + RANGE_ROUNDING * abs(ends.y), -MOST, MOST);
  let is_free = a.is_free && b.is_free && !(step.operation == BLEND_UNION && step.amounts.x < 0.0);
  return Range(low, high, error, early.first, is_free);
}

fn turned_range(range: Range, sign: f32) -> vec2f {
  return select(vec2f(range.low, range.high), vec2f(-range.high, -range.low), sign < 0.0);
}

fn sums_between(first: u32, end: u32) -> u32 {
  return extractBits(0xffffffffu, 0u, end) & ~extractBits(0xffffffffu, 0u, first);
}

fn drop_sums(sums: u32, is_high: bool) {
  let own = sums & ~(dropped_low | dropped_high);
  let upside_down = own & flipped;
  dropped_low |= select(own & ~flipped, upside_down, is_high);
  dropped_high |= select(upside_down, own & ~flipped, is_high);
}

// by which errors of the operands may grow
fn stretch_of(step: Step) -> f32 {
  if (step.operation == BLEND_UNION) {
    return 2.0 + 0.65 * abs(step.amounts.x) / min(step.amounts.y, step.amounts.z);
  }
  return select(1.0, 2.0, step.operation == SMOOTH_UNION);
}

// What rises with both operands has the values of both ends; the bump of a blend does not.
fn operation_range(step: Step, a: vec2f, b: vec2f) -> vec2f {
  let is_blend = step.operation == BLEND_UNION;
  var ends: vec2f;
  if (is_blend) {
    ends = vec2f(smooth_union(a.x, b.x).x, smooth_union(a.y, b.y).x);
  } else {
    ends.x = operation(step.operation, a.x, b.x, step.amounts).x;
    ends.y = operation(step.operation, a.y, b.y, step.amounts).x;
    return ends;
  }
  let near = max(max(vec2f(a.x, b.x), -vec2f(a.y, b.y)), vec2f(0.0));
  let far = max(-vec2f(a.x, b.x), vec2f(a.y, b.y));
  let bumps = vec2f(bump_at(step.amounts, near), bump_at(step.amounts, far));
  let margin = RANGE_ROUNDING * (abs(step.amounts.x) + abs(ends.x) + abs(ends.y));
  return ends + vec2f(min(bumps.x, bumps.y) - margin, max(bumps.x, bumps.y) + margin);
}

fn bump_at(amounts: vec3f, distances: vec2f) -> f32 {
  let u = min(distances / amounts.yz, vec2f(1e18));
  return amounts.x / (1.0 + dot(u, u));
}
