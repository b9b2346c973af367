#import field/combined
#import operation
#import record/step

// beyond it smooth unions of many bodies stay
const MOST = 1e30;

// Twin of Combined in src/field/combined.ts.
fn joined(step: Step, early: vec4f, late: vec4f, colours: bool) -> vec4f {
  let a = select(early, late, step.swapped == 1u);
  let b = select(late, early, step.swapped == 1u);
  let united = operation(step.operation, step.outer * a.x, step.sign * b.x, step.amounts);
  let value = clamp(step.outer * united.x, -MOST, MOST);
  if (colours) {
    return vec4f(value, mix(a.yzw, b.yzw, share_of_b(united)));
  }
  let field = step.outer * combined(step.outer * a, step.sign * b, united);
  return select(field, vec4f(value, 0.0, 0.0, 0.0), value != field.x);
}
