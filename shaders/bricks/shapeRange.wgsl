#import shape
#import table/shapes

// A shape within a ball. Distances change by no more than the radius; convex ones are nowhere above what their gradient says. Twin of
// src/shape/shape.ts.

// of the coordinates and terms that a value is made of
const SHAPE_ROUNDING = 2e-6;

// `slope`: how far the value may rise in the cube by its gradient
fn distance_range(shape: Shape, value: f32, q: vec3f, radius: f32, slope: f32) -> vec2f {
  let margin = SHAPE_ROUNDING * (dot(abs(q), vec3f(1.0)) + radius + abs(value));
  let by = radius + margin;
  if (shape_is_convex(shape.kind)) {
    return vec2f(value - by, value + min(by, slope + margin));
  }
  return vec2f(value - by, value + by);
}
