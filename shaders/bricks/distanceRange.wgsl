#import bricks/ball
#import shape

// A distance within a ball: it changes by no more than the radius, and where the shape is convex it is nowhere above what its gradient
// says. Twin of distanceField and convexField in src/shape/shape.ts.

// of the coordinates and terms that a value is made of
const SHAPE_ROUNDING = 2e-6;

fn distance_range(shape: Shape, ball: Ball, is_convex: bool) -> vec2f {
  let field = shape_field(shape, ball.centre);
  let gradient = select(field.yzw, field.yzw * ball.inverse, ball.is_moved);
  let terms = dot(abs(ball.centre), vec3f(1.0)) + ball.radius + abs(field.x);
  let most = ball.radius + SHAPE_ROUNDING * terms;
  let slope = ball.half * dot(abs(gradient), vec3f(1.0)) + SHAPE_ROUNDING * terms;
  return vec2f(field.x - most, field.x + select(most, min(most, slope), is_convex));
}
