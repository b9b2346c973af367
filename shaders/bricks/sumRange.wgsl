#import bricks/outer
#import field/unseen
#import record/leaf
#import skeleton/spread

// A sum of skels as it is within a cube: which terms are added up in a polynomial, least missed first as long as the budget lasts, which
// stay, and what all may be there. A group of threads goes through the terms. Twin of src/field/nearSum.ts, which sorts by halving a
// cut; here what is missed falls into bins of a third of an octave, and the cut is between two of them.

const WIDTH = 32u;
const BINS = 48u;
const BINS_AN_OCTAVE = 3.0;
// the budget in units that integers count
const UNITS = 65536.0;
const PARTS = 6u;

const MOST_SUMS = 32u;
// of 32 terms each, of all sums
const MOST_MASKS = 1024u;

// what is missed, by its size
var<workgroup> bins: array<atomic<u32>, BINS>;
// terms that stay, by their place in the list of the cube around
var<workgroup> masks: array<atomic<u32>, MOST_MASKS>;
// what each thread adds up
var<workgroup> parts: array<vec4f, PARTS * WIDTH>;
var<workgroup> totals: array<vec4f, PARTS>;
// of each sum: its entry without the numbers, and the list that its masks are of: where, how many, the first mask
var<workgroup> entries: array<vec4u, 5u * MOST_SUMS>;
var<workgroup> origins: array<vec4u, MOST_SUMS>;

// A cube as the leaf sees it.
struct Ball {
  centre: vec3f,
  // around the cube
  radius: f32,
  // by how much places are off
  off: f32,
  // half edge of the cube, in the world
  half: f32,
  is_moved: bool,
  // gradients are turned into the world by it
  inverse: mat3x3f,
}

struct SumRange {
  low: f32,
  high: f32,
  error: f32,
}

// What threads add up.
struct Part {
  far: Taylor,
  error: f32,
  colour: vec4f,
  near: Spread,
  count: f32,
}

// To be called by all threads.
fn sum_range(
  sum: Sum,
  leaf: Leaf,
  list: Outer,
  ball: Ball,
  allowed: f32,
  number: u32,
  first_mask: u32,
  thread: u32,
) -> SumRange {
  let budget = min(allowed * leaf.slope, leaf.most) - list.error;
  var first = StandIn(0.0, 0u);
  for (var i = thread; i < list.count; i += WIDTH) {
    let term_number = outer_term(list.at, i);
    let term = load_term(sum.first + term_number * TERM_STRIDE);
    let bound = load_bound(leaf.bounds + term_number * BOUND_STRIDE);
    let found = stand_in(bound, look_at(bound, term, ball.centre, ball.radius), budget);
    if (i == thread) {
      first = found;
    }
    if (found.missed > 0.0 && found.missed <= budget) {
      let share = found.missed / budget;
      atomicAdd(&bins[bin_of(share)], u32(ceil(share * UNITS)));
    }
  }
  workgroupBarrier();
  let cut = cut_bin();
  var part: Part;
  for (var i = thread; i < list.count; i += WIDTH) {
    let term_number = outer_term(list.at, i);
    let term = load_term(sum.first + term_number * TERM_STRIDE);
    let bound = load_bound(leaf.bounds + term_number * BOUND_STRIDE);
    let look = look_at(bound, term, ball.centre, ball.radius);
    var found = first;
    if (i != thread) {
      found = stand_in(bound, look, budget);
    }
    let is_far = found.missed <= budget && bin_of(found.missed / budget) < cut;
    if (is_far || found.missed == 0.0) {
      add_far(&part, bound, term, found, ball.centre, UNSEEN * sum.threshold);
    } else {
      add_near(&part, term_spread(bound, term, look, ball.centre));
      atomicOr(&masks[first_mask + i / WIDTH], 1u << thread);
    }
  }
  put_part(part, thread);
  workgroupBarrier();
  if (thread < PARTS) {
    add_up(thread, min(list.count, WIDTH));
  }
  for (var b = thread; b < BINS; b += WIDTH) {
    atomicStore(&bins[b], 0u);
  }
  workgroupBarrier();
  let total = total_part();
  let shifted = shifted_taylor(list.far, ball.centre - list.centre);
  let far = Taylor(
    shifted.constant + total.far.constant,
    shifted.linear + total.far.linear,
    shifted.squares + total.far.squares,
    shifted.mixed + total.far.mixed,
  );
  let moved = ball.centre - list.centre;
  let shift = dot(abs(list.far.linear), abs(moved));
  let rounding = ROUNDING * (sum.threshold + abs(far.constant) + shift);
  let error = list.error + total.error * SAFE + rounding;
  if (thread == 0u) {
    keep_entry(number, far, ball.centre, error, u32(total.count), list.colour + total.colour);
    origins[number] = vec4u(list.at, list.count, first_mask, u32(total.count));
  }
  return closed_range(far, total.near, error, ball);
}

fn bin_of(share: f32) -> u32 {
  return u32(clamp(f32(BINS) + floor(BINS_AN_OCTAVE * log2(max(share, 1e-20))), 0.0, f32(BINS - 1u)));
}

// the first bin that the budget has nothing left for
fn cut_bin() -> u32 {
  var sum = 0u;
  for (var b = 0u; b < BINS; b++) {
    sum += atomicLoad(&bins[b]);
    if (sum > u32(UNITS)) {
      return b;
    }
  }
  return BINS;
}

fn add_far(part: ptr<function, Part>, bound: Bound, term: Term, found: StandIn, p: vec3f, unseen: f32) {
  let one = stand_in_taylor(bound, term, found.count, p);
  (*part).far.constant += one.constant;
  (*part).far.linear += one.linear;
  (*part).far.squares += one.squares;
  (*part).far.mixed += one.mixed;
  (*part).error += found.missed;
  let seen = max(one.constant - unseen, 0.0);
  (*part).colour += seen * vec4f(term.colour, 1.0);
}

fn add_near(part: ptr<function, Part>, spread: Spread) {
  (*part).near.centre += spread.centre;
  (*part).near.rest += spread.rest;
  (*part).near.low += spread.low;
  (*part).near.high += spread.high;
  (*part).count += 1.0;
}

fn put_part(part: Part, thread: u32) {
  parts[thread] = vec4f(part.far.linear, part.far.constant);
  parts[WIDTH + thread] = vec4f(part.far.squares, part.error);
  parts[2u * WIDTH + thread] = vec4f(part.far.mixed, part.count);
  parts[3u * WIDTH + thread] = part.colour;
  parts[4u * WIDTH + thread] = part.near.centre;
  parts[5u * WIDTH + thread] = vec4f(part.near.rest, part.near.low, part.near.high, 0.0);
}

fn add_up(number: u32, count: u32) {
  var sum = vec4f(0.0);
  for (var i = 0u; i < count; i++) {
    sum += parts[number * WIDTH + i];
  }
  totals[number] = sum;
}

fn total_part() -> Part {
  let far = Taylor(totals[0].w, totals[0].xyz, totals[1].xyz, totals[2].xyz);
  let near = Spread(totals[4], totals[5].x, totals[5].y, totals[5].z);
  return Part(far, totals[1].w, totals[3], near, totals[2].w);
}

fn keep_entry(number: u32, far: Taylor, centre: vec3f, error: f32, count: u32, colour: vec4f) {
  let at = 5u * number;
  entries[at] = vec4u(LISTED, bitcast<u32>(error), count, bitcast<u32>(far.constant));
  entries[at + 1u] = bitcast<vec4u>(vec4f(centre, colour.w));
  entries[at + 2u] = bitcast<vec4u>(vec4f(far.linear, colour.x));
  entries[at + 3u] = bitcast<vec4u>(vec4f(far.squares, colour.y));
  entries[at + 4u] = bitcast<vec4u>(vec4f(far.mixed, colour.z));
}

// Of all together in the cube: the interval, and the centred form, whose gradient counts by its parts along the edges.
fn closed_range(far: Taylor, near: Spread, error: f32, ball: Ball) -> SumRange {
  let reach = select(ball.half, ball.radius, ball.is_moved);
  let bent = reach * reach * (dot(abs(far.squares), vec3f(1.0)) + dot(abs(far.mixed), vec3f(1.0)));
  let swing = reach * dot(abs(far.linear), vec3f(1.0)) + bent;
  let margin = error + ROUNDING * (swing + abs(near.centre.x));
  let middle = near.centre.x + far.constant;
  let local = near.centre.yzw + far.linear;
  let rest = near.rest + bent + margin + 2.0 * ball.off * dot(abs(local), vec3f(1.0));
  let gradient = select(local, local * ball.inverse, ball.is_moved);
  let by = (ball.half * dot(abs(gradient), vec3f(1.0)) + rest) * SAFE;
  return SumRange(
    max(near.low + far.constant - swing - margin, middle - by),
    min(near.high + far.constant + swing + margin, middle + by),
    error,
  );
}
