// g / sqrt(|grad g|² + k |g|), g = squares·p² + products·(yz, zx, xy) + linear·p + constant. Twin of src/shape/quadric.ts.

fn quadric_field(p: vec3f, squares: vec3f, products: vec3f, linear: vec3f, constant: f32) -> vec4f {
  let slope = quadric_bend(p, squares, products) + linear;
  let g = 0.5 * dot(p, slope + linear) + constant;
  let k = sqrt(dot(squares, squares) + 0.5 * dot(products, products));
  let d = dot(slope, slope) + k * abs(g);
  if (d <= 0.0) {
    return vec4f(0.0);
  }
  let inverse = inverseSqrt(d);
  let share = g * inverse * inverse;
  let own = 1.0 - 0.5 * k * abs(share);
  return vec4f(g * inverse, inverse * (own * slope - share * quadric_bend(slope, squares, products)));
}

// the second derivatives of g times v
fn quadric_bend(v: vec3f, squares: vec3f, products: vec3f) -> vec3f {
  return 2.0 * squares * v + products.zxy * v.yzx + products.yzx * v.zxy;
}
