#import field/smoothUnion

// The smooth union plus a0 / (1 + (a/a1)² + (b/a2)²): value, ∂/∂a, ∂/∂b. Twin of src/field/blendUnion.ts.

fn blend_union(a: f32, b: f32, a0: f32, a1: f32, a2: f32) -> vec3f {
  let reach = vec2f(a1, a2);
  // beyond it the squares overflow and nothing is left of the bump
  let u = clamp(vec2f(a, b) / reach, vec2f(-1e18), vec2f(1e18));
  let depth = 1.0 + dot(u, u);
  let bump = a0 / depth;
  return smooth_union(a, b) + vec3f(bump, (-2.0 * bump / depth) * u / reach);
}
