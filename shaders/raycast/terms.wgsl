#import raycast/ahead
#import record/term
#import skeleton/look
#import skeleton/spread
#import table/change

// What a term is ahead of a point. Twin of `ahead` in src/skeleton/spread.ts.

// of widths: nothing bounds them
const FREE = 1e30;

fn add_ahead(ahead: ptr<function, Ahead>, bound: Bound, term: Term, value: f32, p: vec3f, reach: f32) {
  let look = look_at(bound, term, p, reach);
  if (look.is_nothing) {
    return;
  }
  let per2 = bound.per * bound.per;
  if (bound.change == CHANGE_POWER) {
    let m2 = (bound.core + look.r * look.r) / per2;
    var size = abs(value);
    if (bound.sign == 0.0) {
      size = most_at(bound, look.r);
    }
    size += look.slack;
    (*ahead).loose += SAFE * size / m2;
    (*ahead).width = min((*ahead).width, sqrt(m2));
    (*ahead).power = bound.power;
    return;
  }
  var bend = slopes_of(bound, look.near, 0u).y;
  if (bound.dimension > 0u) {
    bend = min(bound.size * bend, bound.turns * slopes_of(bound, look.near, bound.dimension).y);
  }
  (*ahead).bend += SAFE * select(1.0, 2.0, bound.sign == 0.0) * bound.most * per2 * bend;
}
