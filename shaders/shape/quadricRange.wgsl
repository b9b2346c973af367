#import shape/quadric

// What a quadric's value may be within `radius` of p. Twin of `spread` in src/shape/quadric.ts.

// of what values are made of
const QUADRIC_ROUNDING = 1e-5;

fn quadric_range(p: vec3f, radius: f32, squares: vec3f, products: vec3f, linear: vec3f, constant: f32) -> vec2f {
  let slopes = quadric_bend(p, squares, products) + linear;
  let g = 0.5 * dot(p, slopes + linear) + constant;
  let k = sqrt(dot(squares, squares) + 0.5 * dot(products, products));
  let slope = length(slopes);
  let reach = length(p) + radius;
  let rounding = QUADRIC_ROUNDING * (k * reach + length(linear));
  let swing = radius * (slope + k * radius) + rounding * reach + QUADRIC_ROUNDING * abs(constant);
  // 2k bounds the second derivatives; f rises with g, and |f| falls with |∇g|
  let least = max(slope - 2.0 * k * radius - rounding, 0.0);
  let most = slope + 2.0 * k * radius + rounding;
  let low = taubin(g - swing, select(least, most, g - swing > 0.0), k);
  let high = taubin(g + swing, select(most, least, g + swing > 0.0), k);
  return vec2f(low - QUADRIC_ROUNDING * abs(low), high + QUADRIC_ROUNDING * abs(high));
}

// f of g and |∇g|
fn taubin(g: f32, slope: f32, k: f32) -> f32 {
  let d = slope * slope + k * abs(g);
  return select(0.0, g * inverseSqrt(d), d > 0.0);
}
