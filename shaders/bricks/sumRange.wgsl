#import bricks/level
#import bricks/ball
#import bricks/outer
#import field/unseen
#import field/warped
#import record/leaf
#import skeleton
#import skeleton/spread
#import table/sizes

// A sum of skels as it is within a cube: which terms are added up in a polynomial, least missed first as long as the budget lasts, which
// stay, and what all may be there. Twin of src/field/nearSum.ts, which halves a cut until what is below it fits; here what is missed falls
// into bins of a third of an octave, and the cut is between two of them.
//
// A thread is a cube, and nothing waits. Tried: a group of 32 threads a cube, for whose barriers SwiftShader takes 0.3 ms a cube.

const BINS = 36u;
const BINS_AN_OCTAVE = 3.0;
// in place of a bin: nothing is missed, or too much
const NOTHING = 0u;
const TOO_MUCH = 63u;

// Of each term in the list of the cube around, in half a word: its bin from 1 on, and 64 times the sources that stand for it.
var<private> choices: array<u32, MOST_CHOICES>;
// of each sum: its entry without the numbers, and the list that its choices are of: where, how many, the first of them, the bins of those
// that stay
var<private> entries: array<vec4u, 5u * MOST_SUMS>;
var<private> origins: array<vec4u, MOST_SUMS>;

struct SumRange {
  low: f32,
  high: f32,
  error: f32,
}

fn sum_range(sum: Sum, leaf: Leaf, list: Outer, ball: Ball, allowed: f32, place: u32, first: u32) -> SumRange {
  // what large cells may miss is shared among levels, too
  let budget = min(allowed * leaf.slope, leaf.most / f32(level.size)) - list.error;
  let spent = choose(sum, leaf, list, ball, budget, first);
  let cut = spent.bin;
  var far = shifted_taylor(list.far, ball.centre - list.centre);
  let before = far.constant;
  var colour = list.colour;
  var near = Spread(vec4f(0.0), 0.0, 0.0, 0.0);
  var stay = 0u;
  for (var i = 0u; i < list.count; i++) {
    let choice = choice_at(first + i);
    let number = outer_term(list.at, i);
    let term = load_term(sum.first + number * TERM_STRIDE);
    let bound = load_bound(leaf.bounds + number * BOUND_STRIDE);
    let seen = seen_from(bound, term, ball.centre, ball.radius);
    let is_added = choice % 64u < cut;
    var field = vec4f(0.0);
    // loops of one round: software adapters walk through branches that nobody takes, but not through such loops
    for (var is_asked = !is_added || stands_for_itself(bound); is_asked; is_asked = false) {
      let own = skel_field(term.primitive, term.kernel, term.skel, seen.place);
      field = clamp(term.factor * own, vec4f(-HUGE), vec4f(HUGE));
    }
    for (var is_far = is_added; is_far; is_far = false) {
      let one = seen_taylor(term, seen, stand_in_taylor(bound, term, choice / 64u, seen.place, field));
      far.constant += one.constant;
      far.linear += one.linear;
      far.squares += one.squares;
      far.mixed += one.mixed;
      colour += max(one.constant - UNSEEN * sum.threshold, 0.0) * vec4f(term.colour, 1.0);
    }
    for (var is_near = !is_added; is_near; is_near = false) {
      let local = term_spread(bound, look_at(bound, term, seen.place, seen.reach), field);
      let spread = seen_spread(term, seen, local);
      near.centre += spread.centre;
      near.rest += spread.rest;
      near.low += spread.low;
      near.high += spread.high;
      stay++;
    }
  }
  let moved = dot(abs(list.far.linear), abs(ball.centre - list.centre));
  let rounding = ROUNDING * (sum.threshold + abs(before) + abs(far.constant) + moved);
  let error = list.error + spent.missed * SAFE + rounding;
  keep_entry(place, far, ball.centre, error, stay, colour);
  origins[place] = vec4u(list.at, list.count, first, cut);
  return closed_range(far, near, error, ball);
}

// Terms in bins below are far, and miss so much.
struct Spent {
  bin: u32,
  missed: f32,
}

fn choose(sum: Sum, leaf: Leaf, list: Outer, ball: Ball, budget: f32, first: u32) -> Spent {
  // what is missed, by its size, in parts of the budget
  var bins: array<f32, BINS>;
  for (var i = 0u; i < list.count; i++) {
    let number = outer_term(list.at, i);
    let term = load_term(sum.first + number * TERM_STRIDE);
    let bound = load_bound(leaf.bounds + number * BOUND_STRIDE);
    let seen = seen_from(bound, term, ball.centre, ball.radius);
    let found = seen_stand_in(bound, look_at(bound, term, seen.place, seen.reach), seen, budget);
    let share = found.missed / budget;
    var choice = select(TOO_MUCH, NOTHING, found.missed == 0.0);
    if (budget > 0.0 && found.missed > 0.0 && found.missed <= budget) {
      let bin = bin_of(share);
      bins[bin] += share;
      choice = bin + 1u;
    }
    choose_at(first + i, choice + 64u * found.count);
  }
  var spent = Spent(1u, 0.0);
  for (; spent.bin <= BINS; spent.bin++) {
    let more = bins[spent.bin - 1u];
    if (spent.missed + more > 1.0) {
      break;
    }
    spent.missed += more;
  }
  spent.missed *= max(budget, 0.0);
  return spent;
}

fn choice_at(i: u32) -> u32 {
  return extractBits(choices[i / 2u], 16u * (i % 2u), 16u);
}

fn choose_at(i: u32, choice: u32) {
  choices[i / 2u] = insertBits(choices[i / 2u], choice, 16u * (i % 2u), 16u);
}

fn bin_of(share: f32) -> u32 {
  return u32(clamp(f32(BINS) + floor(BINS_AN_OCTAVE * log2(max(share, 1e-20))), 0.0, f32(BINS - 1u)));
}

fn keep_entry(sum: u32, far: Taylor, centre: vec3f, error: f32, count: u32, colour: vec4f) {
  let at = 5u * sum;
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
