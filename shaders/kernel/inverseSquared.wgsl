#import kernel/evenMoments
#import kernel/powerEdge

// f = 1/r²; over a polygon a dilogarithm, hence quadrature.

fn inverse_squared_value(r2: f32, exponent: f32) -> vec2f {
  return inverse_power_value(r2, 2.0);
}

fn inverse_squared_line(f: LineFrame) -> vec3f {
  let m2 = floored(f);
  if (is_far(f, m2)) {
    return inverse_power_far(f, m2, 2.0);
  }
  let e = ends_of(f, m2);
  let first = even_1(e);
  return from_moments(f, e, 2.0, first, -even_2(e, first));
}

fn inverse_squared_edge(f: EdgeFrame) -> vec3f {
  return power_edge_quadrature(f, max(f.z * f.z, f.floor2), 2.0);
}
