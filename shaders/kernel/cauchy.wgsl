#import kernel/evenEdge

// f = 1/(1 + r²)², r in units of 1/s: Jin & Tai (7); polygons: Zhu (16)
// without its singular terms.

fn cauchy_value(r2: f32, exponent: f32) -> vec2f {
  return inverse_power_value(1.0 + r2, 4.0);
}

fn cauchy_line(f: LineFrame) -> vec3f {
  let m2 = 1.0 + f.rho2;
  if (is_far(f, m2)) {
    return inverse_power_far(f, m2, 4.0);
  }
  let e = ends_of(f, m2);
  let second = even_2(e, even_1(e));
  return from_moments(f, e, 4.0, second, -2.0 * even_3(e, second));
}

fn cauchy_edge(f: EdgeFrame) -> vec3f {
  return even_edge(f, 1.0 + f.z * f.z, 4.0);
}
